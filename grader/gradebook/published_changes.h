// STAFF ONLY. A table of students whose total is another one than feedback or a gradebook had, to write to
// them.
#pragma once

#include <cstddef>
#include <string>

#include "grader/record/record.h"

namespace grader::inline gradebook {

struct PublishedChanges {
  std::string csv;  // has a row for each member of a group
  std::size_t students = 0;
};
PublishedChanges published_changes(Record& record);

}  // namespace grader::gradebook
