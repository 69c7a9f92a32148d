// STAFF ONLY. Serves a force to a student's code: the other side is RemoteForce, remote.h. It counts the
// questions and stores the states of force evaluations.
#pragma once

#include <vector>

#include "grader/wire/force_message.h"
#include "grader/wire/message.h"
#include "particles/force.h"
#include "particles/state.h"

namespace grader::inline calls {

class ForceServer {
 public:
  // Serves n particles; it answers `most` questions and then stops the request.
  ForceServer(const particles::Force& force, int n, int most) : force_(force), size_(3 * n), most_(most) {}

  // Is a handler of Products.
  bool operator()(int which, const std::vector<double>& question, std::vector<double>& answer);

  int energies = 0, forces = 0, dfdx = 0, dfdv = 0, bands = 0;  // count questions so far
  // Are the states of the first evaluations, and the number of products with df/dv before each.
  std::vector<particles::State> forces_at;
  std::vector<int> products_before;

 private:
  const particles::Force& force_;
  int size_, most_;
};

}  // namespace grader::calls
