// STAFF ONLY.
#include "grader/tool/secret.h"

#include <fcntl.h>
#include <sodium.h>
#include <unistd.h>

#include <cstdlib>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLeastBytes = 16;

fs::path default_file() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return fs::path(config) / "hairgrade" / "secret";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".config" / "hairgrade" / "secret";
  throw BadInput("HOME is not set, so there is no place for the staff's secret; name a file with --secret");
}

void make_secret(const fs::path& file) {
  unsigned char random[32];
  randombytes_buf(random, sizeof random);
  char text[2 * sizeof random + 1];
  sodium_bin2hex(text, sizeof text, random, sizeof random);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  // Written in full under its own name before it is the secret: two graders that start together agree on one.
  const fs::path temporary = file.string() + "." + std::to_string(getpid());
  const int out = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const bool written = out >= 0 && write(out, text, sizeof text - 1) == static_cast<ssize_t>(sizeof text - 1);
  if (out >= 0) close(out);
  if (!written)
    throw BadInput(file.string() + ": can't keep the staff's secret there; name a file with --secret");
  fs::create_hard_link(temporary, file, error);
  fs::remove(temporary);
}

}  // namespace

std::string read_secret(const std::optional<fs::path>& file) {
  const fs::path path = file ? *file : default_file();
  if (!file && !fs::exists(path)) make_secret(path);
  const std::string secret = hair::bytes_of(path);
  if (secret.empty())
    throw BadInput(path.string() + ": can't read the staff's secret; name a file of 16 random bytes or more");
  if (secret.size() < kLeastBytes)
    throw BadInput(path.string() + ": a secret of " + std::to_string(secret.size()) +
                   " bytes; it takes 16 or more");
  return secret;
}

std::string seed_for(const std::string& secret, const std::string& student, const std::string& exercise) {
  return hmac_sha256(secret, student + '\0' + exercise);
}

}  // namespace grader
