// STAFF ONLY. The lateness of a hand-in, and the points that the course's rules took for it.
#pragma once

#include <string>

namespace grader::inline result {

struct Lateness {
  std::string handed_in;  // as in the download; "": it has no time
  int days = 0;           // begun days of the calendar; 0: not late, or unknown
  double free_days = 0;   // are a part of these
  double taken = 0;       // are points
  bool marked = false;    // by the learning system

  bool operator==(const Lateness&) const = default;
};

}  // namespace grader::result
