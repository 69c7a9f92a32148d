// STAFF ONLY. Writes changes.html, beside the class's page: what each student's last grading changed.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grader/record/changes.h"

namespace grader::inline class_folder {

inline constexpr const char* kChangesPage = "changes.html";

// Lists students with changes, by name.
using ClassChanges = std::vector<std::pair<std::string, std::vector<PointsChange>>>;
ClassChanges class_changes(Record& record);

std::string shown_change(const PointsChange& change);  // "1.5 -> 4"

// Removes the page if nothing has changed.
void write_changes_page(const std::filesystem::path& folder, const ClassChanges& all,
                        const NamesForPeople& people);

}  // namespace grader::class_folder
