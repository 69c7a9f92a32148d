#include "hair/lab/run/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {

namespace {

constexpr std::size_t kBuffer = 1 << 20;  // bytes

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& file, std::filesystem::path shown)
    : shown_(std::move(shown)),
      descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBuffer) flush();
}

void OutputFile::overwrite(std::uint64_t at, std::string_view bytes) {
  flush();
  if (lseek(descriptor_, static_cast<off_t>(at), SEEK_SET) < 0) fail(errno);
  buffer_ = bytes;
  flush();
  if (lseek(descriptor_, 0, SEEK_END) < 0) fail(errno);
}

void OutputFile::close() {
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::fail(int error) const {
  throw BadInput(printable(shown_.string(), 4096) + ": can't be written (" +
                 std::generic_category().message(error) +
                 "); give a folder that can be written, with room in it");
}

}  // namespace hair
