// STAFF ONLY. Reads clones of gh-classroom: lab3-submissions/lab3-jmueller/, a folder for each repository
// with a login or a team's name. Its grades.csv may lie beside them.
#include <algorithm>

#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {
namespace {

constexpr std::string_view kClonedInto = "-submissions";

}  // namespace

std::optional<NamedPath> read_classroom(std::string_view name, bool is_folder, const Around& around) {
  NamedPath named;
  const std::string_view in = around.folder;
  const bool cloned = in.size() > kClonedInto.size() && in.ends_with(kClonedInto);
  if (!cloned && !around.is_said) return {};
  if (!is_folder) {
    if (name != "grades.csv") return {};
    named.kind = NamedPath::Kind::made;
    return named;
  }
  const std::string slug = cloned ? std::string(in.substr(0, in.size() - kClonedInto.size())) + "-" : "";
  if (!name.starts_with(slug) || name.size() == slug.size()) return {};
  named.owner.id = name.substr(slug.size());
  if (!cloned) named.stem = name;
  return named;
}

void settle_classroom(std::vector<NamedPath*>& names) {
  // The folder around them has another name: the assignment's name is the common beginning of all of them.
  std::vector<NamedPath*> unsettled;
  for (NamedPath* named : names)
    if (!named->stem.empty()) unsettled.push_back(named);
  if (unsettled.size() < 2) return;
  std::string slug = unsettled.front()->stem;
  for (const NamedPath* named : unsettled)
    slug.resize(static_cast<std::size_t>(
        std::mismatch(slug.begin(), slug.end(), named->stem.begin(), named->stem.end()).first -
        slug.begin()));
  slug.resize(slug.rfind('-') == std::string::npos ? 0 : slug.rfind('-') + 1);
  for (NamedPath* named : unsettled)
    if (named->stem.size() > slug.size()) named->owner.id = named->stem.substr(slug.size());
}

}  // namespace grader::intake
