// STAFF ONLY. Opens, closes and reads descriptors.
#include "grader/sandbox/processes/descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>

namespace grader::inline sandbox {

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Pipe make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe2");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

namespace {

// Reads until the other side closes, the time is up, or `take` has enough.
template <class Take>
void read_pieces(const Descriptor& from, double seconds, const Take& take) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  char buffer[4096];
  for (;;) {
    const std::chrono::duration<double, std::milli> left = deadline - Clock::now();
    pollfd readable{from.get(), POLLIN, 0};
    const int ready = poll(&readable, 1, static_cast<int>(std::clamp(left.count(), 0.0, 1e9)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) break;
    const ssize_t got = read(from.get(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0 || !take(std::string_view(buffer, static_cast<std::size_t>(got)))) break;
  }
}

}  // namespace

std::string read_all(const Descriptor& from, std::size_t limit, double seconds) {
  std::string text;
  read_pieces(from, seconds, [&](std::string_view piece) {
    text += piece.substr(0, limit - text.size());
    return text.size() < limit;
  });
  return text;
}

std::string read_both_ends(const Descriptor& from, std::size_t most, double seconds) {
  std::string beginning, end;
  std::size_t left_out = 0;
  read_pieces(from, seconds, [&](std::string_view piece) {
    const std::string_view first = piece.substr(0, most / 2 - beginning.size());
    beginning += first;
    end += piece.substr(first.size());
    if (end.size() > 2 * most) {
      left_out += end.size() - most / 2;
      end.erase(0, end.size() - most / 2);
    }
    return true;
  });
  if (left_out + end.size() <= most / 2) return beginning + end;
  if (end.size() > most / 2) {
    left_out += end.size() - most / 2;
    end.erase(0, end.size() - most / 2);
  }
  // The middle that is left out takes the cut lines with it.
  const std::size_t whole = beginning.rfind('\n') + 1, next = std::min(end.find('\n'), end.size() - 1) + 1;
  left_out += beginning.size() - whole + next;
  return beginning.substr(0, whole) + "(" + std::to_string(left_out) + " bytes are left out here)\n" +
         end.substr(next);
}

}  // namespace grader::sandbox
