// STAFF ONLY. Tests that the picture shows folders that are there, and that includes follow the lists of
// folders.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;
using Names = std::vector<std::string>;

// The bold texts of the picture are folders, and its title.
TEST(Architecture, ItsPictureShowsFoldersThatAreThere) {
  const std::string picture = hair::bytes_of(kProject / "grader/architecture.svg");
  static const std::regex folder("bold\">([a-z_/]+/)<");
  std::sregex_iterator found(picture.begin(), picture.end(), folder);
  EXPECT_GE(std::distance(found, {}), 20);
  for (; found != std::sregex_iterator(); ++found)
    EXPECT_TRUE(fs::is_directory(kProject / (*found)[1].str())) << (*found)[1];
}

// The first words of the lines of a document's first block of code: its list of folders.
Names listed(const std::string& document) {
  std::istringstream text(hair::bytes_of(kProject / document));
  Names names;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      if (inside) break;
      inside = true;
    } else if (inside) {
      names.push_back(line.substr(0, line.find(' ')));
    }
  }
  return names;
}

// The folders of the project in the order of their needs. In a name, * is a word without "/".
Names order() {
  Names all;
  for (const std::string& name : listed("grader/ARCHITECTURE.md")) {
    if (name != "hair/") {
      all.push_back(name);
      continue;
    }
    for (const std::string& folder : listed("hair/README.md")) all.push_back("hair/" + folder);
  }
  return all;
}

// A folder's name stands for all files below it, unless a longer name stands for them, too.
std::size_t place_of(const std::string& path, const Names& order) {
  std::size_t found = order.size(), longest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::string& name = order[i];
    std::size_t end = path.size();
    if (name.ends_with('/')) {
      end = 0;
      for (auto slashes = std::ranges::count(name, '/'); slashes > 0 && end != std::string::npos; --slashes)
        end = path.find('/', end + (end > 0 ? 1 : 0));
      if (end == std::string::npos) continue;
      ++end;
    }
    if (name.size() > longest && fnmatch(name.c_str(), path.substr(0, end).c_str(), FNM_PATHNAME) == 0) {
      found = i;
      longest = name.size();
    }
  }
  return found;
}

// By source file: the project's files that it includes.
std::map<std::string, Names> read_includes() {
  std::map<std::string, Names> includes;
  for (const char* top : {"solver", "particles", "hair", "handout", "reference", "grader"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kProject / top)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      Names& found = includes[entry.path().lexically_relative(kProject).generic_string()];
      std::istringstream text(hair::bytes_of(entry.path()));
      for (std::string line; std::getline(text, line);)
        if (const std::string begin = "#include \""; line.starts_with(begin))
          found.push_back(line.substr(begin.size(), line.rfind('"') - begin.size()));
    }
  return includes;
}

bool is_for_tests(const std::string& path) {
  const auto has = [&](const char* part) { return path.find(part) != std::string::npos; };
  return has("_test.") || has("/test_") || has("_fuzz.") || has("_for_tests.") || has("/tests/");
}

TEST(Includes, PointUpTheListsOfFolders) {
  const Names folders = order();
  const std::map<std::string, Names> includes = read_includes();
  std::set<std::size_t> used;
  for (const auto& [path, included] : includes) {
    const std::size_t own = place_of(path, folders);
    ASSERT_LT(own, folders.size()) << path
                                   << " lies in no folder that ARCHITECTURE.md or hair/README.md lists";
    used.insert(own);
    for (const std::string& other : included)
      if (includes.contains(other) && !is_for_tests(path)) {
        EXPECT_LE(place_of(other, folders), own)
            << path << " includes " << other << ", which is listed below " << folders[own];
      }
  }
  for (std::size_t i = 0; i < folders.size(); ++i)
    EXPECT_TRUE(used.contains(i)) << folders[i] << " has no file";
}

}  // namespace
}  // namespace grader
