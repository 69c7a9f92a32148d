// STAFF ONLY. A server on the loopback that says nothing: who gets through to it is not alone on the network.
#pragma once

#include "grader/sandbox/descriptor.h"

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
