// Replaces the server in a build without the library that serves pages.
#include "hair/io/files/bad_input.h"
#include "hair/io/serve/local_server.h"

namespace hair {

class LocalServer::Parts {};

// NOLINTNEXTLINE(performance-unnecessary-value-param): a server keeps it
LocalServer::LocalServer(int, std::size_t, Respond) {
  throw BadInput(std::string("pages are served by a package that was missing when this was configured. ") +
                 HAIR_HOW_TO_INSTALL + ". Then configure again: cmake -S . -B build");
}
LocalServer::~LocalServer() = default;

const ServerAddress& LocalServer::address() const {
  static const ServerAddress none;
  return none;
}

}  // namespace hair
