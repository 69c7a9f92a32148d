// The exercises of a course: handout/exercises.json, with the changes of an instructor's course file.
// Programs read both when they start.
//
// A course file changes the role or the points of exercises; a value that it does not name stays:
//
//   {"exercises": {"S1": {"role": "given"}, "S2": {"points": 5}, "H3": {"role": "absent"}}}
//
// Only the grader reads its "budget", "hand_in", "hand_ins" and "partial".
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hair {

// assigned: counts. optional: extra credit, added on top of the total. given: handed out solved. absent: not
// in the course.
enum class Role { assigned, optional, given, absent };

struct Exercise {
  std::string id;                          // "S1"
  std::string title;                       // "Conjugate gradients"
  std::string file;                        // "conj_grad.cpp"
  std::vector<std::string> functions;      // defined in the file, demangled: "ConjGrad(int, ...)"
  std::string header;                      // the header with their contract, relative to the project's root
  std::string folder;                      // the folder of its text, checks and stub, relative to handout/
  std::string show;                        // the words after "hairlab" that show it: "view limp-hair"; or ""
  std::vector<std::string> prerequisites;  // ids of exercises whose functions it calls
  std::vector<std::string> libraries;      // allowed besides the standard library: "eigen"
  double points = 0;
  Role role = Role::assigned;
  bool stub = false;  // none of its functions is written: its program reports that
};

struct Course {
  std::vector<Exercise> exercises;  // in the order of exercises.json, absent ones included

  const Exercise* find(const std::string& id) const;  // null if there is none
  bool has(const std::string& id) const;              // false also for an absent one
  std::vector<std::string> absent() const;            // the ids of the absent exercises
};

// Throws BadInput with the file and the JSON path.
Course read_course(const std::filesystem::path& exercises_json,
                   const std::optional<std::filesystem::path>& course_json = {});

std::string to_string(Role role);

// "stretch_energy" of "hair::stretch_energy(hair::Strand const&)".
std::string plain_name(std::string function);

// True if any of the called exercises is among the absent ones.
template <class Ids>
bool calls_absent(const Ids& called, const std::vector<std::string>& absent) {
  return std::any_of(called.begin(), called.end(), [&](const auto& id) {
    return std::find(absent.begin(), absent.end(), id) != absent.end();
  });
}

}  // namespace hair
