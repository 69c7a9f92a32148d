// STAFF ONLY. Finds broken links of pages, for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

// Reads all pages of a folder, and follows their links and pictures: returns "index.html: staff/ada.html#S1"
// for each target that is missing or outside of the folder. Links to other sites and pictures inside of a
// page are left out. A folder without pages is broken, too. Throws std::runtime_error for a malformed page.
std::vector<std::string> broken_links(const std::filesystem::path& folder);

}  // namespace grader
