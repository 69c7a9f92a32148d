// STAFF ONLY. Encodes bytes with libsodium.
#include "grader/result/base64.h"

#include <sodium.h>

#include <stdexcept>

namespace grader::inline result {

std::string base64(std::string_view bytes) {
  std::string text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.pop_back();  // drops the NUL at its end
  return text;
}

std::string from_base64(std::string_view text) {
  std::string bytes(text.size() / 4 * 3, '\0');
  std::size_t size = 0;
  // Without an end pointer it fails if anything follows; nothing is ignored.
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &size, nullptr, sodium_base64_VARIANT_ORIGINAL) != 0)
    throw std::invalid_argument("not base64");
  bytes.resize(size);
  return bytes;
}

}  // namespace grader::result
