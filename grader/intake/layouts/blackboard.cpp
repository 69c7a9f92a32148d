// STAFF ONLY. Blackboard's download, flat files, with a note for each attempt:
//
//   Lab 3_so12_attempt_2025-03-04-10-15-22_main.cpp   the assignment's title, a user name, the attempt's time
//   Lab 3_so12_attempt_2025-03-04-10-15-22.txt        the note
#include <algorithm>

#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

std::optional<NamedPath> read_blackboard(std::string_view name, bool is_folder, const Around&) {
  static const std::regex kName(
      "(.+?)_attempt_([0-9]{4}-[0-9]{2}-[0-9]{2})-([0-9]{2})-([0-9]{2})-([0-9]{2})(?:_(.+)|\\.txt)");
  const auto parts = groups_of(name, kName);
  if (!parts || is_folder) return {};
  NamedPath named;
  named.stem = parts->at(1);
  named.owner.id = named.stem.substr(named.stem.rfind('_') + 1);
  named.handed_in = parts->at(2) + " " + parts->at(3) + ":" + parts->at(4) + ":" + parts->at(5);
  named.inside = parts->at(6);
  if (named.inside.empty()) named.kind = NamedPath::Kind::text;
  return named;
}

void settle_blackboard(std::vector<NamedPath*>& names) {
  // User names may hold a "_". The title is the common beginning of all names.
  std::string title = names.front()->stem;
  bool several = false;
  for (const NamedPath* named : names) {
    several = several || named->stem != names.front()->stem;
    title.resize(static_cast<std::size_t>(
        std::mismatch(title.begin(), title.end(), named->stem.begin(), named->stem.end()).first -
        title.begin()));
  }
  if (!several) return;
  title.resize(title.rfind('_') == std::string::npos ? 0 : title.rfind('_') + 1);
  for (NamedPath* named : names)
    if (!title.empty() && named->stem.size() > title.size())
      named->owner.id = named->stem.substr(title.size());
}

}  // namespace grader::intake
