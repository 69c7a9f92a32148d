// STAFF ONLY. Whose the hand-ins of a record are, and who should be there.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "grader/roster/class_list.h"

namespace grader {

// Owners of hand-ins that were there before stay if they are not named again. A roster replaces the earlier one.
void record_people(const std::filesystem::path& folder, const std::vector<HandIn>& hand_ins,
                   const std::optional<std::vector<Person>>& roster = {});

// By name. A result without an owner, of an older record, has none here.
std::vector<HandIn> recorded_hand_ins(const std::filesystem::path& folder);

// Nothing if no roster was given so far.
std::optional<ClassList> recorded_class_list(const std::filesystem::path& folder);

// Takes the people of this hand-in from the roster. Record::forget does so first, and then leaves no byte of what was deleted.
void forget_on_roster(const std::filesystem::path& folder, const std::string& hand_in);

}  // namespace grader
