// STAFF ONLY. Finds links of pages that lead nowhere.
#include "grader/tests/broken_links.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "hair/io/files/read_file.h"
#include "hair/io/plot/test_parsed.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

struct Page {
  std::set<std::string> ids;
  std::vector<std::string> links;
};

void read(const hair::plot::Element& element, Page& page) {
  for (const auto& [name, value] : element.attributes) {
    if (name == "id") page.ids.insert(value);
    if (name == "href" || name == "src") page.links.push_back(value);
  }
  for (const hair::plot::Element& within : element.elements) read(within, page);
}

// "a%20b" is "a b".
std::string without_escapes(const std::string& link) {
  std::string plain;
  for (std::size_t i = 0; i < link.size(); ++i) {
    int code = 0;
    const char* digits = link.data() + i + 1;
    if (link[i] == '%' && i + 2 < link.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += link[i];
    }
  }
  return plain;
}

bool leads_nowhere_here(const std::string& link) {
  return link.starts_with("data:") || link.starts_with("mailto:") || link.find("://") != std::string::npos;
}

}  // namespace

std::vector<std::string> broken_links(const fs::path& folder) {
  std::map<fs::path, Page> pages;  // by their paths in the folder
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".html")
      read(hair::plot::parse_page(hair::bytes_of(entry.path())), pages[fs::relative(entry.path(), folder)]);
  if (pages.empty()) return {folder.string() + ": no pages"};

  std::vector<std::string> broken;
  for (const auto& [file, page] : pages)
    for (const std::string& link : page.links) {
      if (leads_nowhere_here(link)) continue;
      const std::size_t mark = std::min(link.find('#'), link.size());
      const std::string path = without_escapes(link.substr(0, mark));
      const fs::path target = path.empty() ? file : (file.parent_path() / path).lexically_normal();
      const bool inside = target.is_relative() && *target.begin() != "..";
      const auto linked = pages.find(target);
      // "#time=0.5" names a state of a page that its script shows.
      const bool is_whole = mark == link.size() || link.find('=', mark) != link.npos;
      const bool found = is_whole ? fs::exists(folder / target)
                                  : linked != pages.end() &&
                                        linked->second.ids.contains(without_escapes(link.substr(mark + 1)));
      if (!inside || !found) broken.push_back(file.string() + ": " + link);
    }
  return broken;
}

}  // namespace grader
