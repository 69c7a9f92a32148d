// STAFF ONLY. A class that comes as several downloads, one of each section, in a folder or an archive: they
// are opened as if they were folders. A hand-in can look like a download, so one student's archive must not
// decide: all archives are downloads, or none is opened.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "grader/intake/container.h"
#include "grader/intake/layouts/system.h"

namespace grader::inline intake {

// Opens the archive that is this entry of the list. Throws Refused.
using OpenEntry = std::function<std::unique_ptr<Container>(std::size_t entry)>;

// `outer` has the entries `list`, whose names are settled; what is returned has settled names, too. Null
// unless there are `least` archives, which lie beside each other and are downloads of one system: of `said`,
// if that is not null.
std::shared_ptr<Container> open_sections(std::shared_ptr<Container> outer, std::vector<Entry> list,
                                         std::size_t least, const System* said, const OpenEntry& open);

}  // namespace grader::intake
