// STAFF ONLY. Binds a socket before it reports the port.
#include "grader/sandbox/listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <system_error>

namespace grader::inline sandbox {

Listener::Listener() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  constexpr int kWaiting = 8;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  if (bind(socket_.get(), plain, size) != 0 || listen(socket_.get(), kWaiting) != 0 ||
      getsockname(socket_.get(), plain, &size) != 0)
    throw std::system_error(errno, std::generic_category(), "a server on the loopback");
  port_ = ntohs(address.sin_port);
}

}  // namespace grader::sandbox
