// STAFF ONLY. Autolab's download, a file for each hand-in (submissions_controller.rb):
//
//   joerg@u.de_3_lab.tar             an e-mail address, the version, the file's name in this course
//   3_so@u.ie_my_lab.c               the same if the file's name has a "_"
//   annotated_so@u.ie_1_lab.tar      with a grader's notes in it
#include "grader/intake/layouts/match.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

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

}  // namespace grader::intake
