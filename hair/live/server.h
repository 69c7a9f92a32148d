// The live server: the page, one stream of events to each page that is open, and the page's commands.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hair/live/guard.h"
#include "hair/live/message_log.h"

namespace hair {

inline constexpr const char* kPageOpened = "opened";

class LiveServer {
 public:
  // Listens on 127.0.0.1; port 0: one that is free. Messages of the log go to pages as they come. `command`
  // gets a page's commands, in threads of the server: "pause"; and kPageOpened for each page that listens.
  // Throws BadInput if the port is taken. The log must outlive the server.
  LiveServer(std::string page, int port, const MessageLog& log,
             std::function<void(const std::string&)> command);
  ~LiveServer();  // close the log before
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  const LiveAddress& address() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
