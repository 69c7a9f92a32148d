// STAFF ONLY. Opens a class that comes as several downloads, one for each section, in a folder or an archive,
// as if they were folders. A hand-in can look like a download, so one student's archive must not decide: all
// archives are downloads, or none is opened.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "grader/intake/archives/container.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

// Opens the archive that is this entry of the list. Throws Refused.
using OpenEntry = std::function<std::unique_ptr<Container>(std::size_t entry)>;

// `outer` has the entries `list`, whose names are settled, as the result's are. Returns null unless at least
// `least` archives lie side by side and are downloads of one system: of `said`, if that is not null.
std::shared_ptr<Container> open_sections(std::shared_ptr<Container> outer, std::vector<Entry> list,
                                         std::size_t least, const System* said, const OpenEntry& open);

}  // namespace grader::intake
