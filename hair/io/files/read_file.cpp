#include "hair/io/files/read_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {

std::string read_file(const std::filesystem::path& file, std::size_t most, const std::string& wanted) {
  const auto fail = [&](const std::string& why) {
    throw BadInput(printable(file.string(), 4096) + ": can't be read (" + why + "); give the path of " +
                   wanted);
  };
  const auto fail_with = [&](int error) { fail(std::generic_category().message(error)); };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) fail_with(EISDIR);
  // A pipe may stay silent, and a device may never end.
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
    fail("it is no regular file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail_with(errno ? errno : EIO);
  std::string bytes;
  std::array<char, 65536> part;
  while (in.read(part.data(), part.size()), in.gcount() > 0) {
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > most) fail("it has more than " + std::to_string(most) + " bytes");
  }
  if (in.bad()) fail_with(errno ? errno : EIO);
  return bytes;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace hair
