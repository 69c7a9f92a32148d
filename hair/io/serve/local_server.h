// A web server for pages of this machine. It listens on 127.0.0.1 alone, but any page in a browser and any
// user of the machine can send requests to it, so it checks them: Origin names the page's own site, Host
// shows a foreign name that was made to point here, and only the real page has the token.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace hair {

struct ServerAddress {
  std::string host;   // "127.0.0.1:41234"
  std::string token;  // hexadecimal digits

  // Each path begins with the token, so that pages link to each other without it.
  std::string url() const { return "http://" + host + "/" + token + "/"; }
};

struct RequestHead {
  std::string host, token;
  bool changes = false;  // it is a POST
  std::optional<std::string> origin = {};
};

// The reason why a request is refused; empty if it is not.
std::string refusal(const RequestHead& request, const ServerAddress& address);

// 128 random bits from the system. Throws std::runtime_error if it gives none.
std::string new_token();

struct WebRequest {
  std::string path;      // behind the token: "" is the first page
  bool changes = false;  // it is a POST
  std::string body = {};
};

inline constexpr const char* kHtmlType = "text/html; charset=utf-8";

struct WebAnswer {
  unsigned status = 200;
  std::string text = {};
  std::string type = "text/plain; charset=utf-8";
  // An answer that goes on: the next piece, or nothing at its end.
  std::function<std::optional<std::string>()> stream = {};
};

class LocalServer {
 public:
  using Respond = std::function<WebAnswer(const WebRequest&)>;

  // Port 0 means any free port. Calls `respond` in threads of the server, one for each connection; bodies
  // have at most `most_bytes`. Throws BadInput if the port is taken.
  LocalServer(int port, std::size_t most_bytes, Respond respond);
  ~LocalServer();  // streams must come to their ends
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  const ServerAddress& address() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
