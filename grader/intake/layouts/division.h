// STAFF ONLY. Divides a learning system's download among those who handed in. Names decide, and of these only
// the ones directly in the download's folder: a student can choose all others. Every file is somebody's, made
// by the system, an older one, or left over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/intake/accounted.h"
#include "grader/intake/container.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

struct HandIn {
  Owner owner;
  std::string path;       // the name that says whose it is, below the container
  std::string handed_in;  // of the newest attempt, which counts
  bool late = false;
  std::vector<std::size_t> entries = {};               // of the newest attempt
  std::vector<std::string> doubts = {}, remarks = {};  // to look at; to know
};

struct Division {
  const System* system = nullptr;
  std::vector<HandIn> hand_ins = {};  // by their owners' names
  struct Aside {
    std::size_t entry;
    Accounted::As as;
    std::string reason;
    std::size_t hand_in = kNobody;
  };
  static constexpr std::size_t kNobody = ~std::size_t{0};
  std::vector<Aside> aside = {};  // files that belong to no hand-in that counts
};

// Empty if no system knows most of the names. `said`: the system that --from names, which needs to know one.
// A flat file's `path` in the list becomes FOLDER/NAME, as if it lay in its hand-in's folder. `container`:
// its name. The download may have sections: folders that are all downloads of one system, and none of them is
// called as a hand-in is. Somebody in two of them has one hand-in.
std::optional<Division> divide(std::vector<Entry>& list, const std::string& container, const System* said,
                               bool may_have_sections = false, const KnownOwner& known = {});

}  // namespace grader::intake
