#include "hair/live/commands_in.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace hair {

std::optional<std::string> CommandsIn::next(int milliseconds) {
  for (std::size_t end = read_.find('\n');; end = read_.find('\n')) {
    if (end != std::string::npos) {
      std::string line = read_.substr(0, end);
      read_.erase(0, end + 1);
      return line;
    }
    pollfd one{descriptor_, POLLIN, 0};
    if (!open_ || poll(&one, 1, milliseconds) <= 0) return {};
    std::array<char, 1 << 16> buffer;
    const ssize_t size = ::read(descriptor_, buffer.data(), buffer.size());
    if (size < 0 && (errno == EINTR || errno == EAGAIN)) return {};
    if (size <= 0)
      open_ = false;
    else
      read_.append(buffer.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace hair
