// STAFF ONLY. The grades of a record, for learning systems.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/gradebook/filling.h"
#include "grader/record/changes.h"
#include "grader/record/record.h"

namespace grader::inline gradebook {

struct RecordedGrades {
  std::vector<Grade> grades;
  std::map<std::string, Published> points;  // is what these grades tell, by hand-in
  std::vector<std::string> held;            // a line for each hand-in that gets nothing now
};

// Returns the grades of the record's hand-in. Throws BadInput if there are none; `folder` is for the message.
RecordedGrades recorded_grades(Record& record, const std::filesystem::path& folder);

// Remembers that these hand-ins' points were published.
void put_published(Record& record, RecordedGrades recorded, const std::set<std::string>& given,
                   const std::string& by);

// A table of students whose total is another one than feedback or a gradebook had, to write to
// them.
struct PublishedChanges {
  std::string csv;  // has a row for each member of a group
  std::size_t students = 0;
};
PublishedChanges published_changes(Record& record);

}  // namespace grader::gradebook
