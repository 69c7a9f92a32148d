// STAFF ONLY. How late a hand-in is, and what the rules of the course took for it.
#pragma once

#include <string>

namespace grader::inline result {

struct Lateness {
  std::string handed_in;  // as the download says it; "": it has no time
  int days = 0;           // begun ones of the calendar; 0: not late, or nobody knows
  double free_days = 0;   // of these
  double taken = 0;       // points
  bool marked = false;    // as late, by the learning system

  bool operator==(const Lateness&) const = default;
};

}  // namespace grader::result
