// STAFF ONLY.
#include "grader/intake/learning_system.h"

#include <algorithm>
#include <regex>
#include <string>

#include "grader/intake/canvas.h"

namespace grader {

bool is_name_of_a_learning_system(std::string_view name) {
  constexpr std::size_t kLongest = 255;  // of a file's name; std::regex takes stack for each letter
  static const std::regex kNames(
      ".+_[0-9]+_assignsubmission_(file|onlinetext)(_.*)?"
      "|.+_attempt_[0-9]{4}(-[0-9]{2}){5}_.+"
      "|[0-9]+-[0-9]+ - .+ - [A-Z][a-z]+ [0-9]{1,2}, [0-9]{4} [0-9]{3,4} [AP]M");
  if (canvas_name(name, {})) return true;
  return name.size() <= kLongest && std::regex_match(name.begin(), name.end(), kNames);
}

}  // namespace grader
