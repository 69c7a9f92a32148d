// The live server: the page, one stream of events to each open page, and the page's commands.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "hair/io/serve/local_server.h"
#include "hair/live/message_log.h"

namespace hair {

struct LiveOptions;

inline constexpr const char* kPageOpened = "opened";

class LiveServer {
 public:
  // Listens on 127.0.0.1; port 0 means any free port. Sends the log's messages to pages as they come. Calls
  // `command` in threads of the server with a page's commands, such as "pause", and with kPageOpened for each
  // page that listens. Throws BadInput if the port is taken. The log must outlive the server; close it first.
  LiveServer(const LiveOptions& options, const MessageLog& log,
             std::function<void(const std::string&)> command);

  const ServerAddress& address() const { return server_.address(); }

 private:
  WebAnswer answer(const WebRequest& request);
  WebAnswer stream();

  std::string page_;
  const MessageLog& log_;
  std::function<void(const std::string&)> command_;
  std::atomic<unsigned> streams_ = 0;
  LocalServer server_;  // ends first
};

}  // namespace hair
