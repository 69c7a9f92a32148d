// STAFF ONLY.
#include "grader/tests/broken_links.h"

#include <map>
#include <set>

#include "grader/tests/bytes_of.h"
#include "hair/io/plot/tests/parsed.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

struct Page {
  std::set<std::string> ids;
  std::vector<std::string> links;
};

Page read_page(const fs::path& file) {
  Page page;
  const auto every = [](const hair::plot::Element&) { return true; };
  for (const hair::plot::Element& element : hair::plot::parse(bytes_of(file)).all(every))
    for (const auto& [name, value] : element.attributes) {
      if (name == "id") page.ids.insert(value);
      if (name == "href" || name == "src") page.links.push_back(value);
    }
  return page;
}

// "a%20b" is "a b".
std::string without_escapes(const std::string& link) {
  std::string plain;
  for (std::size_t i = 0; i < link.size(); ++i) {
    const bool escaped = link[i] == '%' && i + 2 < link.size();
    plain += escaped ? static_cast<char>(std::stoi(link.substr(i + 1, 2), nullptr, 16)) : link[i];
    if (escaped) i += 2;
  }
  return plain;
}

}  // namespace

std::vector<std::string> broken_links(const fs::path& folder) {
  std::map<fs::path, Page> pages;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".html") pages[entry.path()] = read_page(entry.path());
  std::vector<std::string> broken;
  for (const auto& [file, page] : pages)
    for (const std::string& link : page.links) {
      if (link.starts_with("data:") || link.find("://") != std::string::npos) continue;
      const std::size_t end = std::min(link.find('#'), link.size());
      const std::string path = without_escapes(link.substr(0, end));
      const fs::path target = path.empty() ? file : (file.parent_path() / path).lexically_normal();
      const auto there = pages.find(target);
      const bool found = end == link.size()
                             ? fs::exists(target)
                             : there != pages.end() && there->second.ids.contains(link.substr(end + 1));
      if (!found) broken.push_back(fs::relative(file, folder).string() + ": " + link);
    }
  return broken;
}

}  // namespace grader
