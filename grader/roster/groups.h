// STAFF ONLY. Groups that a download names without their members, as Canvas's and Moodle's do: the members
// come from the roster's groups.
//
//   team7_4713_90020_lab.zip          Canvas: the group's name, the number of the member who handed in
//   Team 7_55_assignsubmission_file/  Moodle: the group's name and number
//
// A hand-in is a group's if its name is that of exactly one group of the roster, and of no person. In
// Canvas's download its number must be a member's, too: a section may have the same name.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/layouts/system.h"
#include "grader/roster/class_list.h"

namespace grader::inline roster {

// Proves names that can be read in several ways (intake/layouts/system.h). `roster` must live as long.
KnownOwner known_by(const Roster& roster);

// Gives their owners the members. If two hand-ins have one group's name, each is a single student's, as
// Canvas has them if it grades each member alone. Returns lines for staff: how many were found, and why a
// hand-in was not taken for a group's.
struct Membership {
  std::vector<std::string> said, doubts;  // only doubts need a look: members of a group may lose points
};
Membership find_members(std::vector<HandIn>& hand_ins, const Roster& roster);

}  // namespace grader::roster
