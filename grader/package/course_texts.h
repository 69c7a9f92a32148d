// STAFF ONLY. The handout's texts as a course needs them: its exercises, their roles and points, and nothing that leads to what is
// not there.
#pragma once

#include <string>

#include "grader/course/course.h"
#include "grader/package/gates.h"

namespace grader {

// exercises.json with the course's points and roles. Absent exercises stay: the handout's build has definitions in their place.
std::string course_json(const std::string& text, const Course& course);

// Scenes that call an exercise which the course lacks: "hair/scenes/wind.json". table: of all scenes, golden/scenes.md.
Paths absent_scenes(const std::string& table, const Course& course);

// A text, Markdown, that ships as `destination`, beside all of `shipped`; `missing` has what ships in other courses only:
// - the line kExerciseRows of assignment/README.md becomes a row for each exercise (index_row), and the table of scenes keeps those
//   whose exercises are there;
// - the text of an exercise has the course's points, those of its categories in proportion, none if it is given solved;
// - the text of an exercise that is given says so, in the place of "Write" in its first line, and has no hints; no text asks to
//   write it first, and the README begins with an exercise that is to be written;
// - how a category gives points is the course's;
// - a link to a file that does not ship becomes its words, and exercises that the text names and the course lacks are named at
//   its end;
// - commands play scenes that are there (course_scenes.h).
std::string course_text(const std::string& text, const std::string& destination, const Course& course,
                        const Paths& shipped, const Paths& missing);

inline constexpr const char* kExerciseRows =
    "<!-- When the handout is packed: a row for each exercise of exercises.json. -->";

// The exercise's row in the table of assignment/README.md.
std::string index_row(const Exercise& exercise);

}  // namespace grader
