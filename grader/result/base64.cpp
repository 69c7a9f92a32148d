// STAFF ONLY. Decodes bytes with libsodium.
#include "grader/result/base64.h"

#include <sodium.h>

#include <stdexcept>

namespace grader::inline result {

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
