// STAFF ONLY. Names that learning systems give to what students hand in. A download of a class consists of such names alone.
//
//   doejane_12347_678901_handin.zip                       Canvas (canvas.h)
//   Jane Doe_4711_assignsubmission_file_                  Moodle, a folder or a file
//   Lab 3_jd12_attempt_2025-03-04-10-15-22_handin.zip     Blackboard
//   5917-716031 - Jane Doe - May 18, 2025 1224 PM         Brightspace, a folder
#pragma once

#include <string_view>

namespace grader {

bool is_name_of_a_learning_system(std::string_view name);

}  // namespace grader
