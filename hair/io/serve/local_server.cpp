#include "hair/io/serve/local_server.h"

#include <microhttpd.h>
#include <netinet/in.h>

#include <algorithm>
#include <fstream>
#include <latch>
#include <stdexcept>

#include "hair/io/files/bad_input.h"

namespace hair {

namespace {

// Each connection has a thread and this much memory, which bounds a request's head. A browser uses six.
constexpr unsigned kMostConnections = 64, kMostSilence = 5;  // seconds
constexpr std::size_t kMemory = 16 << 10;

MHD_Result send(MHD_Connection* to, unsigned status, MHD_Response* response, const std::string& type) {
  MHD_add_response_header(response, "Content-Type", type.c_str());
  MHD_add_response_header(response, "Cache-Control", "no-store");
  MHD_add_response_header(response, "Referrer-Policy", "no-referrer");
  MHD_add_response_header(response, "X-Content-Type-Options", "nosniff");
  MHD_add_response_header(response, "X-Frame-Options", "DENY");
  MHD_add_response_header(response, "Cross-Origin-Resource-Policy", "same-origin");
  const MHD_Result result = MHD_queue_response(to, status, response);
  MHD_destroy_response(response);  // the connection keeps its own reference
  return result;
}

struct Stream {
  std::function<std::optional<std::string>()> next;
  std::string rest = {};  // the last piece's
};

MHD_Result send(MHD_Connection* to, WebAnswer answer) {
  std::string& text = answer.text;
  if (!answer.stream)
    return send(to, answer.status,
                MHD_create_response_from_buffer(text.size(), text.data(), MHD_RESPMEM_MUST_COPY),
                answer.type);
  // A message to a page comes in time, but the whole server may have been stopped for long by Ctrl-Z.
  MHD_set_connection_option(to, MHD_CONNECTION_OPTION_TIMEOUT, 0U);
  const auto next = [](void* self, std::uint64_t, char* piece, std::size_t most) -> ssize_t {
    Stream& stream = *static_cast<Stream*>(self);
    if (stream.rest.empty()) {
      std::optional<std::string> more = stream.next();
      if (!more) return MHD_CONTENT_READER_END_OF_STREAM;
      stream.rest = std::move(*more);
    }
    const std::size_t size = stream.rest.copy(piece, most);
    stream.rest.erase(0, size);
    return static_cast<ssize_t>(size);
  };
  const auto end = [](void* self) { delete static_cast<Stream*>(self); };
  return send(to, answer.status,
              MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kMemory, next,
                                                new Stream{std::move(answer.stream)}, end),
              answer.type);
}

// Takes equal time for all texts of the same length.
bool same(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different |= static_cast<unsigned char>(a[i] ^ b[i]);
  return different == 0;
}

}  // namespace

std::string refusal(const RequestHead& request, const ServerAddress& address) {
  if (request.host != address.host) return "this server is http://" + address.host + "/, and no other";
  if (request.changes && !request.origin) return "a command comes from this server's page alone";
  if (request.origin && *request.origin != "http://" + address.host)
    return "pages of other sites are not answered";
  if (!same(request.token, address.token))
    return "open the whole address that the program wrote on its terminal, with its token";
  return "";
}

std::string new_token() {
  std::string token;
  std::ifstream random("/dev/urandom", std::ios::binary);
  for (int i = 0; i < 16; ++i) {
    const int byte = random.get();
    if (byte == std::char_traits<char>::eof()) throw std::runtime_error("/dev/urandom can't be read");
    for (const int half : {byte >> 4, byte & 15}) token += "0123456789abcdef"[half];
  }
  return token;
}

class LocalServer::Parts {
 public:
  Parts(int port, std::size_t most_bytes, Respond respond)
      : most_bytes_(most_bytes), respond_(std::move(respond)) {
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

  const ServerAddress& address() const { return address_; }

 private:
  // The library calls this with a request's head, then with each piece of its body, and at the body's end.
  static MHD_Result answer(void* self, MHD_Connection* from, const char* path, const char* method,
                           const char*, const char* piece, std::size_t* size, void** kept) {
    Parts& parts = *static_cast<Parts*>(self);
    const auto request = static_cast<WebRequest*>(*kept);
    if (!request) return parts.answer_head(from, path, method, kept);
    if (*size > 0) {
      request->body.append(piece, std::min(*size, parts.most_bytes_ + 1 - request->body.size()));
      *size = 0;
      return MHD_YES;
    }
    if (request->body.size() > parts.most_bytes_) return send(from, {413, "this is too long\n"});
    return send(from, parts.respond_(*request));
  }

  static void forget(void*, MHD_Connection*, void** kept, MHD_RequestTerminationCode) {
    delete static_cast<WebRequest*>(*kept);
  }

  MHD_Result answer_head(MHD_Connection* from, const std::string& path, const std::string& method,
                         void** kept) {
    has_address_.wait();
    const auto value = [&](const char* name) {
      const char* found = MHD_lookup_connection_value(from, MHD_HEADER_KIND, name);
      return found ? std::optional<std::string>(found) : std::nullopt;
    };
    const std::size_t end = std::min(path.find('/', 1), path.size());
    const bool changes = method != "GET" && method != "HEAD";
    const std::string why = refusal({.host = value("Host").value_or(""),
                                     .token = path.empty() ? path : path.substr(1, end - 1),
                                     .changes = changes,
                                     .origin = value("Origin")},
                                    address_);
    if (!why.empty()) return send(from, {403, why + "\n"});
    if (end == path.size() || (changes && method != "POST")) return send(from, {404});
    *kept = new WebRequest{path.substr(end + 1), changes};  // forget() deletes it
    return changes ? MHD_YES : send(from, respond_(*static_cast<WebRequest*>(*kept)));
  }

  std::size_t most_bytes_;
  Respond respond_;
  ServerAddress address_ = {"", new_token()};
  std::latch has_address_{1};
  MHD_Daemon* server_ = nullptr;
};

LocalServer::LocalServer(int port, std::size_t most_bytes, Respond respond)
    : parts_(std::make_unique<Parts>(port, most_bytes, std::move(respond))) {}
LocalServer::~LocalServer() = default;

const ServerAddress& LocalServer::address() const {
  return parts_->address();
}

}  // namespace hair
