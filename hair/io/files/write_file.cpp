#include "hair/io/files/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <string>
#include <system_error>
#include <thread>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int error) {
  throw BadInput(printable(file.string(), 4096) + ": can't be written (" +
                 std::generic_category().message(error) +
                 "); give a folder that can be written, with room in it");
}

// 0, or the error's number.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

void check_folder_of(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path() && !fs::is_directory(file.parent_path(), error))
    fail(file, error ? error.value() : ENOTDIR);
}

void write_file(const fs::path& file, std::string_view bytes) {
  std::error_code folder_error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), folder_error);
  if (folder_error) fail(file, folder_error.value());

  // The dot distinguishes it from all submissions and reports. Process and thread distinguish two writers of
  // the same file.
  const std::size_t thread = std::hash<std::thread::id>{}(std::this_thread::get_id());
  const fs::path temporary =
      file.parent_path() / ("." + file.filename().string() + "." + std::to_string(getpid()) + "-" +
                            std::to_string(thread) + ".part");
  const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(file, errno);
  int error = write_all(descriptor, bytes);
  if (close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) {
    unlink(temporary.c_str());
    fail(file, error);
  }
}

}  // namespace hair
