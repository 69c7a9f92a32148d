// STAFF ONLY. `hairgrade grade`: grades submissions and writes reports.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "grader/class_folder/at_rest.h"
#include "grader/class_folder/batch.h"
#include "grader/class_folder/blind.h"
#include "grader/class_folder/class_files.h"
#include "grader/class_folder/folder_of_grades.h"
#include "grader/class_folder/says_yes.h"
#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/grading/grading.h"
#include "grader/grading/secret.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/layouts/system.h"
#include "grader/intake/names/names.h"
#include "grader/intake/read_submissions.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/record.h"
#include "grader/report/points_files.h"
#include "grader/report/report.h"
#include "grader/roster/groups.h"
#include "grader/roster/times.h"
#include "grader/sandbox/processes/control_groups.h"
#include "grader/text/shell_word.h"
#include "grader/text/time_text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_options.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

std::vector<StaffPlace> staff_places(const GradingSettings& settings, const GradeOptions& options) {
  const fs::path source = HAIR_SOURCE_DIR,
                 secret = options.settings.secret ? *options.settings.secret : default_secret_file();
  return {{"the reference", settings.reference, source},
          {"the suite", settings.suite, source},
          {"the kit", settings.kit, source},
          {"the secret", secret, secret},
          {"what is cached", settings.cache, settings.cache},
          {"the grades", options.batch.out, options.batch.out}};
}

// A time's offset does not give lateness if the due date has no offset.
void check_zone(const HandInRules& rules, const std::vector<Submission>& submissions) {
  if (rules.due.empty() || !rules.zone.empty()) return;
  for (const Submission& one : submissions)
    if (const std::optional<TimeText> time = read_time(one.handed_in); time && time->offset)
      throw BadInput(printable(one.name) + ": was handed in at " + printable(one.handed_in) +
                     ", and nobody knows the offset of the due date " + rules.due +
                     "; write the course's zone beside it in the course file, such as \"zone\": "
                     "\"Europe/Berlin\"");
}

// Prints lines for staff, without hidden names.
auto speaker(Record& record) {
  return [hidden = record.hidden_names()](const std::string& line) {
    std::cerr << "hairgrade: " << (hidden ? hidden->in(line) : line) << "\n";
  };
}

// Reports what the tables of people and times don't match, and what others can read.
void say_given(const GradeOptions& options, const Plan& plan, Record& record,
               const std::optional<Times>& times, const std::string& open_to_others) {
  const NamesForPeople people = record.names_for_people();
  const auto say = speaker(record);
  if (options.batch.roster)
    for (const std::string& line : options.batch.roster->said()) say(line);
  if (times) {
    for (const std::string& line : times->said()) say(line);
    const std::map<std::string, Record::Row> rows = record.rows();
    const auto is_known = [&](const Submission& one) {
      const auto row = rows.find(one.name);
      return row != rows.end() && row->second.files == hash_of_files(one);
    };
    for (const Submission& one : plan.submissions)
      if (const std::string kept = record.handed_in(one.name);
          one.handed_in.empty() && read_time(kept) && is_known(one))
        std::cerr << "hairgrade: " << called(one.name, people) << ": has no time in "
                  << printable(options.times->string(), 4096) << ", and keeps " << kept << "\n";
  }
  if (!open_to_others.empty()) std::cerr << "hairgrade: " << open_to_others << "\n";
}

// Lists missing people, people on no roster, and unusual matches. False if a person must look.
bool say_people(Record& record) {
  const std::optional<ClassList> list = record.class_list();
  if (!list) return true;
  const auto say = speaker(record);
  const std::size_t absent = list->absent().size();
  std::cout << "roster: " << list->rows.size() - absent << " of " << list->rows.size() << " handed in\n";
  for (const std::string& line : list->said) say(line);
  for (const ClassList::Stranger& stranger : list->strangers)
    say(stranger.hand_in + ": is on no roster (" + stranger.why + "), and graded all the same");
  for (const std::string& line : list->to_look_at) say(line);
  return list->to_look_at.empty();
}

// Names the difference that a regrade makes.
void say_changes(Record& record) {
  if (const std::size_t students = class_changes(record).size(); students > 0)
    std::cout << students << " of " << record.names().size() << " have other points: "
              << fs::absolute(record.pages() / kChangesPage).lexically_normal().string() << "\n";
  if (const std::size_t students = published_changes(record).students; students > 0)
    std::cout << students
              << " published totals have changed; hairgrade diff --published FILE.csv lists them\n";
}

int grade(GradeOptions options) {
  if (!options.slurm.step.empty()) return do_step(std::move(options));
  if (options.roster) options.batch.roster = Roster(read_csv(*options.roster));
  std::optional<Times> times;
  if (options.times) times.emplace(read_csv(*options.times));
  options.settings.jobs = options.batch.jobs;
  const std::string& hand_in = options.batch.hand_in;
  const HandInRules rules = read_hand_in(read_course(HAIR_EXERCISES_JSON, options.settings.course),
                                         options.settings.course, hand_in)
                                .rules;
  options.settings.of_hand_in = rules.exercises;
  GradingSettings settings = settings_of(options.settings);
  std::optional<SandboxedReader> reader;
  if (settings.isolation != Isolation::none) reader.emplace(HAIR_READER, settings.isolation);
  std::optional<Roster> roster = options.batch.roster;
  if (!roster && Record::is_in(options.batch.out))
    if (std::optional<std::vector<Person>> people = Record(options.batch.out, hand_in).roster())
      roster.emplace(std::move(*people));
  BatchSettings& batch_settings = options.batch;
  CallersWord& word = batch_settings.word;
  if (roster) word.choices.known = known_by(*roster);
  word.class_over_rows = word.choices.classes;
  Intake intake = until_answered(word.choices.classes, word.replace, [&] {
    return read_submissions(options.submissions, settings.course, reader ? reader->opener() : open_here, {},
                            word.choices);
  });
  if (roster) give_members(intake, *roster);
  if (times)
    for (Submission& one : intake.submissions)
      if (const std::string time = times->find(one.name, one.owner, one.system, roster ? &*roster : nullptr);
          !time.empty() && (time != "-" || one.handed_in.empty()))
        one.handed_in = time;
  check_zone(rules, intake.submissions);
  const std::atomic<bool>& interrupted = note_interruptions();
  const std::optional<FolderOfGrades> folder = FolderOfGrades::open(
      options.batch.out, made_by(settings), interrupted, std::cerr, hand_in, options.batch.regrade);
  if (!folder) {
    std::cerr << "hairgrade: interrupted while it waited; nothing was written\n";
    return kInterrupted;
  }
  if (const std::optional<SharedPlan> there = SharedPlan::in(options.batch.out))
    throw BadInput("its hand-ins are on a cluster; hairgrade collect " +
                   shell_word(options.batch.out.string()) + " takes what is graded, or remove " +
                   (*there / "").string());
  Record& record = folder->record();
  Plan plan = until_answered(word.class_over_rows, word.replace,
                             [&] { return plan_of(intake, record, roster, batch_settings); });
  for (const std::string& line : plan.replaced) std::cerr << "hairgrade: " << line << "\n";
  for (const std::string& line : plan.taken_for) std::cout << line << "\n" << std::flush;
  const std::string open_to_others = readable_by_others(staff_places(settings, options));
  batch_settings.rules = rules;
  batch_settings.merge = options.settings.exercise.has_value();
  enter_plan(plan, batch_settings, record);
  say_given(options, plan, record, times, open_to_others);
  if (options.slurm.asked) return hand_over(options, plan, settings, record, interrupted);
  const Grading grading(std::move(settings));
  const Batch batch = grade_batch(grader_here(grading), plan, batch_settings, record, interrupted);
  return say_graded(grading.isolation(), options, plan, batch, record);
}

}  // namespace

int say_graded(Isolation isolation, const GradeOptions& options, const Plan& plan, const Batch& batch,
               Record& record) {
  const NamesForPeople people = record.names_for_people();
  if (options.junit && !batch.staged) write_file(record.pages() / "junit.xml", junit_xml(batch.results));
  if (!batch.staged) print_table(std::cout, batch.results, people);
  std::cout << "\n" << batch.graded << " graded";
  if (batch.kept > 0 && !batch.staged) std::cout << ", " << batch.kept << " kept from before";
  if (isolation == Isolation::none) std::cout << ", without a sandbox";
  if (isolation == Isolation::container) std::cout << ", with a container's sandbox";
  if (options.settings.no_images) std::cout << ", without pictures";
  std::cout << "\n" << fs::absolute(record.pages() / "index.html").lexically_normal().string() << "\n";
  if (options.batch.regrade && !batch.staged) say_changes(record);
  for (const std::string& problem : batch.problems)
    std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
  const bool people_are_clear = say_people(record);
  for (const std::string& remark : batch.remarks) std::cerr << "hairgrade: " << remark << "\n";
  for (const std::string& remark : plan.remarks) std::cerr << "hairgrade: " << remark << "\n";
  for (const std::string& notice : plan.notices) std::cerr << "hairgrade: " << notice << "\n";
  std::vector<std::string> names;
  for (const Submission& one : plan.submissions) names.push_back(one.name);
  if (const std::string unknown = without_time(record, names);
      !options.batch.rules.due.empty() && !unknown.empty())
    std::cerr << "hairgrade: nobody knows whether these are late, for the download has no time of them: "
              << unknown << "; give their times by --times\n";
  for (const std::string& conflict : batch.conflicts) std::cerr << "hairgrade: " << conflict << "\n";
  std::string not_final;
  for (const SubmissionResult& result : batch.results)
    if (!result.ended_by_the_clock.empty())
      not_final += (not_final.empty() ? "" : ", ") + called(result.name, people);
  if (!not_final.empty())
    std::cerr << "hairgrade: not final, since the clock ended them: " << not_final
              << "; look at them, and grade them again (--resume grades no others)\n";
  if (batch.staged && !batch.interrupted)
    std::cerr << "hairgrade: the results before stay, for not all are graded anew"
              << (batch.ungraded.empty() ? "" : ": " + some_of(batch.ungraded))
              << "; grade these, too, with --regrade\n";
  if (!batch.interrupted) {
    if (!batch.problems.empty()) return 1;
    return not_final.empty() && !batch.staged && plan.notices.empty() && batch.conflicts.empty() &&
                   people_are_clear
               ? 0
               : 3;
  }
  std::cerr << "hairgrade: interrupted after " << batch.done << " of "
            << (plan.only ? 1 : plan.submissions.size()) << " submissions; the same command"
            << (batch.staged ? "" : " with --resume") << " goes on\n";
  return kInterrupted;
}

Command add_grade(CLI::App& hairgrade) {
  const auto options = std::make_shared<GradeOptions>();
  options->batch.jobs = usable_jobs();
  CLI::App* command = hairgrade.add_subcommand("grade", "Grade submissions and write reports");
  command
      ->add_option("SUBMISSION", options->submissions,
                   "An archive (.zip, .tar.gz), a folder, or either of these holding many")
      ->required();
  needed_elsewhere(command->add_option("--out", options->batch.out, "The folder for reports"),
                   options->batch.out, kGrades);
  if_there(options->settings.course, kCourseFile);
  if_there(options->roster, kRoster);
  command
      ->add_option("-j", options->batch.jobs,
                   "How many at a time (default: as many as processors and memory allow)")
      ->check(CLI::Range(1, 256));
  command->add_flag("--resume", options->batch.resume,
                    "Keep results whose submission and suite have not changed");
  command
      ->add_flag(
          "--regrade", options->batch.regrade,
          "Grade all hand-ins of the record again, with another suite or other points; its results change "
          "places with the new ones once all are there")
      ->excludes(command->add_option("--exercise", options->settings.exercise, "Grade this exercise alone"));
  command->add_flag("--class", options->batch.word.choices.classes,
                    "The arguments are classes, also where each may be one student's hand-in");
  command->add_option(
      "--roster", options->roster,
      "A table of people: who handed in nothing, and who is on no roster, is shown; the record keeps it");
  command->add_option("--times", options->times,
                      "A table of people and the times of their hand-ins, for downloads that have none");
  command
      ->add_option("--from", options->batch.word.choices.from,
                   "The learning system that a class comes from (default: it is guessed, and said)")
      ->check(CLI::IsMember(layout_names()));
  command->add_flag(
      "--anonymous", options->batch.blind,
      "Show codes in place of names, to staff, too; the record keeps whose they are, and that it is so");
  command->add_flag("--replace", options->batch.word.replace,
                    "Replace rows of another origin: of another class, or of a hand-in from elsewhere");
  command->add_flag("--junit", options->junit, "Write junit.xml, too: the class for a build server");
  command->add_option("--only", options->batch.only, "Grade the submission of this name alone");
  command->add_option("--course", options->settings.course,
                      "The course file: roles and points of the exercises");
  command->add_option("--hand-in", options->batch.hand_in,
                      "The hand-in of the course file's \"hand_ins\" that is graded");
  command->add_option("--secret", options->settings.secret,
                      "A file with the staff's secret (default: ~/.config/hairgrade/secret)");
  command->add_option("--cache", options->settings.cache,
                      "A folder for compiled objects (default: ~/.cache/hairgrade)");
  command
      ->add_option_function<std::string>(
          "--isolation",
          [options](const std::string& word) { options->settings.isolation = isolation_from(word); },
          "How student code is isolated: by namespaces, or as a container's root can (default: what works "
          "here)")
      ->check(CLI::IsMember({to_string(Isolation::namespaces), to_string(Isolation::container)}));
  command->add_flag_callback(
      "--unsafe-no-sandbox", [options] { options->settings.isolation = Isolation::none; },
      "Run student code unprotected; every report says so");
  command->add_flag("--no-images", options->settings.no_images,
                    "Draw nothing, where there is no OpenGL: whole runs are judged without pictures, and "
                    "every report says so");
  command->add_flag("--study", options->settings.study,
                    "Show error against run time beside the reference's, in study.html; gives no points and "
                    "takes none, but some seconds of CPU time for each submission");
  CLI::Option* slurm = command->add_flag("--slurm", options->slurm.asked,
                                         "Send them to a Slurm cluster whose nodes share --out's folder");
  slurm->excludes("--cache");
  command->add_option("--slurm-options", options->slurm.sbatch, "More options for sbatch, in one word");
  command->add_option("--slurm-prefix", options->slurm.prefix,
                      "Words in front of hairgrade's command on a node: \"apptainer exec hairgrade.sif\"");
  command->add_option("--per-task", options->slurm.per_task,
                      "With --slurm: hand-ins in a task (default: as many as last ten minutes)");
  command->add_option("--slurm-step", options->slurm.step)->expected(2, 4)->group("");
  command->add_option("--node", options->slurm.node)->group("");
  return {command, [options] { return grade(*options); }};
}

}  // namespace grader::tool
