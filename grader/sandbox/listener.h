// STAFF ONLY. A silent server on the loopback. A process that reaches it is not cut off from the network.
#pragma once

#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline sandbox {

class Listener {
 public:
  Listener();  // on a port that the machine chooses; throws std::system_error if there is none

  int port() const { return port_; }

 private:
  Descriptor socket_;
  int port_ = 0;
};

}  // namespace grader::sandbox
