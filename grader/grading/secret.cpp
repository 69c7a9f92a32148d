// STAFF ONLY. Keeps the secret in a file, and derives from it.
#include "grader/grading/secret.h"

#include <fcntl.h>
#include <sodium.h>
#include <unistd.h>

#include <cstdlib>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLeastBytes = 16;

void make_secret(const fs::path& file) {
  unsigned char random[32];
  randombytes_buf(random, sizeof random);
  char text[2 * sizeof random + 1];
  sodium_bin2hex(text, sizeof text, random, sizeof random);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  keep_secret(text, file);
}

}  // namespace

// The secret is written in full under another name first: two graders that
// start together agree on one.
bool keep_secret(const std::string& secret, const fs::path& file) {
  const fs::path temporary = file.string() + "." + std::to_string(getpid());
  const int out = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  bool written = out >= 0 && write(out, secret.data(), secret.size()) == static_cast<ssize_t>(secret.size());
  if (out >= 0) written = fsync(out) == 0 && written;
  if (out >= 0) close(out);
  std::error_code error;
  if (written) fs::create_hard_link(temporary, file, error);
  if (out >= 0) fs::remove(temporary);
  if (written && error == std::errc::file_exists) return false;
  if (!written || error)
    throw BadInput(file.string() +
                   ": can't keep the staff's secret there; name a file in a folder that can be written");
  return true;
}

fs::path default_secret_file() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return fs::path(config) / "hairgrade" / "secret";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".config" / "hairgrade" / "secret";
  throw BadInput("HOME is not set, so there is no place for the staff's secret; name a file with --secret");
}

std::string read_secret(const std::optional<fs::path>& file) {
  const fs::path path = file ? *file : default_secret_file();
  if (!file && !fs::exists(path)) make_secret(path);
  const std::string secret = hair::bytes_of(path);
  if (secret.empty())
    throw BadInput(path.string() + ": can't read the staff's secret; name a file of 16 random bytes or more");
  if (secret.size() < kLeastBytes)
    throw BadInput(path.string() + ": a secret of " + std::to_string(secret.size()) +
                   " bytes; it takes 16 or more");
  return secret;
}

std::string fingerprint(const std::string& secret) {
  return hmac_sha256(secret, "which secret made a folder of grades").substr(0, 16);
}

std::string export_secret(const fs::path& file) {
  const fs::path mine = default_secret_file();
  if (!fs::exists(mine))
    throw BadInput(mine.string() +
                   ": there is no secret yet; the first grading makes it, or secret import brings one");
  const std::string secret = read_secret(mine);
  if (!keep_secret(secret, file)) throw BadInput(file.string() + ": a file is there already; name a new one");
  return fingerprint(secret);
}

std::string import_secret(const fs::path& file) {
  const std::string secret = read_secret(file);
  const fs::path mine = default_secret_file();
  std::error_code error;
  fs::create_directories(mine.parent_path(), error);
  if (!keep_secret(secret, mine) && read_secret(mine) != secret)
    throw BadInput(mine.string() + ": another secret is there, with the fingerprint " +
                   fingerprint(read_secret(mine)) +
                   ", and grades may need it; move it to another name first");
  return fingerprint(secret);
}

std::string seed_for(const std::string& secret, const std::string& student, const std::string& exercise) {
  return hmac_sha256(secret, student + '\0' + exercise);
}

}  // namespace grader::grading
