// STAFF ONLY. Who draws the inputs of whom: a hand-in keeps what its inputs are drawn from while its people are the same, whatever its
// folder is called. A group is known by its id in the system, else by its members: who leaves or joins changes nothing for the rest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/roster/class_list.h"

namespace grader {

struct Drawn {
  HandIn hand_in;    // its system is "" if nobody knows whose it is: then its name counts
  std::string from;  // what its inputs are drawn from
};

// For each of `now` what it draws from. Each of `before` is found again at most once. Somebody new draws from the own name, or, if that is
// another's, from one that is made of name and people.
std::vector<std::string> drawn_from(const std::vector<Drawn>& before, const std::vector<HandIn>& now);

}  // namespace grader
