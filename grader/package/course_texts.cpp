// STAFF ONLY. Makes a course's texts, line by line.
#include "grader/package/course_texts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>

#include "grader/package/course_scenes.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

std::string in_words(double points) {
  std::ostringstream text;
  text << points;
  return text.str();
}

// The exercises that a cell of a table lists, "S1, H4"; none if it says something else.
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

// Tells the row of a scene, "| [pendulum](pendulum.json) | P1 | ...", that calls an exercise which the course lacks.
bool is_of_absent_scene(const std::string& line, const Course& course) {
  if (!line.starts_with("| [")) return false;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, '|');)
    for (const Exercise* exercise : exercises_in(cell, course))
      if (exercise->role == Role::absent) return true;
  return false;
}

// "30 points, in these categories:" and the second cells of the table below it. A course gives categories their shares.
class Points {
 public:
  explicit Points(const Exercise& exercise)
      : points_(exercise.points), given_(exercise.role == Role::given) {}

  std::string line(const std::string& text) {
    static const std::regex total("([0-9.]+) points, in these categories.*"),
        row("(\\| .+? \\| )([0-9.]+)( \\|.*)");
    std::smatch match;
    if (std::regex_match(text, match, total)) {
      share_ = std::max(points_ / std::stod(match[1]), 1e-9);  // a course may give 0 points
      return given_ ? "Your course does not grade it. These are its categories:"
                    : in_words(points_) + " points, in these categories:";
    }
    if (text.starts_with("#")) share_ = 0;
    if (share_ > 0 && std::regex_match(text, match, row))
      return match[1].str() +
             (given_ ? "-" : in_words(std::round(std::stod(match[2]) * share_ * 100) / 100)) + match[3].str();
    return text;
  }

 private:
  double points_;
  bool given_;
  double share_ = 0;  // above 0 from the line of the points to the section's end
};

constexpr std::string_view kAllOrNothing = "gives them if all of its checks hold.",
                           kPartial = "gives the share of them whose checks hold, in whole points.";

std::string with_partial_points(std::string text) {
  if (const auto at = text.find(kAllOrNothing); at != std::string::npos)
    text.replace(at, kAllOrNothing.size(), kPartial);
  return text;
}

bool is_to_write(const Exercise& exercise) {
  return exercise.role == Role::assigned || exercise.role == Role::optional;
}

// What an exercise's text says of writing it, and those that it calls. A text opens with "Write ..." below its title, may have a
// paragraph "This exercise calls ...", which asks to write those first, and has the section "Hints, in steps".
class Writing {
 public:
  Writing(const Exercise& exercise, const Course& course) : given_(exercise.role == Role::given) {
    calls_given_ = std::none_of(exercise.prerequisites.begin(), exercise.prerequisites.end(),
                                [&](const std::string& id) {
                                  const Exercise* called = course.find(id);
                                  return called && is_to_write(*called);
                                });
  }

  // Nothing: the line goes.
  std::optional<std::string> line(const std::string& text) {
    if (text.starts_with("## ")) {
      opening_ = false;
      hints_ = given_ && text == "## Hints, in steps";
    }
    if (text.starts_with("This exercise calls ")) calls_ = true;
    const bool goes = hints_ || (calls_ && (given_ || calls_given_));
    if (text.empty()) calls_ = false;
    if (goes) return {};
    if (!given_ || !opening_ || !text.starts_with(kWrite)) return text;
    opening_ = false;
    return "Given: " + text.substr(kWrite.size());
  }

 private:
  static constexpr std::string_view kWrite = "Write ";
  bool given_, calls_given_ = false;
  bool opening_ = true, calls_ = false, hints_ = false;  // where the line is
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

// The README, whose first ten minutes are of the first exercise, for a course in which that one is not to be written.
std::string with_first_exercise(std::string text, const Course& course) {
  if (course.exercises.empty()) return text;
  const Exercise& usual = course.exercises.front();
  const auto first = std::find_if(course.exercises.begin(), course.exercises.end(), is_to_write);
  if (first == course.exercises.end() || first->id == usual.id) return text;
  if (usual.functions.empty() || first->functions.empty()) return text;
  text = replaced(text, usual.id + " " + hair::plain_name(usual.functions.front()),
                  first->id + " " + hair::plain_name(first->functions.front()));
  text = replaced(text, "check-" + usual.id, "check-" + first->id);
  text = replaced(text, "student/" + usual.file, "student/" + first->file);
  return replaced(text, usual.text, first->text);
}

// [words](file#place) whose file does not ship: the words. Pictures, ![words](file), too.
std::string without_dead_links(const std::string& text, const std::string& destination,
                               const Paths& shipped) {
  static const std::regex link("!?\\[([^\\]\\n]*)\\]\\(([^)\\s#]+)(#[^)\\s]*)?\\)");
  std::string result;
  auto rest = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found) {
    result.append(rest, text.begin() + found->position());
    rest = text.begin() + found->position() + found->length();
    const std::string target = (*found)[2];
    const fs::path path = (fs::path(destination).parent_path() / target).lexically_normal();
    const bool elsewhere = target.find(':') != std::string::npos;
    // A folder's path ends with a stroke, or it is the start of a file's.
    const auto below = shipped.lower_bound(path.string());
    const bool there = below != shipped.end() && below->starts_with(path.string());
    result += elsewhere || there ? found->str() : (*found)[1].str();
  }
  return result.append(rest, text.end());
}

// Whether the text says the id as a word of its own.
bool names(const std::string& text, const std::string& id) {
  const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t at = text.find(id); at != std::string::npos; at = text.find(id, at + 1)) {
    const std::size_t after = at + id.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (after == text.size() || !is_of_word(text[after])))
      return true;
  }
  return false;
}

std::string absent_exercises_in(const std::string& text, const Course& course) {
  std::string list;
  for (const Exercise& exercise : course.exercises)
    if (exercise.role == Role::absent && names(text, exercise.id))
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

Paths absent_scenes(const std::string& table, const Course& course) {
  Paths absent;
  std::istringstream rows(table);
  for (std::string row; std::getline(rows, row);)
    if (is_of_absent_scene(row, course))
      absent.insert("hair/scenes/" + row.substr(3, row.find(']') - 3) + ".json");
  return absent;
}

std::string course_text(const std::string& text, const std::string& destination, const Course& course,
                        const Paths& shipped, const Paths& missing) {
  const Exercise* own = nullptr;
  for (const Exercise& exercise : course.exercises)
    if (exercise.text == destination) own = &exercise;
  std::optional<Points> points;
  std::optional<Writing> writing;
  if (own) {
    points.emplace(*own);
    writing.emplace(*own, course);
  }
  const bool index = destination == "assignment/README.md",
             scenes = destination == "given/hair/scenes/scenes.md";

  std::istringstream in(course.partial ? with_partial_points(text) : text);
  std::string result;
  for (std::string line; std::getline(in, line);) {
    if (index && line == kExerciseRows) {
      for (const Exercise& exercise : course.exercises)
        if (exercise.role != Role::absent) result += index_row(exercise) + "\n";
      continue;
    }
    if (scenes && is_of_absent_scene(line, course)) continue;
    const std::optional<std::string> kept = writing ? writing->line(line) : line;
    if (!kept) continue;
    result += (points ? points->line(*kept) : *kept) + "\n";
    if (own && own->role == Role::given && line.starts_with("# "))
      result += "\n*In your course this exercise is given: `student/" + own->file +
                "` is its solution. Read it beside this page; nothing of it is left to write.*\n";
  }
  if (destination == "README.md") result = with_first_exercise(result, course);
  result = with_present_scenes(result, shipped, missing);
  result = without_dead_links(result, destination, shipped);
  if (const std::string absent = absent_exercises_in(result, course); !absent.empty())
    result += "\n*Not part of your course: " + absent + ".*\n";
  return result;
}

std::string index_row(const Exercise& exercise) {
  std::string needs;
  for (const std::string& id : exercise.prerequisites) needs += (needs.empty() ? "" : ", ") + id;
  const std::string points = exercise.role == Role::given      ? "given, solved"
                             : exercise.role == Role::optional ? in_words(exercise.points) + ", extra credit"
                                                               : in_words(exercise.points);
  return "| " + exercise.id + " | [" + exercise.title + "](" + fs::path(exercise.text).filename().string() +
         ") | `student/" + exercise.file + "` | " + (needs.empty() ? "-" : needs) + " | " + points + " |";
}

}  // namespace grader
