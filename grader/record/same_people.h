// STAFF ONLY. Chooses the seed of a hand-in, a name that its inputs are drawn from: it stays while the people
// are the same, whatever the folder's name is. A group is known by its id in the system, else by its members:
// people who leave or join change nothing for the rest.
//
// A hand-in also keeps its row, with all decisions of people about it, if all of its people are still there:
// a group may get another name, and new members. If a member has left, the row's decisions would become other
// people's: then it gets a row of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/roster/class_list.h"

namespace grader::inline record {

struct Drawn {
  HandIn hand_in;    // its system is "" if the owner is unknown: then its name counts
  std::string from;  // is the seed of its inputs
};

// Returns the seed of each of `now`. Each row of `before` is found again at most once; it may occur several
// times, with its people of each hand-in of the course. A new hand-in gets its own name as seed, or, if that
// is taken, one made of name and people.
std::vector<std::string> drawn_from(const std::vector<Drawn>& before, const std::vector<HandIn>& now);

struct RowName {
  std::string name;
  std::string told =
      {};  // tells staff why the name differs from the hand-in's, or why the row is new; "": it is plain
};
// Returns the name of the row of each of `now`; no two are the same if none of `now` are.
std::vector<RowName> row_names(const std::vector<Drawn>& before, const std::vector<HandIn>& now);

}  // namespace grader::record
