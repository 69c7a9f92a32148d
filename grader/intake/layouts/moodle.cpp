// STAFF ONLY. Moodle's download (mod/assign/classes/downloader.php): folders, or flat files by the teacher's
// choice. Before Moodle 4.1 the names of folders end with "_".
// Jane Doe_4711_assignsubmission_file/main.cpp    a name, the number in this assignment
// Jane Doe_4711_assignsubmission_file_main.cpp    flat
// Jane Doe_4711_assignsubmission_onlinetext/onlinetext.html    typed text
// Participant_4713_assignsubmission_file/         blind; the word is the site's language's
// Default group_assignsubmission_file/            students of no group: it has no number
// A name has no "_": Moodle writes a blank for it. There is no time and no mark of late ones.
#include <set>

#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

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

void settle_moodle(std::vector<NamedPath*>& names) {
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

}  // namespace grader::intake
