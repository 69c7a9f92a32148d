// STAFF ONLY. Divides a name by a regular expression.
#pragma once

#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace grader::inline intake {

// Returns the groups of `pattern`, counted from 1. std::regex takes stack for each letter, so a name that is
// longer than file systems allow does not match.
inline std::optional<std::vector<std::string>> groups_of(std::string_view name, const std::regex& pattern) {
  constexpr std::size_t kLongest = 600;
  std::match_results<std::string_view::const_iterator> found;
  if (name.size() > kLongest || !std::regex_match(name.begin(), name.end(), found, pattern)) return {};
  std::vector<std::string> groups;
  for (const auto& group : found) groups.push_back(group.str());
  return groups;
}

}  // namespace grader::intake
