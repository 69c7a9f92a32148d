// STAFF ONLY. Reads the hand-ins of a course.
#include "grader/record/points/hand_ins.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "grader/course/input.h"
#include "grader/text/letters.h"

namespace grader::inline record {
namespace {

// Students don't hand in an exercise that the course does not assign.
void check_exercises(const Course& course, const JsonValue& json, std::map<std::string, std::string>& taken,
                     const std::string& name) {
  if (json.items().empty()) json.fail("is empty; name the exercises of this hand-in");
  for (const JsonValue& item : json.items()) {
    const std::string id = item.text();
    const Exercise* exercise = course.find(id);
    if (!exercise || (exercise->role != Role::assigned && exercise->role != Role::optional))
      item.fail(exercise ? "is " + to_string(exercise->role) +
                               ", so nobody hands it in; name exercises that are assigned or optional"
                         : "there is no such exercise; name those of \"exercises\"");
    const auto [other, is_new] = taken.emplace(id, name);
    if (!is_new)
      item.fail(id + " is in \"" + printable(other->second) + "\", too; an exercise is in one hand-in");
  }
}

}  // namespace

std::string folder_of_hand_in(const std::string& name) {
  std::string folder = without_marks(name);
  for (char& c : folder)
    if (static_cast<unsigned char>(c) >= 0x80 ||
        (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-'))
      c = '_';
  return folder.starts_with('-') ? "x" + folder : folder;
}

std::vector<CourseHandIn> read_hand_ins(const Course& course,
                                        const std::optional<std::filesystem::path>& course_json) {
  if (!course_json) return {{"", {}}};
  const hair::JsonDocument document = hair::read_document(*course_json);
  const JsonValue file(*document, *course_json);
  HandInRules common;
  if (file.has("hand_in")) {
    read_rules(file["hand_in"], common);
    if (!common.exercises.empty())
      file["hand_in"]["exercises"].fail("belongs to one of several hand-ins; write it in \"hand_ins\"");
  }
  const auto check_ids = [&](const JsonValue& json, const HandInRules& rules) {
    for (const auto& [id, one] : rules.by_hand)
      if (course.find(id)) json["by_hand"][id].fail("is an exercise; give these points another id");
  };
  if (file.has("hand_in")) check_ids(file["hand_in"], common);
  if (!file.has("hand_ins")) return {{"", common}};
  if (!common.due.empty() || !common.column.empty())
    file["hand_in"].fail("has what all of \"hand_ins\" share; write \"due\" and \"column\" in each of them");
  const JsonValue all = file["hand_ins"];
  std::vector<CourseHandIn> hand_ins;
  std::map<std::string, std::string> taken, folders;
  for (const std::string& name : all.keys()) {
    const JsonValue json = all[name];
    constexpr std::size_t kLongest = 60;
    if (name.empty() || name.size() > kLongest || legible(name) != name)
      json.fail("is no name of a hand-in; write one of 1 to " + std::to_string(kLongest) +
                " bytes, such as \"week 3\"");
    CourseHandIn one{name, common};
    read_rules(json, one.rules);
    if (json.has("by_hand")) check_ids(json, one.rules);
    if (json.has("free_days_in_all"))
      json["free_days_in_all"].fail("is for all hand-ins; write it in \"hand_in\", beside \"hand_ins\"");
    if (!json.has("exercises")) json.fail("names no exercises; write them, such as \"exercises\": [\"S1\"]");
    check_exercises(course, json["exercises"], taken, name);
    std::string folder = lowered(folder_of_hand_in(name));
    const auto [other, is_new] = folders.emplace(std::move(folder), name);
    if (!is_new)
      json.fail("has the folder " + folder_of_hand_in(name) + ", as \"" + printable(other->second) +
                "\" has; names differ in letters without marks and in digits");
    hand_ins.push_back(std::move(one));
  }
  if (hand_ins.empty()) all.fail("is empty; name at least one hand-in, or leave it out");
  return hand_ins;
}

void check_hand_in(const std::string& name, const std::vector<std::string>& names, const std::string& where) {
  if (name.empty() ? names.empty() : std::ranges::count(names, name) > 0) return;
  std::string there;
  for (const std::string& one : names) there += (there.empty() ? "\"" : "\", \"") + printable(one);
  throw BadInput(where + (names.empty() ? ": has one hand-in without a name, and no \"" + printable(name) +
                                              "\"; leave out --hand-in"
                          : name.empty()
                              ? ": has several hand-ins; name one by --hand-in: " + there + "\""
                              : ": has no hand-in \"" + printable(name) + "\"; there are " + there + "\""));
}

CourseHandIn read_hand_in(const Course& course, const std::optional<std::filesystem::path>& course_json,
                          const std::string& name) {
  const std::vector<CourseHandIn> all = read_hand_ins(course, course_json);
  std::vector<std::string> names;
  for (const CourseHandIn& one : all)
    if (!one.name.empty()) names.push_back(one.name);
  check_hand_in(name, names, course_json ? printable(course_json->string(), 4096) : "the course");
  return *std::ranges::find(all, name, &CourseHandIn::name);
}

}  // namespace grader::record
