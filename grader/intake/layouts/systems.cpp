// STAFF ONLY. The names that learning systems give in their downloads, and a row for each system.
#include "grader/intake/layouts/system.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "grader/intake/layouts/gradescope.h"
#include "grader/intake/layouts/match.h"

namespace grader::inline intake {
namespace {

using Names = std::vector<NamedPath*>;

// Takes the ids behind the common beginning of all stems, which ends with `end`.
void take_ids_behind_the_same(const Names& names, char end) {
  std::string same = names.front()->stem;
  for (const NamedPath* named : names)
    same.resize(static_cast<std::size_t>(std::ranges::mismatch(same, named->stem).in1 - same.begin()));
  same.resize(same.rfind(end) + 1);
  for (NamedPath* named : names)
    if (!same.empty() && named->stem.size() > same.size()) named->owner.id = named->stem.substr(same.size());
}

// Gradescope's export (gradescope.h): folders without names, and a file with the names.
std::optional<NamedPath> read_gradescope(std::string_view name, bool is_folder, const Around&) {
  static const std::regex kName("submission_([0-9]+)");
  NamedPath named;
  if (!is_folder && name == kGradescopeMetadata) {
    named.kind = NamedPath::Kind::made;
    return named;
  }
  const auto parts = groups_of(name, kName);
  if (!parts || !is_folder) return {};
  named.owner.id = parts->at(1);
  named.stem = name;
  return named;
}

// Moodle's download (mod/assign/classes/downloader.php): folders, or flat files by the teacher's
// choice. Before Moodle 4.1 the names of folders end with "_".
// Jane Doe_4711_assignsubmission_file/main.cpp    a name, the number in this assignment
// Jane Doe_4711_assignsubmission_file_main.cpp    flat
// Jane Doe_4711_assignsubmission_onlinetext/onlinetext.html    typed text
// Participant_4713_assignsubmission_file/         blind; the word is the site's language's
// Default group_assignsubmission_file/            students of no group: it has no number
// A name has no "_": Moodle writes a blank for it. There is no time and no mark of late ones.
std::optional<NamedPath> read_moodle(std::string_view name, bool is_folder, const Around&) {
  static const std::regex kName("(.+?)(?:_([0-9]+))?_assignsubmission_(file|onlinetext)(?:_(.*))?");
  const auto parts = groups_of(name, kName);
  if (!parts || (!is_folder && parts->at(4).empty())) return {};
  NamedPath named;
  named.owner.name = parts->at(1);
  named.owner.id = parts->at(2);
  named.owner.group = named.owner.id.empty();
  named.owner.anonymous = named.owner.name == "Participant";
  if (!is_folder) named.inside = parts->at(4);
  if (parts->at(3) == "onlinetext") named.kind = NamedPath::Kind::text;
  return named;
}

void settle_moodle(const Names& names) {
  std::set<std::string> words, numbers;
  bool teams = false;
  for (const NamedPath* named : names) {
    words.insert(named->owner.name);
    numbers.insert(named->owner.id);
    teams = teams || named->owner.group;
  }
  const bool blind = words.size() == 1 && numbers.size() > 1;  // has one word, in any language
  for (NamedPath* named : names) {
    named->owner.anonymous = (named->owner.anonymous || blind) && !teams;
    named->owner.group = teams;
  }
}

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

// Brightspace's download, folders or flat files, with an index of its own:
//
//   5917-716031 - Jane Doe - May 18, 2025 1224 PM/main.cpp     two numbers, a name, the time of the hand-in
//   5917-716031 - Jane Doe - May 18, 2025 1224 PM - main.cpp   flat
//   index.html
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

void settle_brightspace(const Names& names) {
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

// Blackboard's download, flat files, with a note for each attempt:
//
//   Lab 3_so12_attempt_2025-03-04-10-15-22_main.cpp   the assignment's title, a user name, the attempt's time
//   Lab 3_so12_attempt_2025-03-04-10-15-22.txt        the note
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

void settle_blackboard(const Names& names) {
  take_ids_behind_the_same(names, '_');  // user names may hold a "_", and the title is that of all names
}

// Autolab's download, a file for each hand-in (submissions_controller.rb):
//
//   joerg@u.de_3_lab.tar             an e-mail address, the version, the file's name in this course
//   3_so@u.ie_my_lab.c               the same if the file's name has a "_"
//   annotated_so@u.ie_1_lab.tar      with a grader's notes in it
std::optional<NamedPath> read_autolab(std::string_view name, bool is_folder, const Around&) {
  // A host's name has no "_".
  static const std::regex kAddressFirst("(annotated_)?([^/@]+@[^_@]+)_([0-9]{1,6})_(.+)"),
      kVersionFirst("(annotated_)?([0-9]{1,6})_([^/@]+@[^_@]+)_(.+)");
  if (is_folder) return {};
  NamedPath named;
  if (const auto version_first = groups_of(name, kVersionFirst)) {
    named.version = std::stoi(version_first->at(2));
    named.owner.email = version_first->at(3);
    named.inside = version_first->at(4);
  } else if (const auto address_first = groups_of(name, kAddressFirst)) {
    named.version = std::stoi(address_first->at(3));
    named.owner.email = address_first->at(2);
    named.inside = address_first->at(4);
  } else {
    return {};
  }
  named.owner.id = named.owner.email;
  if (name.starts_with("annotated_")) named.kind = NamedPath::Kind::text;
  return named;
}

// Clones of gh-classroom: lab3-submissions/lab3-jmueller/, a folder for each repository with a login or a
// team's name. Its grades.csv may lie beside them.
std::optional<NamedPath> read_classroom(std::string_view name, bool is_folder, const Around& around) {
  constexpr std::string_view kClonedInto = "-submissions";
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

// If the folder around them has another name, the assignment's is the common beginning of all of them.
void settle_classroom(const Names& names) {
  Names unsettled;
  for (NamedPath* named : names)
    if (!named->stem.empty()) unsettled.push_back(named);
  if (unsettled.size() > 1) take_ids_behind_the_same(unsettled, '-');
}

}  // namespace

const std::vector<System>& systems() {
  static const std::vector<System> all{
      {.name = "gradescope",
       .shown = "Gradescope",
       .example = "submission_31415926/, beside submission_metadata.yml",
       .read = read_gradescope},
      {.name = "moodle",
       .shown = "Moodle",
       .example = "Jane Doe_4711_assignsubmission_file/",
       .read = read_moodle,
       .settle = settle_moodle},
      {.name = "brightspace",
       .shown = "Brightspace",
       .example = "5917-716031 - Jane Doe - May 18, 2025 1224 PM/",
       .read = read_brightspace,
       .settle = settle_brightspace},
      {.name = "blackboard",
       .shown = "Blackboard",
       .example = "Lab 3_so12_attempt_2025-03-04-10-15-22_main.cpp",
       .read = read_blackboard,
       .settle = settle_blackboard},
      {.name = "autolab", .shown = "Autolab", .example = "joerg@u.de_3_lab.tar", .read = read_autolab},
      {.name = "canvas",
       .shown = "Canvas",
       .example = "doejane_4711_90001_main.cpp",
       .read = read_canvas,
       .settle = settle_canvas,
       .files_have_versions = true},
      {.name = "classroom",
       .shown = "GitHub Classroom",
       .example = "lab3-submissions/lab3-jmueller/",
       .read = read_classroom,
       .settle = settle_classroom},
  };
  return all;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const System& system : systems()) names.emplace_back(system.name);
  names.emplace_back("folders");
  return names;
}

const System* system_called(std::string_view name) {
  const auto found = std::ranges::find(systems(), name, &System::name);
  return found == systems().end() ? nullptr : &*found;
}

void settle_readings(NamedPath& named, std::string_view system, const KnownOwner& known) {
  if (named.others.empty() || !known) return;
  int best = known(named.owner, system);
  const NamedPath* taken = &named;
  bool alone = best > 0;
  for (const NamedPath& other : named.others) {
    const int well = known(other.owner, system);
    if (well == best) alone = false;
    if (well <= best) continue;
    best = well;
    taken = &other;
    alone = true;
  }
  if (!alone) return;
  const bool proven = best > 1 || taken == &named;
  NamedPath settled = *taken;
  settled.doubt = proven ? "" : named.doubt + "; this roster has the number's owner, and no such group";
  named = std::move(settled);
}

std::optional<Told> told_by_name(std::string_view name, bool is_folder, const KnownOwner& known) {
  for (const System& system : systems()) {
    std::optional<NamedPath> named = system.read(name, is_folder, {});
    if (!named || named->kind == NamedPath::Kind::made || system.name == "gradescope") continue;
    if (system.settle) {
      std::vector<NamedPath*> alone{&*named};
      system.settle(alone);
    }
    settle_readings(*named, system.name, known);
    return Told{&system, std::move(*named)};
  }
  return {};
}

}  // namespace grader::intake
