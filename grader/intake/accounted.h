// STAFF ONLY. What became of a file of the input. Nothing is left out without a reason. The record keeps
// those that reached no hand-in.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

struct Accounted {
  enum class As {
    hand_in,    // it belongs to the hand-in of `whose`
    made,       // the learning system wrote it
    older,      // a newer hand-in or a later entry counts
    left_over,  // a person must look
    notice,     // no file, but a line in `reason` that a person must read
  };
  std::string path;  // the argument, and where in it; for people
  As as = As::hand_in;
  std::string reason;  // "" for what belongs to a hand-in
  std::string whose;   // a submission's name; "" for nobody's
};

inline std::string to_string(Accounted::As as) {
  using enum Accounted::As;
  return as == hand_in     ? "hand_in"
         : as == made      ? "made"
         : as == older     ? "older"
         : as == left_over ? "left_over"
                           : "notice";
}

}  // namespace grader::intake
