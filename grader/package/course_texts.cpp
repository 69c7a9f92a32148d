// STAFF ONLY. Makes a course's texts, line by line.
#include "grader/package/course_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "grader/text/letters.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

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

// Returns a text, Markdown, whose commands run only scenes that ship. `missing` lists scenes of other
// courses, "given/hair/scenes/wind.json". In a block of code a command gets another scene in the place of an
// example's, or it is removed; so is a block that becomes empty. A paragraph or item of a list that runs a
// missing scene, says "look at" or "study" it, or copies its file becomes a sentence that the course lacks
// it.
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

std::string in_words(double points) {
  std::ostringstream text;
  text << points;
  return text.str();
}

// Returns the exercises that a cell of a table lists, "S1, H4"; none for other texts.
std::vector<const Exercise*> exercises_in(std::string cell, const Course& course) {
  std::replace(cell.begin(), cell.end(), ',', ' ');
  std::vector<const Exercise*> found;
  std::istringstream ids(cell);
  for (std::string id; ids >> id;) {
    found.push_back(course.find(id));
    if (!found.back()) return {};
  }
  return found;
}

// True for the row of a scene, "| [pendulum](pendulum.json) | P1 | ...", with an exercise that the course
// lacks.
bool is_of_absent_scene(const std::string& line, const Course& course) {
  if (!line.starts_with("| [")) return false;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, '|');)
    for (const Exercise* exercise : exercises_in(cell, course))
      if (exercise->role == Role::absent) return true;
  return false;
}

// Returns the text below its title, or "".
std::string below_title(const std::string& path, const Exercise* own, const Course& course) {
  if (own != nullptr)
    return own->role != Role::given
               ? ""
               : "\n*In your course this exercise is given: `student/" + own->file +
                     "` is its solution. Read it beside this page; nothing of it is left to write.*\n";
  if (path != "handout/README.md" || course.exercises.empty()) return "";
  const Exercise& usual = course.exercises.front();
  const auto first = std::ranges::find_if(course.exercises, is_asked_for, &Exercise::role);
  if (first == course.exercises.end() || first->id == usual.id) return "";
  return "\n*Your course begins with " + first->id + ": read `check-" + first->id + "` for `check-" +
         usual.id + "` and `student/" + first->file + "` for `student/" + usual.file + "`.*\n";
}

std::string category_rows(const std::string& categories, const Exercise& exercise) {
  if (exercise.role == Role::absent) return "";
  const bool given = exercise.role == Role::given;
  std::string rows = given ? "Your course does not grade it. These are its categories:"
                           : in_words(exercise.points) + " points, in these categories:";
  rows += "\n\n| category | points | asks for |\n|---|---|---|\n";
  for (const auto& one : nlohmann::json::parse(categories))
    rows += "| " + one["title"].get<std::string>() + " | " +
            (given ? "-" : in_words(one["points"].get<double>())) + " | " + one["asks"].get<std::string>() +
            " |\n";
  return rows;
}

std::string mistake_lines(const std::string& categories) {
  std::string lines;
  for (const auto& one : nlohmann::json::parse(categories))
    for (const auto& row : one.value("rows", nlohmann::json::array()))
      if (row.value("usual", false))
        lines += "- *" + one["title"].get<std::string>() + ": " + row["see"].get<std::string>() + ".* " +
                 row["look"].get<std::string>() + "\n";
  return lines;
}

std::string index_row(const Exercise& exercise) {
  std::string needs;
  for (const std::string& id : exercise.prerequisites) needs += (needs.empty() ? "" : ", ") + id;
  const std::string points = exercise.role == Role::given      ? "given, solved"
                             : exercise.role == Role::optional ? in_words(exercise.points) + ", extra credit"
                                                               : in_words(exercise.points);
  return "| " + exercise.id + " | [" + exercise.title + "](../" + exercise.folder + "/text.md) | `student/" +
         exercise.file + "` | " + (needs.empty() ? "-" : needs) + " | " + points + " |\n";
}

std::string exercise_rows(const Course& course) {
  std::string rows = "| id | text | you write | needs | points |\n|---|---|---|---|---|\n";
  for (const Exercise& exercise : course.exercises)
    if (exercise.role != Role::absent) rows += index_row(exercise);
  return rows;
}

// Returns the destination of a path of the project: a folder goes with its files. Empty if it does not ship.
std::string destination_of(const std::string& path, const Shipped& shipped) {
  const auto found = shipped.lower_bound(path);
  if (found == shipped.end() || !found->first.starts_with(path)) return "";
  const std::string rest = found->first.substr(path.size());
  const bool whole = rest.empty() || path.ends_with('/') || rest.starts_with('/');
  if (!whole || !found->second.ends_with(rest)) return "";
  return found->second.substr(0, found->second.size() - rest.size());
}

// Changes links, [words](file#place), and pictures.
std::string relinked(const std::string& text, const ManifestLine& line, const Shipped& shipped) {
  static const std::regex link("!?\\[([^\\[\\]]*)\\]\\(([^)\\s#]+)(#[^)\\s]*)?\\)");
  const fs::path from = fs::path(project_path(line)).parent_path(),
                 to = fs::path(line.destination).parent_path();
  std::string result;
  auto rest = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found) {
    const std::smatch& match = *found;
    if (match[2].str().find(':') != std::string::npos) continue;  // leads elsewhere
    result.append(rest, match[0].first);
    rest = match[0].second;
    const std::string target = destination_of((from / match[2].str()).lexically_normal().string(), shipped);
    if (target.empty())
      result += match[1];
    else
      result.append(match[0].first, match[2].first)
          .append(fs::path(target).lexically_relative(to).string())
          .append(match[2].second, match[0].second);
  }
  return result.append(rest, text.end());
}

std::string absent_exercises_in(const std::string& text, const Course& course) {
  std::string list;
  for (const Exercise& exercise : course.exercises)
    if (exercise.role == Role::absent && has_word(text, exercise.id))
      list += (list.empty() ? "" : ", ") + exercise.id + " (" + exercise.title + ")";
  return list;
}

}  // namespace

std::string course_json(const std::string& text, const Course& course) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(text);
  for (nlohmann::ordered_json& entry : json["exercises"]) {
    const Exercise* exercise = course.find(entry["id"].get<std::string>());
    entry["points"] = nlohmann::ordered_json::parse(in_words(exercise->points));
    entry["role"] = to_string(exercise->role);
  }
  return json.dump(2) + "\n";
}

std::string course_categories(const std::string& text, const Exercise& exercise) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(text);
  double sum = 0;
  for (const auto& one : json) sum += one["points"].get<double>();
  for (auto& one : json) {
    const double points = one["points"].get<double>() * exercise.points / sum;
    one["points"] = nlohmann::ordered_json::parse(in_words(std::round(points * 100) / 100));
  }
  return json.dump(2) + "\n";
}

Paths absent_scenes(const std::string& table, const Course& course) {
  Paths absent;
  std::istringstream rows(table);
  for (std::string row; std::getline(rows, row);)
    if (is_of_absent_scene(row, course))
      absent.insert("hair/scenes/" + row.substr(3, row.find(']') - 3) + ".json");
  return absent;
}

std::string project_path(const ManifestLine& line) {
  return line.source.starts_with("golden/") && line.destination.starts_with("given/")
             ? line.destination.substr(6)
             : line.source;
}

std::string course_text(const std::string& text, const ManifestLine& line, const Course& course,
                        const Shipped& shipped, const Paths& missing, const std::string& categories) {
  const std::string path = project_path(line);
  const auto of = std::ranges::find_if(course.exercises, [&](const Exercise& exercise) {
    return path == "handout/" + exercise.folder + "/text.md";
  });
  const Exercise* own = of == course.exercises.end() ? nullptr : &*of;
  const bool scenes = path == "hair/scenes/scenes.md";
  std::istringstream in(text);
  std::string result;
  bool usual_rows = false;
  for (std::string read; std::getline(in, read);) {
    if (usual_rows && read.starts_with("|")) continue;
    usual_rows = read == kExerciseRows;
    if (usual_rows)
      result += exercise_rows(course);
    else if (read == kHowCounted)
      result += course.partial
                    ? "A category gives the share of its points whose checks hold, in whole points.\n"
                    : "A category gives its points if all of its checks hold.\n";
    else if (read == kCategoryRows && own != nullptr && !categories.empty())
      result += category_rows(categories, *own);
    else if (read == kMistakes && own != nullptr && !categories.empty())
      result += mistake_lines(categories);
    else if (!scenes || !is_of_absent_scene(read, course))
      result += read + "\n";
    if (read.starts_with("# ")) result += below_title(path, own, course);
  }
  result = relinked(result, line, shipped);
  Paths destinations;
  for (const auto& [from, to] : shipped) destinations.insert(to);
  result = with_present_scenes(result, destinations, missing);
  if (const std::string absent = absent_exercises_in(result, course); !absent.empty())
    result += "\n*Not part of your course: " + absent + ".*\n";
  return result;
}

}  // namespace grader::package
