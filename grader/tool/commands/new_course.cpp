// STAFF ONLY. `hairgrade new-course`: makes a course's own folder.
#include <filesystem>
#include <iostream>
#include <memory>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/course_folder.h"
#include "hair/io/files/read_file.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIgnored = R"(# Hand-ins, grades and people stay out of the repository.
/downloads/
/grades/
/handout.tar.gz
*.csv
*.zip
secret*
)";

constexpr const char* kTheTerm = R"(# The term

Run `hairgrade` in this folder. `hairgrade next` prints the command that comes next, and why.

1. Write the course into `course.json`.
2. `hairgrade handout` packs `handout.tar.gz` for students.
3. Save the list of people as `roster.csv`.
4. Put each download into `downloads/`, as the learning system packs it. With several hand-ins name it after
   its hand-in: `downloads/week 1.zip`.
5. `hairgrade grade "downloads/week 1.zip" --hand-in "week 1"` grades into `grades/`.
6. `hairgrade review` is the desk where TAs decide.
7. `hairgrade gradebook` and `hairgrade feedback` give back.

Keep `course.json`, `grades/class.sqlite` and the secret (`hairgrade secret export FILE`) for a year.
)";

int new_course(const fs::path& folder) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw BadInput(printable(folder.string(), 4096) + ": is there already; name a new folder");
  fs::create_directories(folder / kDownloads);
  write_file(folder / ".gitignore", kIgnored);
  write_file(folder / "README.md", kTheTerm);
  write_file(folder / kCourseFile, unwritten_course_file());
  std::cout << (folder / kCourseFile).string() << ": write your course into it, then run hairgrade next in "
            << folder.string() << "\n";
  return 0;
}

}  // namespace

std::string unwritten_course_file() {
  std::string text = R"(// The course: what students hand in, and when. All keys: "The course file" in )" +
                     (fs::path(HAIR_SOURCE_DIR) / "grader/docs/reference.md").string() + R"(
{
  // assigned; optional: extra credit; given: handed out solved; absent
  "exercises": {
)";
  const Course course = read_course(HAIR_EXERCISES_JSON);
  for (const Exercise& exercise : course.exercises)
    text += "    \"" + exercise.id + "\": {\"role\": \"" + to_string(exercise.role) + "\"}" +
            (&exercise == &course.exercises.back() ? "" : ",") + "  // " + exercise.title + "\n";
  return text + R"(  },
  "hand_in": {
    // "zone": "Europe/Berlin", "grace_minutes": 10, "late_per_cent_a_day": 10
  }
  // Several hand-ins need a comma above, and this:
  // "hand_ins": {
  //   "week 1": {"exercises": ["S1"], "due": "2027-03-02 23:59"},
  //   "week 2": {"exercises": ["P1", "H1"], "due": "2027-03-09 23:59"}
  // }
}
)";
}

Command add_new_course(CLI::App& hairgrade) {
  const auto folder = std::make_shared<fs::path>();
  CLI::App* command = hairgrade.add_subcommand("new-course", "Make a course's own folder");
  command->add_option("FOLDER", *folder, "A new folder")->required();
  return {command, [folder] { return new_course(*folder); }};
}

}  // namespace grader::tool
