#include "hair/io/serve/guard.h"

#include <fstream>
#include <stdexcept>

namespace hair {

namespace {

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

}  // namespace hair
