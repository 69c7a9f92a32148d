// STAFF ONLY. The class as the roster and its hand-ins make it: a row for each person on the roster, whoever handed in, and those apart
// who are on no roster.
#pragma once

#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace grader {

struct HandIn {
  std::string name;  // of the submission and its folder
  Owner owner;
  std::string system;
};

struct ClassList {
  struct Row {
    Person person;
    std::vector<std::string>
        hand_ins;  // their names; of a group's each member has one. Empty: nothing handed in
  };
  struct Stranger {
    std::string hand_in, why;
  };
  std::vector<Row> rows;            // in the roster's order
  std::vector<Stranger> strangers;  // graded all the same
  std::vector<std::string> said;    // for staff, a line each

  std::vector<const Person*> absent() const;
};

ClassList class_list(const Roster& roster, const std::vector<HandIn>& hand_ins);

}  // namespace grader
