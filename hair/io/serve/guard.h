// Checks the requests to a server for pages. It listens on this machine alone, but any page in a browser and
// any user of the machine can send requests to it. Origin names the page's own site, Host shows a foreign
// name that was made to point here, and only the real page has the token.
#pragma once

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

}  // namespace hair
