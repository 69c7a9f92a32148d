// A web server for pages of this machine: it listens on 127.0.0.1 alone, and answers only requests that the
// guard lets pass (guard.h).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hair/io/serve/guard.h"

namespace hair {

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
