// STAFF ONLY. What became of a file of the input. Nothing is left out without a reason.
#pragma once

#include <string>
#include <vector>

namespace grader {

struct Accounted {
  enum class As {
    hand_in,    // it belongs to the hand-in of `whose`
    made,       // the learning system wrote it
    older,      // a newer hand-in or a later entry counts
    left_over,  // a person must look
  };
  std::string path;  // the argument, and where in it; for people
  As as = As::hand_in;
  std::string reason;  // "" for what belongs to a hand-in
  std::string whose;   // a submission's name; "" for nobody's
};

}  // namespace grader
