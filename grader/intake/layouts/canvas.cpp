// STAFF ONLY. Canvas's download, flat files (instructure/canvas-lms, lib/content_zipper.rb):
//
//   doejane_4711_90001_main.cpp          a name, the student's number, the file's number; its name
//   doejane_LATE_4711_90017_main-1.cpp   handed in late; "-1": a file of this name was handed in before
//   doejane_4711_text.html, ..._link.html   typed text, a link
//   LATE_anon_aB3dE_90021_main.cpp       anonymous
//
// A group whose name ends with "_12" looks like the student 12. The first reading counts unless the roster
// proves another one: students choose the end of the name, but can't give a file somebody else's number.
#include <map>
#include <set>

#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {
namespace {

// "main-1.cpp" was handed in after "main.cpp": Canvas adds such a number to a name that it already has.
void take_canvas_version(NamedPath& named) {
  static const std::regex kNumbered("(.+)-([0-9]{1,6})(\\.[^.]+|\\.tar\\.[a-z0-9]+)");
  if (const auto parts = groups_of(named.inside, kNumbered)) {
    named.inside = parts->at(1) + parts->at(3);
    named.version = std::stoi(parts->at(2));
  }
}

// Takes the student's number from the end of the name: "lab3_12_4713_90020_a.cpp" has the number 4713, and
// not 12.
std::optional<NamedPath> with_longer_name(const NamedPath& named) {
  static const std::regex kNumbered("([0-9]+)_(.+)"), kTyped("(text|link)\\.html");
  if (named.kind != NamedPath::Kind::hand_in || named.owner.anonymous) return {};
  const auto parts = groups_of(named.inside, kNumbered);
  const bool typed = groups_of(named.inside, kTyped).has_value();
  if (!parts && !typed) return {};
  NamedPath other = named;
  other.owner.name += (other.owner.name.empty() ? "" : "_") + other.owner.id;
  other.owner.id = named.stem;
  other.owner.group = true;
  other.stem = parts ? parts->at(1) : "";
  other.inside = parts ? parts->at(2) : "";
  if (typed) other.kind = NamedPath::Kind::text;
  return other;
}

}  // namespace

std::optional<NamedPath> read_canvas(std::string_view name, bool is_folder, const Around&) {
  static const std::regex kName(
      "(?:(.+?)_)?"
      "?(?:(LATE)_)?(?:([0-9]+)|anon_([^_]+))_(?:([0-9]+)_(.+)|(text|link)\\.html)");
  if (is_folder) return {};
  const auto parts = groups_of(name, kName);
  if (!parts) return {};
  NamedPath named;
  named.owner.name = parts->at(1);
  named.late = !parts->at(2).empty();
  named.owner.anonymous = parts->at(3).empty();
  named.owner.id = parts->at(3) + parts->at(4);
  named.stem = parts->at(5);
  named.inside = parts->at(6);
  if (!parts->at(7).empty()) named.kind = NamedPath::Kind::text;
  take_canvas_version(named);
  return named;
}

void settle_canvas(const std::vector<NamedPath*>& names) {
  // A file's number belongs to one file. If two names share it, it is a student's number, and the name ends
  // with digits.
  constexpr std::size_t kMostOthers = 3;
  std::map<std::string, int> files_with_number;
  for (const NamedPath* named : names)
    if (named->kind == NamedPath::Kind::hand_in) ++files_with_number[named->stem];
  for (NamedPath* named : names) {
    const std::optional<NamedPath> other = with_longer_name(*named);
    if (!other) continue;
    if (files_with_number.at(named->stem) > 1) {
      *named = *other;
      continue;
    }
    named->doubt = "may be of a group whose name ends with _" + named->owner.id + ", and of number " +
                   named->stem + "; a roster with ids and groups tells whose it is";
    for (auto next = other; next && named->others.size() < kMostOthers; next = with_longer_name(*next))
      named->others.push_back(*next);
  }
}

}  // namespace grader::intake
