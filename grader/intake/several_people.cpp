// STAFF ONLY.
#include "grader/intake/several_people.h"

#include <algorithm>
#include <vector>

#include "grader/intake/learning_system.h"
#include "grader/intake/names.h"

namespace grader {
namespace {

std::string_view name_below(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

}  // namespace

bool has_names_of_a_learning_system(const Layout& layout) {
  return std::ranges::all_of(layout.members, [](const Member& member) {
    return member.kind == Member::Kind::canvas || is_name_of_a_learning_system(name_below(member.path));
  });
}

std::string why_no_class(const Layout& layout, std::string_view name, const Arguments& arguments) {
  if (!layout.is_class || arguments.classes) return {};
  std::vector<std::string> names;
  for (const Member& member : layout.members) names.push_back(submission_name(name_below(member.path)));
  const bool bears_name_of_one = names.size() > 1 && std::ranges::count(names, submission_name(name)) > 0;
  const bool download = has_names_of_a_learning_system(layout) && !is_name_of_a_learning_system(name);
  if (arguments.several ? download : !bears_name_of_one) return {};
  return "was not graded: it holds folders or archives of several people (" + some_of(names) + "), and " +
         (arguments.several ? "is one of several arguments" : "is called as one of them") +
         ", so it may be one student's hand-in; if it is a class, say --class";
}

}  // namespace grader
