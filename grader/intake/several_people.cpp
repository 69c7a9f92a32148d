// STAFF ONLY. Refuses a hand-in that looks like a class.
#include "grader/intake/several_people.h"

#include <algorithm>

#include "grader/intake/layouts/system.h"
#include "grader/intake/names.h"

namespace grader {

std::string why_no_class(const Crowd& crowd, std::string_view name, const Arguments& arguments) {
  if (arguments.classes) return {};
  const bool bears_name_of_one =
      crowd.names.size() > 1 && std::ranges::count(crowd.names, submission_name(name)) > 0;
  const bool is_named_as_a_hand_in = told_by_name(name, false) || told_by_name(name, true);
  const bool stands = arguments.several ? crowd.of_a_system && !is_named_as_a_hand_in : !bears_name_of_one;
  if (stands) return {};
  return "was not graded: it holds folders or archives of several people (" + some_of(crowd.names) +
         "), and " + (arguments.several ? "is one of several arguments" : "is called as one of them") +
         ", so it may be one student's hand-in; if it is a class, say --class";
}

}  // namespace grader
