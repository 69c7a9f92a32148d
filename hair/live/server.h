// The live server: the page, one stream of events to each open page, and the page's commands.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hair/io/serve/guard.h"
#include "hair/live/message_log.h"

namespace hair {

inline constexpr const char* kPageOpened = "opened";

class LiveServer {
 public:
  // Listens on 127.0.0.1; port 0 means any free port. Sends the log's messages to pages as they come. Calls
  // `command` in threads of the server with a page's commands, such as "pause", and with kPageOpened for each
  // page that listens. Throws BadInput if the port is taken. The log must outlive the server.
  LiveServer(std::string page, int port, const MessageLog& log,
             std::function<void(const std::string&)> command);
  ~LiveServer();  // close the log first
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  const ServerAddress& address() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
