// STAFF ONLY. Computes hashes with libsodium.
#include "grader/compile/hash.h"

#include <sodium.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader::inline compile {
namespace {

std::string hexadecimal(const unsigned char* bytes, std::size_t size) {
  std::string text(2 * size + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes, size);
  text.pop_back();
  return text;
}

const unsigned char* as_bytes(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

}  // namespace

std::string sha256(const std::string& bytes) {
  unsigned char digest[crypto_hash_sha256_BYTES];
  crypto_hash_sha256(digest, as_bytes(bytes), bytes.size());
  return hexadecimal(digest, sizeof digest);
}

std::string hmac_sha256(const std::string& key, const std::string& bytes) {
  crypto_auth_hmacsha256_state state;
  unsigned char digest[crypto_auth_hmacsha256_BYTES];
  crypto_auth_hmacsha256_init(&state, as_bytes(key), key.size());
  crypto_auth_hmacsha256_update(&state, as_bytes(bytes), bytes.size());
  crypto_auth_hmacsha256_final(&state, digest);
  return hexadecimal(digest, sizeof digest);
}

std::string sha256_of(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  if (fs::is_directory(path)) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string all;
    for (const fs::path& file : files)
      all += fs::relative(file, path).string() + "\n" + sha256_of(file) + "\n";
    return sha256(all);
  }
  return sha256(hair::read_file(path, std::numeric_limits<std::size_t>::max(), "a file that can be read"));
}

}  // namespace grader::compile
