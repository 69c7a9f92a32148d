// STAFF ONLY. The owners in Gradescope's export: submission_metadata.yml beside the folders
// submission_31415926/ (a Ruby program writes it, so keys have a colon in front). The text holds students'
// own names, so it is untrusted.
//
//   submission_31415926:
//     :submitters:
//     - :name: Jörg Müller
//       :sid: "4711"
//       :email: jm@u.de
//     :created_at: 2025-03-04 10:15:22.000000000 Z
#pragma once

#include <map>
#include <string>

#include "grader/intake/names/owner.h"

namespace grader::inline intake {

inline constexpr const char* kGradescopeMetadata = "submission_metadata.yml";

struct GradescopeRow {
  Owner owner;
  std::string handed_in;
};

// Returns rows by the folder's name. Throws BadInput for malformed YAML; `file` is for the message.
std::map<std::string, GradescopeRow> read_gradescope_metadata(const std::string& yaml,
                                                              const std::string& file);

}  // namespace grader::intake
