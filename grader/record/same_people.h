// STAFF ONLY. Who draws the inputs of whom: a hand-in keeps what its inputs are drawn from while its people
// are the same, whatever its folder is called. A group is known by its id in the system, else by its members:
// who leaves or joins changes nothing for the rest.
//
// The row of a hand-in stays, too, with all that people decided about it, if everybody of it is still there:
// a group may get another name, and somebody more. If somebody has left it, decisions about that one's work
// would become others': then it is a row of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/roster/class_list.h"

namespace grader::inline record {

struct Drawn {
  HandIn hand_in;    // its system is "" if nobody knows whose it is: then its name counts
  std::string from;  // what its inputs are drawn from
};

// For each of `now` what it draws from. Each row of `before` is found again at most once; it may stand there
// several times, with its people of each hand-in of the course. Somebody new draws from the own name, or, if
// that is another's, from one that is made of name and people.
std::vector<std::string> drawn_from(const std::vector<Drawn>& before, const std::vector<HandIn>& now);

struct RowName {
  std::string name;
  std::string told =
      {};  // for staff: why it is another name than the hand-in's, or why the row is a new one; "": it is plain
};
// For each of `now` the name of its row; no two are the same if none of `now` are.
std::vector<RowName> row_names(const std::vector<Drawn>& before, const std::vector<HandIn>& now);

}  // namespace grader::record
