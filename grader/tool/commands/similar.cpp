// STAFF ONLY. `hairgrade similar`: shows pairs of hand-ins that share code beyond the handout.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/class_folder/blind.h"
#include "grader/class_folder/plan.h"
#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/grading/isolation_here.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/read_submissions.h"
#include "grader/record/points/hand_ins.h"
#include "grader/similar/similar_pages.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct SimilarOptions {
  std::vector<fs::path> submissions, earlier;
  std::optional<fs::path> course, grades;
  fs::path out;
  std::string hand_in;
  int per_cent = 60;
  IntakeChoices choices;
};

int similar(const SimilarOptions& options) {
  Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  if (!options.hand_in.empty())
    course.of_hand_in = read_hand_in(course, options.course, options.hand_in).rules.exercises;
  const Isolation isolation = isolation_here(StagedKit(HAIR_KIT_DIR, course), {});
  const SandboxedReader reader(HAIR_READER, isolation);
  Intake intake = read_submissions(options.submissions, course, reader.opener(), {}, options.choices);
  NamesForPeople people = names_for_people({}, hand_ins_of(intake.submissions));
  std::optional<HiddenNames> hidden;
  if (options.grades) {
    const std::unique_ptr<Record> record = open_record(*options.grades, options.hand_in);
    people = record->names_for_people();
    hidden = record->hidden_names();
    if (const std::optional<std::vector<Person>> roster = record->roster())
      give_members(intake, Roster(*roster));
    if (hidden) give_codes(intake.submissions, record->codes());
    std::vector<Accounted> none_listed;
    std::optional<std::string> all;
    keep_rows(intake.submissions, none_listed, *record, all);
    if (hidden) hide(*hidden, intake);
  }
  std::vector<Intake> earlier;
  for (const fs::path& folder : options.earlier) {
    earlier.push_back(read_submissions({folder}, course, reader.opener(), {}, {}));
    const std::vector<std::string>& notices = earlier.back().notices;
    intake.notices.insert(intake.notices.end(), notices.begin(), notices.end());
  }
  const Sim sim(isolation);
  SimilarRules rules;
  rules.least_part = options.per_cent / 100.0;
  std::error_code error;
  if (fs::create_directories(options.out, error)) fs::permissions(options.out, fs::perms::owner_all);

  std::vector<SimilarExercise> exercises;
  for (const Exercise& exercise : course.exercises) {
    if (!course.of_hand_in.empty() && !course.asks_for(exercise)) continue;
    SimilarExercise one{exercise.id, exercise.file, {}, {}};
    const auto text_of = [&](const Submission& submission) -> const std::string* {
      const auto file = submission.files.find(exercise.file);
      return file != submission.files.end() && file->second.problem.empty() ? &file->second.text : nullptr;
    };
    for (const Submission& submission : intake.submissions)
      if (const std::string* text = text_of(submission))
        one.files.push_back({submission.name, hidden ? hidden->in_own(*text, submission.name) : *text,
                             called(submission.name, people)});
    const std::size_t now = one.files.size();
    for (std::size_t year = 0; now > 0 && year < earlier.size(); ++year) {
      const NamesForPeople theirs = names_for_people({}, hand_ins_of(earlier[year].submissions));
      const auto shown = [&](const std::string& text) { return hidden ? hidden->in(text) : text; };
      for (const Submission& submission : earlier[year].submissions)
        if (const std::string* text = text_of(submission))
          one.files.push_back({"earlier" + std::to_string(year + 1) + "-" + shown(submission.name),
                               shown(*text),
                               shown(called(submission.name, theirs)) + " in " +
                                   printable(options.earlier[year].string(), 4096),
                               true});
    }
    if (one.files.size() < 2) continue;
    const std::string stub = hair::bytes_of(HAIR_SOURCE_DIR / unwritten_file_of(exercise));
    one.shared = shared_code(sim, one.files, {stub}, rules);
    std::cout << exercise.id << ": " << now << " files, ";
    if (!earlier.empty()) std::cout << one.files.size() - now << " earlier ones, ";
    std::cout << one.shared.pairs.size() << " pairs above " << options.per_cent << " %, "
              << one.shared.not_compared.size() << " not compared\n"
              << std::flush;
    for (const NotCompared& left_out : one.shared.not_compared)
      if (!left_out.too_short)
        std::cerr << "hairgrade: " << exercise.id << " of " << one.files[left_out.file].shown
                  << ": is not compared: " << left_out.why << "\n";
    exercises.push_back(std::move(one));
  }
  if (exercises.empty()) throw BadInput("there are no two hand-ins with a file of the same exercise");
  write_similar_pages(options.out, exercises, rules);
  std::cout << fs::absolute(options.out / "index.html").lexically_normal().string() << "\n";
  for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
  return 0;
}

}  // namespace

Command add_similar(CLI::App& hairgrade) {
  const auto options = std::make_shared<SimilarOptions>();
  CLI::App* command =
      hairgrade.add_subcommand("similar", "Show pairs of hand-ins that share code beyond the handout's");
  command->add_option("SUBMISSION", options->submissions, "As for grade")->required();
  command->add_option("--out", options->out, "A folder for the pages, which are for staff alone")->required();
  if_there(options->course, kCourseFile);
  command->add_option("--course", options->course, "The course file: which exercises there are");
  command->add_option("--grades", options->grades,
                      "A folder of grades: names are as staff read them there, or codes");
  command->add_option("--hand-in", options->hand_in,
                      "Of a course with several hand-ins: the exercises of this one alone");
  command
      ->add_option("--earlier", options->earlier,
                   "Hand-ins of an earlier year, as for grade: these are compared with those, and those not "
                   "with each other; may be given again")
      ->allow_extra_args(false);
  command
      ->add_option("--least", options->per_cent, "The least part of a pair that is shown, in per cent (60)")
      ->check(CLI::Range(1, 100));
  command->add_flag("--class", options->choices.classes, "Each of several arguments may be a class");
  command
      ->add_option("--from", options->choices.from,
                   "The learning system that a class comes from (default: it is guessed)")
      ->check(CLI::IsMember(layout_names()));
  return {command, [options] { return similar(*options); }};
}

}  // namespace grader::tool
