#include "hair/live/server.h"

#include <microhttpd.h>
#include <netinet/in.h>

#include <algorithm>
#include <atomic>
#include <latch>

#include "hair/io/files/bad_input.h"

namespace hair {

namespace {

constexpr auto kHeartbeat = std::chrono::seconds(2);  // the next heartbeat notices a page that is closed
// Each connection has a thread and this much memory, which bounds a request's head. A browser uses six.
constexpr unsigned kMostStreams = 5, kMostConnections = 64, kMostSilence = 5;  // seconds
constexpr std::size_t kMemory = 16 << 10, kMostCommandBytes = 200;

// Letters, digits, and characters of numbers.
bool is_command(const std::string& text) {
  return !text.empty() && text.size() <= kMostCommandBytes &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.+- ") == std::string::npos;
}

}  // namespace

class LiveServer::Parts {
 public:
  Parts(std::string page, int port, const MessageLog& log, std::function<void(const std::string&)> command)
      : page_(std::move(page)), log_(log), command_(std::move(command)) {
    const sockaddr_in here = {.sin_family = AF_INET,
                              .sin_port = htons(static_cast<in_port_t>(port)),
                              .sin_addr = {htonl(INADDR_LOOPBACK)},
                              .sin_zero = {}};
    server_ = MHD_start_daemon(MHD_USE_AUTO_INTERNAL_THREAD | MHD_USE_THREAD_PER_CONNECTION, 0, nullptr,
                               nullptr, &answer, this, MHD_OPTION_SOCK_ADDR, &here,
                               MHD_OPTION_CONNECTION_LIMIT, kMostConnections,
                               MHD_OPTION_CONNECTION_MEMORY_LIMIT, kMemory, MHD_OPTION_CONNECTION_TIMEOUT,
                               kMostSilence, MHD_OPTION_NOTIFY_COMPLETED, &forget, nullptr, MHD_OPTION_END);
    if (!server_)
      throw BadInput("port " + std::to_string(port) + " is taken; without --port a free one is found");
    const int bound = MHD_get_daemon_info(server_, MHD_DAEMON_INFO_BIND_PORT)->port;
    address_.host = "127.0.0.1:" + std::to_string(bound);
    has_address_.count_down();
  }

  ~Parts() { MHD_stop_daemon(server_); }

  const LiveAddress& address() const { return address_; }

 private:
  // A listening page, and the rest of the last message to it.
  struct Listener {
    Parts& parts;
    MessageLog::Place place = {};
    std::string rest = {};
  };

  static MHD_Result send(MHD_Connection* to, unsigned status, MHD_Response* response, const char* type) {
    MHD_add_response_header(response, "Content-Type", type);
    MHD_add_response_header(response, "Cache-Control", "no-store");
    MHD_add_response_header(response, "Referrer-Policy", "no-referrer");
    MHD_add_response_header(response, "X-Content-Type-Options", "nosniff");
    MHD_add_response_header(response, "Cross-Origin-Resource-Policy", "same-origin");
    const MHD_Result result = MHD_queue_response(to, status, response);
    MHD_destroy_response(response);  // the connection keeps its own reference
    return result;
  }

  static MHD_Result send(MHD_Connection* to, unsigned status, std::string text,
                         const char* type = "text/plain; charset=utf-8") {
    return send(to, status, MHD_create_response_from_buffer(text.size(), text.data(), MHD_RESPMEM_MUST_COPY),
                type);
  }

  // The library calls this with a request's head, then with each piece of its body, and at the body's end.
  static MHD_Result answer(void* self, MHD_Connection* from, const char* path, const char* method,
                           const char*, const char* piece, std::size_t* size, void** request) {
    Parts& parts = *static_cast<Parts*>(self);
    const auto body = static_cast<std::string*>(*request);
    if (!body) return parts.answer_head(from, path, method, request);
    if (*size > 0) {
      body->append(piece, std::min(*size, kMostCommandBytes + 1 - body->size()));
      *size = 0;
      return MHD_YES;
    }
    if (!is_command(*body)) return send(from, body->size() > kMostCommandBytes ? 413 : 400, "no command\n");
    parts.command_(*body);
    return send(from, 204, "");
  }

  static void forget(void*, MHD_Connection*, void** request, MHD_RequestTerminationCode) {
    delete static_cast<std::string*>(*request);
  }

  MHD_Result answer_head(MHD_Connection* from, const std::string& path, const std::string& method,
                         void** request) {
    has_address_.wait();
    const auto value = [&](const char* name, MHD_ValueKind kind = MHD_HEADER_KIND) {
      const char* found = MHD_lookup_connection_value(from, kind, name);
      return found ? std::optional<std::string>(found) : std::nullopt;
    };
    const bool changes = method != "GET" && method != "HEAD";
    const std::string why = refusal({.host = value("Host").value_or(""),
                                     .token = value("token", MHD_GET_ARGUMENT_KIND).value_or(""),
                                     .changes = changes,
                                     .origin = value("Origin")},
                                    address_);
    if (!why.empty()) return send(from, 403, why + "\n");
    if (path == "/" && !changes) return send(from, 200, page_, "text/html; charset=utf-8");
    if (path == "/events" && !changes) return stream(from);
    if (path != "/command" || method != "POST") return send(from, 404, "");
    *request = new std::string;  // its body, for forget()
    return MHD_YES;
  }

  MHD_Result stream(MHD_Connection* to) {
    if (++streams_ > kMostStreams) {
      --streams_;
      return send(to, 503, "too many pages of this server are open; close one\n");
    }
    command_(kPageOpened);
    // A message to a page comes in time, but the whole server may have been stopped for long by Ctrl-Z.
    MHD_set_connection_option(to, MHD_CONNECTION_OPTION_TIMEOUT, 0U);
    const auto next = [](void* self, std::uint64_t, char* piece, std::size_t most) -> ssize_t {
      auto& [parts, place, rest] = *static_cast<Listener*>(self);
      if (rest.empty()) {
        const MessageLog::Message message = parts.log_.next(place, kHeartbeat);
        if (parts.log_.closed()) return MHD_CONTENT_READER_END_OF_STREAM;
        rest = message ? "data: " + *message + "\n\n" : ":\n\n";
      }
      const std::size_t size = rest.copy(piece, most);
      rest.erase(0, size);
      return static_cast<ssize_t>(size);
    };
    const auto end = [](void* self) {
      --static_cast<Listener*>(self)->parts.streams_;
      delete static_cast<Listener*>(self);
    };
    return send(to, 200,
                MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kMemory, next, new Listener{*this}, end),
                "text/event-stream");
  }

  std::string page_;
  const MessageLog& log_;
  std::function<void(const std::string&)> command_;
  LiveAddress address_ = {"", new_token()};
  std::latch has_address_{1};
  std::atomic<unsigned> streams_ = 0;
  MHD_Daemon* server_ = nullptr;
};

LiveServer::LiveServer(std::string page, int port, const MessageLog& log,
                       std::function<void(const std::string&)> command)
    : parts_(std::make_unique<Parts>(std::move(page), port, log, std::move(command))) {}
LiveServer::~LiveServer() = default;

const LiveAddress& LiveServer::address() const {
  return parts_->address();
}

}  // namespace hair
