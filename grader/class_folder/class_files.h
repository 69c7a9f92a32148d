// STAFF ONLY. The files of a folder of grades, made from its record and never read back: those of students,
// and those of the class, with timing.json (all costs, compared with the reference in an identical worker)
// and costs.html, the page that shows it, and left-over.json. The same record gives the same bytes, except
// for times.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grader/record/changes.h"

namespace grader::inline class_folder {

void write_student_files(const std::filesystem::path& folder, const Recorded& one,
                         const NamesForPeople& people);

// Returns a result with people's decisions; `hidden` names are hidden in it.
std::optional<Recorded> find_shown(Record& record, const std::string& name,
                                   const std::optional<HiddenNames>& hidden);

// This page, beside the class's, has what each student's last grading changed.
inline constexpr const char* kChangesPage = "changes.html";

// Lists students with changes, by name.
using ClassChanges = std::vector<std::pair<std::string, std::vector<PointsChange>>>;
ClassChanges class_changes(Record& record);

std::string shown_change(const PointsChange& change);  // "1.5 -> 4"

std::string class_page_of(Record& record);

// Writes all files of the record's hand-in: of all students except those in `written`, of the class, and of
// the course. Returns all results, sorted by name.
std::vector<SubmissionResult> write_class_files(const std::filesystem::path& folder, Record& record,
                                                const std::set<std::string>& written = {});

}  // namespace grader::class_folder
