#include "hair/lab/run/stub.h"

#include <algorithm>
#include <sstream>

namespace hair {

namespace {

std::string id_of(const std::string& what) {
  return what.substr(0, what.find(' '));
}

}  // namespace

void mark_stubs(Course& course, std::string_view stubs) {
  for (Exercise& exercise : course.exercises) {
    std::size_t count = 0;
    std::istringstream lines{std::string(stubs)};
    for (std::string line; std::getline(lines, line);) count += id_of(line) == exercise.id ? 1 : 0;
    exercise.stub = count > 0 && count >= exercise.functions.size();
  }
}

std::string stubs_among(const std::vector<std::string>& ids, const Course& course) {
  std::string list;
  for (const std::string& id : ids)
    if (const Exercise* exercise = course.find(id); exercise && exercise->stub)
      list += (list.empty() ? "" : ", ") + id + " (student/" + exercise->file + ")";
  return list;
}

// HAIR_EXERCISE_FILES is "S1 conj_grad.cpp S2 ...", from exercises.json.
std::string missing_part(const std::string& what) {
  const std::string id = id_of(what);
  std::istringstream files(HAIR_EXERCISE_FILES);
  for (std::string exercise, file; files >> exercise >> file;)
    if (exercise == id && id.size() + 1 < what.size())
      return id + ": student/" + file + ", " + what.substr(id.size() + 1);
  return what;
}

std::string missing_parts(const NotImplemented& stub, std::vector<std::string> ids, const Course& course) {
  std::erase(ids, id_of(stub.what()));
  const std::string others = stubs_among(ids, course);
  return missing_part(stub) + (others.empty() ? "" : "; nor are " + others);
}

}  // namespace hair
