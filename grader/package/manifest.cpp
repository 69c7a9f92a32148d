// STAFF ONLY.
#include "grader/package/manifest.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "grader/course/input.h"

namespace grader {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string read_path(const std::string& text, const std::string& where) {
  const std::filesystem::path path = text;
  if (text.empty() || path.is_absolute() || path.lexically_normal() != path || *path.begin() == "..")
    throw BadInput(where + ": \"" + text + "\" is no path; write one like handout/README.md, without \"..\"");
  return text;
}

std::string default_destination(const std::string& source) {
  const std::string handout = "handout/";
  return source.starts_with(handout) ? source.substr(handout.size()) : source;
}

}  // namespace

std::vector<ManifestLine> read_manifest(const std::filesystem::path& file, const Course& course) {
  std::ifstream in(file);
  if (!in) throw BadInput(file.string() + ": can't be read; it must list the files of the handout");
  std::vector<ManifestLine> lines;
  std::map<std::string, std::string> taken;  // destination -> where
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::string where = file.string() + ":" + std::to_string(number);
    text = trimmed(text);
    if (text.empty() || text[0] == '#') continue;

    bool absent = false;
    for (auto colon = text.find(':'); colon != std::string::npos; colon = text.find(':')) {
      const std::string id = trimmed(text.substr(0, colon));
      const Exercise* const exercise = course.find(id);
      if (!exercise)
        throw BadInput(where + ": there is no exercise \"" + id + "\"; write one of exercises.json");
      absent = absent || exercise->role == Role::absent;
      text = trimmed(text.substr(colon + 1));
    }
    const auto arrow = text.find("->");
    ManifestLine line;
    line.where = where;
    line.source = read_path(trimmed(text.substr(0, arrow)), where);
    line.destination = arrow == std::string::npos ? default_destination(line.source)
                                                  : read_path(trimmed(text.substr(arrow + 2)), where);
    const auto [other, is_new] = taken.emplace(line.destination, where);
    if (!is_new)
      throw BadInput(where + ": " + line.destination + " is already the destination of " + other->second +
                     "; each file needs its own");
    if (!absent) lines.push_back(line);
  }
  return lines;
}

}  // namespace grader
