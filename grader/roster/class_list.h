// STAFF ONLY. The class, made of the roster and its hand-ins: a row for each person on the roster, and a
// list of people who are on no roster.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace grader::inline roster {

struct HandIn {
  std::string name;  // is that of the submission and its folder
  Owner owner;
  std::string system;
  std::string known_as = {};  // is the name from intake if `name` is a code
};

struct ClassList {
  struct Row {
    Person person;
    std::vector<std::string>
        hand_ins;  // are their names; each member has one of a group's. Empty: no hand-in
  };
  struct Stranger {
    std::string hand_in;
    Owner owner;  // is one member of a group
    std::string why;
  };
  std::vector<Row> rows;                      // in the roster's order
  std::vector<Stranger> strangers;            // are graded, too
  std::vector<std::string> said, to_look_at;  // both for staff, a line each; only the latter need a look

  std::vector<const Person*> absent() const;
};

// This is a line of the class for tables: each member has one of a group's hand-in.
struct ClassLine {
  std::string hand_in;  // "": nothing handed in
  std::string name, id, email, section;
  std::string note;  // "nothing handed in", or why a person is on no roster
};

// Returns everybody on the roster, in its order, and then strangers; without a roster the owners of hand-ins
// that a learning system named.
std::vector<ClassLine> lines_of(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins);

// Maps hand-ins to names for people, of a group the members'. Folders with the person's own name are left
// out.
using NamesForPeople = std::map<std::string, std::string>;
NamesForPeople names_for_people(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins);

// Returns the person, else the hand-in's name.
const std::string& shown_name(const std::string& hand_in, const NamesForPeople& people);
// Returns "Müller, Jörg (mueller_4711)", one line that is safe to print; else the hand-in's name.
std::string called(const std::string& hand_in, const NamesForPeople& people);

// A group's row may be in `hand_ins` several times, with its people of each hand-in of the course.
ClassList class_list(const Roster& roster, const std::vector<HandIn>& hand_ins);

}  // namespace grader::roster
