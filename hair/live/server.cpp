#include "hair/live/server.h"

#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <thread>

#include "hair/io/files/bad_input.h"

namespace hair {

namespace {

constexpr auto kHeartbeat = std::chrono::seconds(2);  // a page that went away is noticed by the next one
// A browser has six connections to a server, and this one a thread for each stream.
constexpr int kMostStreams = 5, kThreads = 12;
constexpr std::size_t kMostCommandBytes = 200;

// Letters, digits, and what numbers have.
bool is_command(const std::string& text) {
  return !text.empty() && text.size() <= kMostCommandBytes &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.+- ") == std::string::npos;
}

}  // namespace

class LiveServer::Parts {
 public:
  Parts(std::string page, int port, const MessageLog& log, std::function<void(const std::string&)> command)
      : page_(std::move(page)), log_(log), command_(std::move(command)) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_payload_max_length(kMostCommandBytes);
    // The library would share the port with others that ask for it. Streams of a server that has just ended don't hold it.
    server_.set_socket_options([](socket_t listening) {
      const int yes = 1;
      setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      return admit(request, response);
    });
    server_.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page_, "text/html; charset=utf-8");
    });
    server_.Get("/events",
                [this](const httplib::Request&, httplib::Response& response) { stream(response); });
    server_.Post("/command", [this](const httplib::Request& request, httplib::Response& response) {
      if (!is_command(request.body)) {
        refuse(response, 400, "no command");
        return;
      }
      command_(request.body);
      response.status = 204;
    });
    const int bound = port == 0                                 ? server_.bind_to_any_port("127.0.0.1")
                      : server_.bind_to_port("127.0.0.1", port) ? port
                                                                : -1;
    if (bound < 0)
      throw BadInput("port " + std::to_string(port) + " is taken; without --port a free one is found");
    address_ = {"127.0.0.1:" + std::to_string(bound), new_token()};
    listening_ = std::thread([this] { server_.listen_after_bind(); });
  }

  ~Parts() {
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    server_.stop();
    listening_.join();
  }

  const LiveAddress& address() const { return address_; }

 private:
  static void refuse(httplib::Response& response, int status, const std::string& why) {
    response.status = status;
    response.set_content(why + "\n", "text/plain; charset=utf-8");
  }

  httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) const {
    response.set_header("Cache-Control", "no-store");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    const std::string why = refusal({.host = request.get_header_value("Host"),
                                     .token = request.get_param_value("token"),
                                     .has_origin = request.has_header("Origin"),
                                     .changes = request.method != "GET" && request.method != "HEAD",
                                     .origin = request.get_header_value("Origin")},
                                    address_);
    if (why.empty()) return httplib::Server::HandlerResponse::Unhandled;
    refuse(response, 403, why);
    return httplib::Server::HandlerResponse::Handled;
  }

  void stream(httplib::Response& response) {
    if (++streams_ > kMostStreams) {
      --streams_;
      refuse(response, 503, "too many pages of this server are open; close one");
      return;
    }
    command_(kPageOpened);
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, place = MessageLog::Place()](std::size_t, httplib::DataSink& sink) mutable {
          const MessageLog::Message message = log_.next(place, kHeartbeat);
          if (log_.closed()) {
            sink.done();
            return true;
          }
          const std::string text = message ? "data: " + *message + "\n\n" : ":\n\n";
          return sink.write(text.data(), text.size());
        },
        [this](bool) { --streams_; });
  }

  std::string page_;
  const MessageLog& log_;
  std::function<void(const std::string&)> command_;
  LiveAddress address_;
  std::atomic<int> streams_ = 0;
  httplib::Server server_;
  std::thread listening_;
};

LiveServer::LiveServer(std::string page, int port, const MessageLog& log,
                       std::function<void(const std::string&)> command)
    : parts_(std::make_unique<Parts>(std::move(page), port, log, std::move(command))) {}
LiveServer::~LiveServer() = default;

const LiveAddress& LiveServer::address() const {
  return parts_->address();
}

}  // namespace hair
