// STAFF ONLY. Divides a learning system's download among the students who handed in. Only names directly in
// the download's folder decide: a student can choose all others. Each file belongs to a student, is made by
// the system, is older than another one, or is left over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/intake/archives/accounted.h"
#include "grader/intake/archives/container.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

struct FoundHandIn {
  Owner owner;
  std::string path;       // is the name, below the container, that identifies the owner
  std::string handed_in;  // is the newest attempt's time, which counts
  bool late = false;
  std::vector<std::size_t> entries = {};               // belong to the newest attempt
  std::vector<std::string> doubts = {}, remarks = {};  // only doubts need a look
};

struct Division {
  const System* system = nullptr;
  std::vector<FoundHandIn> hand_ins = {};  // sorted by their owners' names
  struct Aside {
    std::size_t entry;
    Accounted::As as;
    std::string reason;
    std::size_t hand_in = kNobody;
  };
  static constexpr std::size_t kNobody = ~std::size_t{0};
  std::vector<Aside> aside = {};  // files that belong to no hand-in that counts
};

// Returns nothing if no system knows most of the names. `said` is the system of --from, which needs to know
// one. A flat file's `path` in the list becomes FOLDER/NAME, as if it lay in its hand-in's folder.
// `container` is its name. The download may have sections: folders that are all downloads of one system, and
// none of them has a hand-in's name. A student in two sections has one hand-in.
std::optional<Division> divide(std::vector<Entry>& list, const std::string& container, const System* said,
                               bool may_have_sections = false, const KnownOwner& known = {});

}  // namespace grader::intake
