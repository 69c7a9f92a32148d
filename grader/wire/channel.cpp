// STAFF ONLY. Sends and receives messages over pipes.
#include "grader/wire/channel.h"

#include <poll.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "grader/wire/message.h"

namespace grader::inline wire {
namespace {

struct Header {
  std::uint32_t kind;
  std::uint32_t reserved;
  std::uint64_t nonce;
  std::uint64_t size;
};

}  // namespace

bool Channel::read_fully(void* to, std::size_t size) {
  auto* at = static_cast<std::byte*>(to);
  while (size > 0) {
    if (wait_ && !wait_(in_, POLLIN)) return false;
    const ssize_t got = read(in_, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool Channel::send(Kind kind, std::uint64_t nonce, std::span<const std::byte> body) {
  Header header{static_cast<std::uint32_t>(kind), 0, nonce, body.size()};
  iovec parts[2] = {{&header, sizeof header}, {const_cast<std::byte*>(body.data()), body.size()}};
  std::size_t left = sizeof header + body.size();
  while (left > 0) {
    if (wait_ && !wait_(out_, POLLOUT)) return false;
    const ssize_t sent = writev(out_, parts, 2);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) return false;
    left -= static_cast<std::size_t>(sent);
    std::size_t done = static_cast<std::size_t>(sent);
    for (iovec& part : parts) {
      const std::size_t step = done < part.iov_len ? done : part.iov_len;
      part.iov_base = static_cast<std::byte*>(part.iov_base) + step;
      part.iov_len -= step;
      done -= step;
    }
  }
  return true;
}

std::optional<Message> Channel::receive(std::size_t limit) {
  Header header;
  if (!read_fully(&header, sizeof header)) return {};
  if (header.size > limit)
    throw MalformedMessage("a message of " + std::to_string(header.size) + " bytes; at most " +
                           std::to_string(limit) + " make sense");
  Message message{static_cast<Kind>(header.kind), header.nonce, std::vector<std::byte>(header.size)};
  if (!read_fully(message.body.data(), message.body.size())) return {};
  return message;
}

}  // namespace grader::wire
