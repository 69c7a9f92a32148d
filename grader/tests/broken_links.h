// STAFF ONLY. Links of pages, for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

// Reads all pages of a folder, and follows what they link to and show: "index.html: staff/ada.html#S1" for
// each place that is not there, or outside of the folder. Links to other sites and pictures inside of a page
// are left out. A folder without pages is broken, too. Throws std::runtime_error for a page that is not well
// formed.
std::vector<std::string> broken_links(const std::filesystem::path& folder);

}  // namespace grader
