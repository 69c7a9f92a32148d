// STAFF ONLY. Replaces or removes commands in texts whose scene the course lacks.
#include "grader/package/course_scenes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

namespace grader::inline package {
namespace {

// The name is the last group that matched.
const std::regex& playing() {
  static const std::regex all(
      "hairlab (?:run|view|study|stability)\\s+([a-z][a-z-]*)(?![a-z./-])|hair/scenes/([a-z-]+)\\.json"
      "|(?:look at|[Ss]tudy)\\s+`([a-z-]+)`");
  return all;
}

std::string file_of(const std::string& scene) {
  return "given/hair/scenes/" + scene + ".json";
}

// Returns the first scene in the text's commands that the course lacks, or an empty text.
std::string missing_scene_in(const std::string& text, const Paths& missing) {
  for (std::sregex_iterator found(text.begin(), text.end(), playing()), end; found != end; ++found)
    for (std::size_t group = 1; group < found->size(); ++group)
      if ((*found)[group].matched && missing.contains(file_of((*found)[group]))) return (*found)[group];
  return {};
}

// Changes a line of a block of code; returns nothing if no scene can stand in.
std::optional<std::string> command_line(const std::string& line, const Paths& shipped, const Paths& missing) {
  const std::string scene = missing_scene_in(line, missing);
  if (scene.empty()) return line;
  // These scenes can replace an example of a command for any hair; the last ones have no strands with
  // springs, and can only be viewed.
  static constexpr std::array kExamples{"strand-swing", "head-of-hair"};
  static constexpr std::array kStandIns{"long-straight", "wavy",        "skip-springs", "rigid-links",
                                        "pendulum",      "super-helix", "rod-pendulum", "cloth-patch"};
  constexpr std::size_t kWithStrands = 4;
  const bool played =
      line.find("hairlab run ") != std::string::npos || line.find("hairlab view ") != std::string::npos;
  const auto end = played ? kStandIns.end() : kStandIns.begin() + kWithStrands;
  const auto other =
      std::find_if(kStandIns.begin(), end, [&](const char* name) { return shipped.contains(file_of(name)); });
  if (std::find(kExamples.begin(), kExamples.end(), scene) == kExamples.end() || other == end) return {};
  std::string changed = line;
  changed.replace(changed.find(scene), scene.size(), *other);
  // The duration of the example's study does not hold for another scene.
  static const std::regex duration(" *#.*([0-9]|minute|second).*");
  if (!played) changed = std::regex_replace(changed, duration, "");
  return changed;
}

// A paragraph, an item of a list or a row of a table, with its lines.
std::string prose(const std::string& text, const Paths& missing) {
  const std::string scene = missing_scene_in(text, missing);
  if (scene.empty()) return text;
  static const std::regex item("^\\s*(?:[0-9]+\\.|-) ");
  std::smatch marker;
  return (std::regex_search(text, marker, item) ? marker.str() : "") + "*(Not in your course: the scene " +
         scene + ".)*\n";
}

bool begins_alone(const std::string& line) {
  static const std::regex start("\\s*([0-9]+\\.|-) .*|[|#].*|\\s*");
  return std::regex_match(line, start);
}

}  // namespace

std::string with_present_scenes(const std::string& text, const Paths& shipped, const Paths& missing) {
  std::string result, paragraph, block;
  bool in_block = false;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const bool fence = line.find_first_not_of(' ') != std::string::npos &&
                       line.compare(line.find_first_not_of(' '), 3, "```") == 0;
    if (fence || (!in_block && begins_alone(line))) {
      result += prose(paragraph, missing);
      paragraph.clear();
    }
    if (!in_block && line.find_first_not_of(' ') == std::string::npos) {
      result += line + "\n";
      continue;
    }
    if (fence && !in_block) {
      block = line + "\n";
      in_block = true;
    } else if (fence) {
      const bool empty = std::count(block.begin(), block.end(), '\n') == 1;
      if (!empty) result += block + line + "\n";
      in_block = false;
    } else if (in_block) {
      if (const auto kept = command_line(line, shipped, missing)) block += *kept + "\n";
    } else {
      paragraph += line + "\n";
    }
  }
  return result + (in_block ? block : prose(paragraph, missing));
}

}  // namespace grader::package
