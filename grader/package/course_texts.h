// STAFF ONLY. The handout's texts as a course needs them: with the lines that the course fills in, and
// without links to missing files.
#pragma once

#include <map>
#include <string>

#include "grader/course/course.h"
#include "grader/package/gates.h"
#include "grader/package/manifest.h"

namespace grader::inline package {

// Writes exercises.json with the course's points and roles. Absent exercises stay: the handout's build has
// definitions in their place.
std::string course_json(const std::string& text, const Course& course);

// Writes an exercise's categories.json with its share of the points that the course gives it.
std::string course_categories(const std::string& text, const Exercise& exercise);

// Lists scenes that call an exercise which the course lacks: "hair/scenes/wind.json". `table` is
// golden/scenes.md, with all scenes.
Paths absent_scenes(const std::string& table, const Course& course);

// Maps paths in the project to destinations. A file that the build makes has its path below given/.
using Shipped = std::map<std::string, std::string>;
std::string project_path(const ManifestLine& line);

// Changes a text, Markdown, that ships by this line; `missing` has destinations of other courses alone.
// `categories` is the categories.json of the text's exercise, or "".
// - kExerciseRows and the table below it, the usual course's, become the table of the course's exercises.
// - kHowCounted becomes a sentence, kCategoryRows the categories' points, and kMistakes the rows of
// categories that are "usual".
// - A sentence follows the title of a given exercise, and of a README whose first exercise is given.
// - A link leads to its shipped file, or becomes its words; absent exercises are named at the end.
// - Commands run scenes that ship; the table of scenes keeps those of the course's exercises.
std::string course_text(const std::string& text, const ManifestLine& line, const Course& course,
                        const Shipped& shipped, const Paths& missing, const std::string& categories = "");

inline constexpr const char *kExerciseRows = "<!-- exercises -->",
                            *kHowCounted = "<!-- how a category counts -->",
                            *kCategoryRows = "<!-- categories -->", *kMistakes = "<!-- mistakes -->";

}  // namespace grader::package
