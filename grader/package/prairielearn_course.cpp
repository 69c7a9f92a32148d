// STAFF ONLY. Writes PrairieLearn's questions.
#include "grader/package/prairielearn_course.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/plot/html.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kServerFiles = "hairgrade";
constexpr double kLongest = 600;  // the platform's limit, in seconds
constexpr double kStarts = 30;    // seconds for the reference solution, which is graded first

// The platform wants an identifier of its own for each question: it is the same each time.
std::string uuid_of(const std::string& name) {
  const std::string hash = sha256(name);
  return hash.substr(0, 8) + "-" + hash.substr(8, 4) + "-4" + hash.substr(13, 3) + "-8" + hash.substr(17, 3) +
         "-" + hash.substr(20, 12);
}

Json info_of(const Exercise& exercise, double seconds, const PrairieLearnCourse& options) {
  const std::string files = std::string("/grade/serverFilesCourse/") + kServerFiles;
  Json entry = {"/usr/bin/hairgrade", "prairielearn", "--exercise",
                exercise.id,          "--secret",     files + "/secret"};
  if (options.course) entry.insert(entry.end(), {"--course", files + "/course.json"});
  return {{"uuid", uuid_of("hair " + exercise.id)},
          {"title", exercise.title},
          {"topic", "Hair"},
          {"type", "v3"},
          {"gradingMethod", "External"},
          {"externalGradingOptions",
           {{"enabled", true},
            {"image", options.image},
            {"entrypoint", entry},
            {"serverFilesCourse", {std::string(kServerFiles) + "/"}},
            {"timeout", static_cast<int>(std::min(kLongest, seconds))}}}};
}

std::string question_of(const Exercise& exercise) {
  return hair::html(
             "<pl-question-panel>\n<p>{}: your {} of the handout.</p>\n</pl-question-panel>\n"
             "<pl-file-upload file-names=\"{}\"></pl-file-upload>\n<pl-submission-panel>\n"
             "<pl-external-grader-results></pl-external-grader-results>\n</pl-submission-panel>\n",
             {exercise.title, exercise.file, exercise.file})
      .text;
}

}  // namespace

void write_prairielearn_course(const std::string& secret, const Course& course,
                               const PrairieLearnCourse& options) {
  if (fs::exists(options.out))
    throw BadInput("--out " + options.out.string() + ": is there; name a new folder");
  const auto asked =
      std::ranges::count_if(course.exercises, [&](const Exercise& one) { return course.asks_for(one); });
  const Budget share = share_of(course.budget, std::max(1, static_cast<int>(asked)));
  const double seconds = kStarts + share.idle_seconds + share.worker_cpu_seconds +
                         share.compiler_cpu_seconds + share.suite_cpu_seconds;
  const fs::path files = options.out / "serverFilesCourse" / kServerFiles;
  fs::create_directories(files);
  fs::permissions(files, fs::perms::owner_all);  // before it holds the secret
  write_file(files / "secret", secret);
  if (options.course) write_file(files / "course.json", hair::bytes_of(*options.course));
  for (const Exercise& exercise : course.exercises) {
    if (!course.asks_for(exercise)) continue;
    const fs::path question = options.out / "questions" / ("hair-" + exercise.id);
    fs::create_directories(question);
    write_file(question / "info.json", info_of(exercise, seconds, options).dump(2) + "\n");
    write_file(question / "question.html", question_of(exercise));
  }
}

}  // namespace grader::package
