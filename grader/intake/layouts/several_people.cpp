// STAFF ONLY. Refuses a hand-in that looks like a class.
#include "grader/intake/layouts/several_people.h"

#include <algorithm>

#include "grader/intake/layouts/system.h"
#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"

namespace grader::inline intake {

std::string why_no_class(const std::vector<std::string>& names, std::string_view name,
                         const Arguments& arguments) {
  if (arguments.classes) return {};
  std::string why;
  if (arguments.several)
    why = "is one of several arguments";
  else if (names.size() > 1 && std::ranges::count(names, submission_name(name)) > 0)
    why = "is called as one of them";
  else if (told_by_name(name, false) || told_by_name(without_archive_ending(name), true))
    why = "is called as a learning system calls one student's";
  if (why.empty()) return {};
  return "was not graded: it holds hand-ins under people's names (" + some_of(names) + "), and " + why +
         ", so it may be one student's hand-in; if it is a class, say";
}

}  // namespace grader::intake
