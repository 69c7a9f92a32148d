// STAFF ONLY. The handout's texts as a course needs them: lines that the course fills in, and nothing that
// leads to what is not there.
#pragma once

#include <map>
#include <string>

#include "grader/course/course.h"
#include "grader/package/gates.h"
#include "grader/package/manifest.h"

namespace grader::inline package {

// exercises.json with the course's points and roles. Absent exercises stay: the handout's build has
// definitions in their place.
std::string course_json(const std::string& text, const Course& course);

// An exercise's categories.json with its share of the points that the course gives it.
std::string course_categories(const std::string& text, const Exercise& exercise);

// Scenes that call an exercise which the course lacks: "hair/scenes/wind.json". table: of all scenes,
// golden/scenes.md.
Paths absent_scenes(const std::string& table, const Course& course);

// All that ships: destinations by paths in the project. A file that the build makes has the path that it has
// below given/.
using Shipped = std::map<std::string, std::string>;
std::string project_path(const ManifestLine& line);

// A text, Markdown, that ships by this line; `missing` has the destinations of what ships in other courses
// only. `categories` is the categories.json of the exercise that the text is of, or "".
// - a line kExerciseRows becomes a row for each exercise, kHowCounted a sentence, kCategoryRows the points of `categories`;
// - below the title of an exercise that is given, and of a README whose first exercise is not to be written, stands a sentence;
// - a link leads to where its file ships, or becomes its words; exercises that the text names and the course lacks are named at
//   its end;
// - commands play scenes that are there (course_scenes.h); the table of scenes keeps those whose exercises are there.
std::string course_text(const std::string& text, const ManifestLine& line, const Course& course,
                        const Shipped& shipped, const Paths& missing, const std::string& categories = "");

inline constexpr const char *kExerciseRows = "<!-- exercises -->",
                            *kHowCounted = "<!-- how a category counts -->",
                            *kCategoryRows = "<!-- categories -->";

}  // namespace grader::package
