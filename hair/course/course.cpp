#include "hair/course/course.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/strict_json.h"

namespace hair {
namespace {

constexpr double most_points = 1e6;
constexpr std::array<std::pair<Role, std::string_view>, 4> role_names{{{Role::assigned, "assigned"},
                                                                       {Role::optional, "optional"},
                                                                       {Role::given, "given"},
                                                                       {Role::absent, "absent"}}};

Role read_role(const JsonValue& json) {
  const std::string text = json.text();
  for (const auto& [role, name] : role_names) {
    if (text == name) return role;
  }
  json.fail("unknown role; write assigned, optional, given or absent");
}

// Ids are parts of target names, file names and pages; files are found by their name alone.
std::string read_name(const JsonValue& json, std::string_view also_allowed, const std::string& right) {
  const std::string text = json.text();
  const bool plain = std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           also_allowed.find(c) != std::string_view::npos;
  });
  if (!plain) json.fail(right);
  return text;
}

std::string read_source_name(const JsonValue& json) {
  const std::string right =
      "is not the name of a source file; write one like \"conj_grad.cpp\", without folders";
  const std::string name = read_name(json, "_-.", right);
  if (!name.ends_with(".cpp") || name.front() == '.') json.fail(right);
  return name;
}

std::string read_relative_path(const JsonValue& json) {
  const std::filesystem::path path = json.text();
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || climbs) json.fail("leaves the project; write a path below it, without \"..\"");
  return path.string();
}

std::vector<std::string> read_libraries(const JsonValue& json) {
  for (const JsonValue& library : json.items()) {
    if (library.text() != "eigen") library.fail("unknown library; write eigen, or leave the list empty");
  }
  return json.texts();
}

Exercise read_exercise(const JsonValue& json, const Course& before) {
  json.check_keys(
      {"id", "title", "file", "functions", "header", "prerequisites", "libraries", "points", "role"},
      {"show"});
  Exercise exercise;
  exercise.id = read_name(json["id"], "_", "is not an id; write letters and digits, like \"S1\"");
  exercise.title = json["title"].text();
  exercise.file = read_source_name(json["file"]);
  exercise.functions = json["functions"].texts();
  exercise.header = read_relative_path(json["header"]);
  exercise.folder = "exercises/" + exercise.id;
  if (json.has("show")) exercise.show = json["show"].text();
  exercise.prerequisites = json["prerequisites"].texts();
  exercise.libraries = read_libraries(json["libraries"]);
  exercise.points = json["points"].number(0, most_points);
  exercise.role = read_role(json["role"]);

  if (before.find(exercise.id)) {
    json["id"].fail("\"" + exercise.id + "\" is already taken; give each exercise its own id");
  }
  for (const Exercise& other : before.exercises) {
    if (other.file == exercise.file) {
      json["file"].fail("\"" + other.file + "\" is already " + other.id +
                        "'s; give each exercise its own file");
    }
  }
  if (exercise.functions.empty()) {
    json["functions"].fail("is empty; name the functions that " + exercise.file + " defines");
  }
  // Prerequisites come first in the list, so that exercises can't need each other in a circle.
  for (const JsonValue& prerequisite : json["prerequisites"].items()) {
    if (!before.find(prerequisite.text())) {
      prerequisite.fail("no such exercise stands before " + exercise.id + "; name one that does");
    }
  }
  return exercise;
}

void change_exercises(Course& course, const JsonValue& changes) {
  for (const std::string& id : changes.keys()) {
    const auto exercise = std::find_if(course.exercises.begin(), course.exercises.end(),
                                       [&](const Exercise& candidate) { return candidate.id == id; });
    if (exercise == course.exercises.end()) {
      std::string known;
      for (const Exercise& other : course.exercises) known += (known.empty() ? "" : ", ") + other.id;
      changes[id].fail("there is no such exercise; known: " + known);
    }
    changes[id].check_keys({}, {"role", "points"});
    if (changes[id].has("role")) exercise->role = read_role(changes[id]["role"]);
    if (changes[id].has("points")) exercise->points = changes[id]["points"].number(0, most_points);
  }
}

// An exercise can't be linked without the functions that it calls, whoever writes it.
void check_prerequisites(const Course& course, const JsonValue& last_file) {
  for (const Exercise& exercise : course.exercises) {
    if (exercise.role == Role::absent) continue;
    for (const std::string& id : exercise.prerequisites) {
      if (course.find(id)->role == Role::absent) {
        last_file.fail("exercises: " + exercise.id + " is " + to_string(exercise.role) + " but needs " + id +
                       ", which is absent; make " + id + " given, or " + exercise.id + " absent");
      }
    }
  }
}

}  // namespace

const Exercise* Course::find(const std::string& id) const {
  const auto exercise = std::find_if(exercises.begin(), exercises.end(),
                                     [&](const Exercise& candidate) { return candidate.id == id; });
  return exercise == exercises.end() ? nullptr : &*exercise;
}

bool Course::has(const std::string& id) const {
  const Exercise* exercise = find(id);
  return exercise && exercise->role != Role::absent;
}

std::vector<std::string> Course::absent() const {
  std::vector<std::string> ids;
  for (const Exercise& exercise : exercises)
    if (exercise.role == Role::absent) ids.push_back(exercise.id);
  return ids;
}

Course read_course(const std::filesystem::path& exercises_json,
                   const std::optional<std::filesystem::path>& course_json) {
  const nlohmann::json list = read_json(exercises_json);
  const JsonValue top(list, exercises_json);
  top.check_keys({"exercises"});
  Course course;
  for (const JsonValue& json : top["exercises"].items()) {
    course.exercises.push_back(read_exercise(json, course));
  }
  if (course.exercises.empty()) top["exercises"].fail("is empty; list at least one exercise");
  check_prerequisites(course, top);

  if (course_json) {
    const nlohmann::json changes = read_json(*course_json);
    const JsonValue changes_top(changes, *course_json);
    changes_top.check_keys({"exercises"}, {"budget", "hand_in", "hand_ins", "partial"});
    change_exercises(course, changes_top["exercises"]);
    check_prerequisites(course, changes_top);
  }
  return course;
}

std::string to_string(Role role) {
  for (const auto& [candidate, name] : role_names) {
    if (candidate == role) return std::string(name);
  }
  return "unknown";
}

std::string plain_name(std::string function) {
  function = function.substr(0, function.find('('));
  const std::size_t scope = function.rfind("::");
  return scope == std::string::npos ? function : function.substr(scope + 2);
}

}  // namespace hair
