#include "hair/live/server.h"

#include <atomic>

#include "hair/io/serve/local_server.h"

namespace hair {

namespace {

constexpr auto kHeartbeat = std::chrono::seconds(2);  // the next heartbeat notices a page that is closed
constexpr unsigned kMostStreams = 5;
constexpr std::size_t kMostCommandBytes = 200;

// Letters, digits, and characters of numbers.
bool is_command(const std::string& text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.+- ") == std::string::npos;
}

}  // namespace

class LiveServer::Parts {
 public:
  Parts(std::string page, int port, const MessageLog& log, std::function<void(const std::string&)> command)
      : page_(std::move(page)),
        log_(log),
        command_(std::move(command)),
        server_(port, kMostCommandBytes, [this](const WebRequest& request) { return answer(request); }) {}

  const ServerAddress& address() const { return server_.address(); }

 private:
  WebAnswer answer(const WebRequest& request) {
    if (request.path.empty() && !request.changes) return {200, page_, kHtmlType};
    if (request.path == "events" && !request.changes) return stream();
    if (request.path != "command" || !request.changes) return {404};
    if (!is_command(request.body)) return {400, "no command\n"};
    command_(request.body);
    return {204};
  }

  WebAnswer stream() {
    const auto place = std::make_shared<MessageLog::Place>();
    const bool too_many = ++streams_ > kMostStreams;
    const std::shared_ptr<void> open(nullptr, [this](void*) { --streams_; });
    if (too_many) return {503, "too many pages of this server are open; close one\n"};
    command_(kPageOpened);
    return {200, "", "text/event-stream", [this, place, open]() -> std::optional<std::string> {
              const MessageLog::Message message = log_.next(*place, kHeartbeat);
              if (log_.closed()) return {};
              return message ? "data: " + *message + "\n\n" : ":\n\n";
            }};
  }

  std::string page_;
  const MessageLog& log_;
  std::function<void(const std::string&)> command_;
  std::atomic<unsigned> streams_ = 0;
  LocalServer server_;  // ends first
};

LiveServer::LiveServer(std::string page, int port, const MessageLog& log,
                       std::function<void(const std::string&)> command)
    : parts_(std::make_unique<Parts>(std::move(page), port, log, std::move(command))) {}
LiveServer::~LiveServer() = default;

const ServerAddress& LiveServer::address() const {
  return parts_->address();
}

}  // namespace hair
