// STAFF ONLY. Brightspace's download, folders or flat files, with an index of its own:
//
//   5917-716031 - Jane Doe - May 18, 2025 1224 PM/main.cpp     two numbers, a name, the time of the hand-in
//   5917-716031 - Jane Doe - May 18, 2025 1224 PM - main.cpp   flat
//   index.html
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {
namespace {

// "May", 18, 2025, 12, 24, "PM" as "2025-05-18 12:24:00".
std::string brightspace_time(const std::vector<std::string>& parts, std::size_t first) {
  constexpr std::array<std::string_view, 12> kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const auto month = std::find(kMonths.begin(), kMonths.end(), parts[first].substr(0, 3));
  if (month == kMonths.end()) return {};
  const int hour = std::stoi(parts[first + 3]) % 12 + (parts[first + 5] == "PM" ? 12 : 0);
  char time[40];
  std::snprintf(time, sizeof time, "%s-%02d-%02d %02d:%s:00", parts[first + 2].c_str(),
                static_cast<int>(month - kMonths.begin()) + 1, std::stoi(parts[first + 1]), hour,
                parts[first + 4].c_str());
  return time;
}

}  // namespace

std::optional<NamedPath> read_brightspace(std::string_view name, bool is_folder, const Around&) {
  static const std::regex kName(
      "([0-9]+)-([0-9]+) - (.+?) - ([A-Z][a-z]{2,8}) ([0-9]{1,2}), ([0-9]{4}) ([0-9]{1,2})([0-9]{2}) ([AP]M)"
      "(?: - (.+))?");
  NamedPath named;
  if (!is_folder && name == "index.html") {
    named.kind = NamedPath::Kind::made;
    return named;
  }
  const auto parts = groups_of(name, kName);
  if (!parts || is_folder != parts->at(10).empty()) return {};
  named.owner.id = parts->at(1);
  named.stem = parts->at(2);
  named.owner.name = parts->at(3);
  named.handed_in = brightspace_time(*parts, 4);
  named.inside = parts->at(10);
  return named;
}

void settle_brightspace(std::vector<NamedPath*>& names) {
  // No source defines which number is the student's: it is the one that differs between students.
  std::map<std::string, std::set<std::string>> names_of_first, names_of_second;
  for (const NamedPath* named : names) {
    names_of_first[named->owner.id].insert(named->owner.name);
    names_of_second[named->stem].insert(named->owner.name);
  }
  const auto shared = [](const auto& numbers) {
    return std::ranges::any_of(numbers, [](const auto& number) { return number.second.size() > 1; });
  };
  if (!shared(names_of_first) || shared(names_of_second)) return;
  for (NamedPath* named : names) std::swap(named->owner.id, named->stem);
}

}  // namespace grader::intake
