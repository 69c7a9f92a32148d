// STAFF ONLY. `hairgrade reproduce` writes a failing case as a program of its own; `hairgrade try` shows the
// points with another file. Both run one exercise of a record again, and keep nothing.
#include <algorithm>
#include <charconv>
#include <iomanip>
#include <iostream>

#include "grader/compile/compiler.h"
#include "grader/compile/toolchain.h"
#include "grader/course/input.h"
#include "grader/grading/exercise_grading.h"
#include "grader/grading/grading.h"
#include "grader/record/points/hand_ins.h"
#include "grader/report/facts/text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_settings.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct Again : OfARecord {
  GradeSettings settings;
  std::string place;
  fs::path file;  // is the new folder, or the other file
};

struct OneRecorded {
  std::unique_ptr<Record> record;
  std::string name;
  ExerciseResult result = {};  // as it was computed
  GradingSettings settings = {};
};

OneRecorded find_one(Again options, const std::string& exercise) {
  OneRecorded one{open_record(options.folder, options.hand_in), {}};
  one.name = hand_in_called(*one.record, options.name);
  const std::optional<Recorded> found = one.record->find(one.name);
  if (!found)
    throw BadInput(printable(one.name) + ": is no hand-in of " + printable(options.folder.string(), 4096));
  const auto place = std::ranges::find(found->result.exercises, exercise, &ExerciseResult::id);
  if (place == found->result.exercises.end())
    throw BadInput(printable(exercise) + ": is no exercise that " + printable(one.name) + " has points of");
  one.result = *place;
  options.settings.of_hand_in = read_hand_in(read_course(HAIR_EXERCISES_JSON, options.settings.course),
                                             options.settings.course, options.hand_in)
                                    .rules.exercises;
  options.settings.exercise = exercise;
  one.settings = settings_of(options.settings);
  const std::optional<MadeBy> there = made_by_from_json(one.record->made_by());
  if (!there) throw BadInput(printable(one.name) + ": nobody knows what made its result; grade it again");
  one.settings.images = there->images;
  MadeBy here = made_by(one.settings);
  here.isolation = there->isolation;  // changes no numbers
  if (const std::vector<Difference> others = differences(*there, here); !others.empty())
    throw BadInput(printable(one.name) + ": its result was made with " + others.front().what + "; " +
                   others.front().way);
  return one;
}

// Folders, options and libraries are those of grading (compile/toolchain.cpp), but for the debugger's and the
// sanitizers'. These find a memory error that changes no number in grading, too.
constexpr const char* kBuild = R"(# STAFF ONLY. Builds a case of grading that fails.
cmake_minimum_required(VERSION 3.16)
project(reproduced LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(Eigen3 REQUIRED NO_MODULE)
file(GLOB sources student/*.cpp)
add_executable(case main.cpp given.cpp ${sources})
target_include_directories(case PRIVATE solver/lecture given . given/student)
target_compile_options(case PRIVATE -g -Og -ffp-contract=off -ftrivial-auto-var-init=pattern
                                    -fsanitize=address,undefined -U__SANITIZE_ADDRESS__)
target_link_options(case PRIVATE -fsanitize=address,undefined -no-pie)
target_compile_definitions(case PRIVATE ANSWERS="${CMAKE_CURRENT_SOURCE_DIR}/answers.txt")
target_link_libraries(case PRIVATE Eigen3::Eigen ${CMAKE_CURRENT_SOURCE_DIR}/lib/eigen.a
                                   ${CMAKE_CURRENT_SOURCE_DIR}/lib/standard.a)
)";

// Asks the category alone, in the same worker and sandbox, with the limits of grading.
std::map<std::string, std::string> case_of(const OneRecorded& one, const std::string& category,
                                           const StagedKit& kit) {
  const Exercise& exercise = *one.settings.course.find(one.result.id);
  const Compiler compiler(kit, one.settings.cache, one.settings.isolation);
  SuiteJobs jobs(one.settings, kit);
  jobs.limit_by(one.record->costs().reference);
  const fs::path folder = kit.new_job("reproduced");
  const Compiled compiled =
      compiler.compile(exercise, one.result.source, folder, jobs.compiler_seconds(exercise));
  if (compiled.object.empty()) throw BadInput(one.result.file + ": does not compile");
  SuiteJob job = jobs.cases(exercise, one.record->drawn_from(one.name), compiled.object, folder);
  job.reproduce = category;
  job.exercises = HAIR_EXERCISES_JSON;
  ExerciseTiming timing;
  return jobs.run(job, timing).reproduced;
}

int reproduce(const Again& options) {
  const fs::path& out = options.file;
  if (fs::exists(out) && !fs::is_empty(out))
    throw BadInput(printable(out.string(), 4096) + ": is not empty; name a new folder with --out");
  const std::string& place = options.place;
  const std::size_t dot = std::min(place.find('.'), place.size());
  const OneRecorded one = find_one(options, place.substr(0, dot));
  const std::vector<CaseResult>& cases = one.result.cases;
  std::size_t number = 0;
  if (dot < place.size()) std::from_chars(&place[dot + 1], place.data() + place.size(), number);
  if (number == 0 || number > cases.size())
    throw BadInput(printable(place) + ": is no category; " + one.result.id + " has " +
                   std::to_string(cases.size()) + ": write " + one.result.id + ".1 for the first");
  const CaseResult& category = cases[number - 1];
  if (category.status == Status::passed) throw BadInput(place + ": passes; name a category that lost points");
  if (one.result.source.size() >= kMostSource)
    throw BadInput(place + ": the record keeps only the beginning of so long a file");
  const StagedKit kit(one.settings.kit, one.settings.course);
  std::map<std::string, std::string> files = case_of(one, category.name, kit);
  if (const auto why = files.find(kNotReproduced); why != files.end())
    throw BadInput(place + ", " + category.name + ": can't be reproduced: " + why->second);

  fs::create_directories(out);
  fs::copy(kit.folder() / "handout", out, fs::copy_options::recursive);
  fs::copy(kit.folder() / "given", out / "lib");
  const fs::path grader = fs::path(HAIR_SOURCE_DIR) / "grader";
  for (const char* header : {"grader/calls/remote.h", "grader/wire/force_message.h"})
    files[header] = hair::bytes_of(fs::path(HAIR_SOURCE_DIR) / header);
  files["replay.h"] = hair::bytes_of(grader / "judge/replay.h");
  files["student/" + one.result.file] = one.result.source;
  files["CMakeLists.txt"] = kBuild;
  for (const auto& [name, text] : files) {
    fs::create_directories((out / name).parent_path());
    write_file(out / name, text);
  }
  const std::string folder = fs::absolute(out).lexically_normal().string();
  std::cout << "cmake -S " << folder << " -B " << folder << "/build && cmake --build " << folder
            << "/build && " << folder << "/build/case\nstudent/" << one.result.file
            << " runs there without a sandbox: read it first\n";
  return 0;
}

std::string points_and_status(double points, Status status) {
  return shown_points(points) + " " + to_string(status);
}

int try_file(const Again& options) {
  const OneRecorded one = find_one(options, options.place);
  Submission submission;
  submission.name = one.name;
  submission.drawn_from = one.record->drawn_from(one.name);
  std::string& text = submission.files[one.result.file].text = hair::bytes_of(options.file);
  if (text.size() > IntakeLimits().file_bytes)
    throw BadInput(printable(options.file.string(), 4096) + ": is larger than any hand-in's file may be");
  const Graded graded = Grading(one.settings).grade(submission);
  for (const std::string& problem : graded.problems) throw std::runtime_error(problem);
  const ExerciseResult &before = one.result, &now = graded.result.exercises.front();
  const auto row = [](const std::string& name, const std::string& was, const std::string& is) {
    std::cout << std::left << std::setw(44) << name << std::setw(28) << was << is << "\n";
  };
  row("", "before", "now");
  for (std::size_t i = 0; i < std::max(before.cases.size(), now.cases.size()); ++i) {
    const auto shown = [i](const ExerciseResult& of) {
      return i < of.cases.size() ? points_and_status(of.cases[i].points, of.cases[i].status) : "-";
    };
    row(now.id + "." + std::to_string(i + 1) + " " + (i < now.cases.size() ? now : before).cases[i].name,
        shown(before), shown(now));
  }
  row(now.id, points_and_status(before.points, before.status), points_and_status(now.points, now.status));
  const auto total = [&](const ExerciseResult& instead) {
    const auto put = [&](SubmissionResult& result) {
      for (ExerciseResult& each : result.exercises)
        if (each.id == instead.id) each = instead;
    };
    const SubmissionResult all = one.record->find_under(one.name, one.record->rules(), put).value();
    return shown_total(points(all), max_points(all));
  };
  row("all", total(before), total(now));
  std::cout << now.compiler_messages;
  return 0;
}

Command add(CLI::App& hairgrade, const char* name, const char* says, int (*run)(const Again&),
            const std::function<void(CLI::App&, Again&)>& add_own) {
  const auto options = std::make_shared<Again>();
  CLI::App* command = hairgrade.add_subcommand(name, says);
  add_name(*command, *options);
  add_own(*command, *options);
  needed_elsewhere(command->add_option("--grades", options->folder, "The folder of hairgrade grade --out"),
                   options->folder, kGrades);
  if_there(options->settings.course, kCourseFile);
  add_hand_in(*command, options->hand_in);
  command->add_option("--course", options->settings.course, "The course file, as for grade");
  command->add_option("--secret", options->settings.secret, "The secret's file, as for grade");
  command->add_option("--cache", options->settings.cache, "The folder for compiled objects");
  return {command, [options, run] { return run(*options); }};
}

}  // namespace

Command add_reproduce(CLI::App& hairgrade) {
  return add(
      hairgrade, "reproduce", "Write a category's first failing case as a program of its own", reproduce,
      [](CLI::App& command, Again& options) {
        command.add_option("PLACE", options.place, "A category that lost points, \"H2.3\"")->required();
        command.add_option("--out", options.file, "A new folder")->required();
      });
}

Command add_try(CLI::App& hairgrade) {
  return add(
      hairgrade, "try", "Show the points if a hand-in had another file; keeps nothing", try_file,
      [](CLI::App& command, Again& options) {
        command.add_option("EXERCISE", options.place, "The file's exercise, \"H2\"")->required();
        command.add_option("--with", options.file, "The other file")->required()->check(CLI::ExistingFile);
      });
}

}  // namespace grader::tool
