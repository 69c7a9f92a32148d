// STAFF ONLY. The class as the roster and its hand-ins make it: a row for each person on the roster, whoever
// handed in, and those apart who are on no roster.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace grader::inline roster {

struct HandIn {
  std::string name;  // of the submission and its folder
  Owner owner;
  std::string system;
  std::string known_as = {};  // where `name` is a code: the name that intake found
};

struct ClassList {
  struct Row {
    Person person;
    std::vector<std::string>
        hand_ins;  // their names; of a group's each member has one. Empty: nothing handed in
  };
  struct Stranger {
    std::string hand_in;
    Owner owner;  // of a group's, one member
    std::string why;
  };
  std::vector<Row> rows;                      // in the roster's order
  std::vector<Stranger> strangers;            // graded all the same
  std::vector<std::string> said, to_look_at;  // for staff, a line each

  std::vector<const Person*> absent() const;
};

// A line of the class for tables: of a group's hand-in each member has one.
struct ClassLine {
  std::string hand_in;  // "": nothing handed in
  std::string name, id, email, section;
  std::string note;  // "nothing handed in", or why somebody is on no roster
};

// With a roster everybody on it, in its order, and then strangers; without one the owners of
// hand-ins that a learning system named.
std::vector<ClassLine> lines_of(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins);

// By hand-in: the name that people read, of a group the members'. Those whose folder has the same name are
// left out.
using NamesForPeople = std::map<std::string, std::string>;
NamesForPeople names_for_people(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins);

// The person, else the hand-in's name.
const std::string& shown_name(const std::string& hand_in, const NamesForPeople& people);
// "Müller, Jörg (mueller_4711)", one line that is safe to print; else the hand-in's name.
std::string called(const std::string& hand_in, const NamesForPeople& people);

// A group's row may stand among `hand_ins` several times, with its people of each hand-in of the course.
ClassList class_list(const Roster& roster, const std::vector<HandIn>& hand_ins);

}  // namespace grader::roster
