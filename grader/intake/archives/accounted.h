// STAFF ONLY. The fate of each file of the input: no file is left out without a reason. The record keeps the
// files that reached no hand-in.
#pragma once

#include <string>
#include <vector>

namespace grader::inline intake {

struct Accounted {
  enum class As {
    hand_in,    // it belongs to the hand-in of `whose`
    made,       // the learning system wrote it
    older,      // a newer hand-in or a later entry replaces it
    left_over,  // a person must look at it
    notice,     // is no file: a person must read the line in `reason`
  };
  std::string path;  // has the argument and the place in it, for people
  As as = As::hand_in;
  std::string reason;  // "" if the file belongs to a hand-in
  std::string whose;   // a submission's name; "" if the file belongs to nobody
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
