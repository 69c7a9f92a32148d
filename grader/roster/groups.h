// STAFF ONLY. Groups that a download names without their members, as Canvas's and Moodle's do: the roster's
// groups have them.
//
//   team7_4713_90020_lab.zip          Canvas: the group's name, the number of the one who handed in
//   Team 7_55_assignsubmission_file/  Moodle: the group's name and number
//
// A hand-in is a group's if it is called as one group of the roster alone, and as no person. In Canvas's
// download its number is a member's, too: a section may have the same name.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/layouts/system.h"
#include "grader/roster/class_list.h"

namespace grader::inline roster {

// The proof for names that can be read in several ways (intake/layouts/system.h). `roster` must live as long.
KnownOwner known_by(const Roster& roster);

// Gives their owners the members. If two hand-ins have one group's name, each is a single student's, as
// Canvas has them where it grades each member alone. Returns lines for staff: how many were found, and why a
// hand-in is taken for none.
struct Membership {
  std::vector<std::string> said, doubts;  // to know; to look at: somebody of a group may lose points
};
Membership find_members(std::vector<HandIn>& hand_ins, const Roster& roster);

}  // namespace grader::roster
