// STAFF ONLY. hairgrade: grades submissions, also where Gradescope puts them, compares pictures, makes the handout and the package for
// Gradescope, and tells of the samples.
//
// Exit code 0: all submissions have results (or the handout is written). 1: the grader itself failed, intake
// left something out (a line each, all else is graded), or a gate of the handout closed. 2: bad input or usage. 3: a person must look: the
// clock on the wall ended a submission, or a picture is missing or could not be compared. 130: interrupted; what was finished is kept, and --resume goes on.
#include <locale.h>
#include <signal.h>
#include <sodium.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <string_view>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/intake/caged_archive.h"
#include "grader/intake/submission.h"
#include "grader/package/handout.h"
#include "grader/report/report.h"
#include "grader/samples/table.h"
#include "grader/sandbox/inherited.h"
#include "grader/sandbox/own_groups.h"
#include "grader/tool/at_rest.h"
#include "grader/tool/batch.h"
#include "grader/tool/comparing.h"
#include "grader/tool/folder_of_grades.h"
#include "grader/tool/grade_settings.h"
#include "grader/tool/gradescope_command.h"
#include "grader/tool/grading.h"
#include "grader/tool/origins.h"
#include "grader/tool/secret.h"
#include "hair/io/files/finish_output.h"

namespace {

namespace fs = std::filesystem;
using namespace grader;

// A signal handler has nothing else that it may touch.
std::atomic<bool> interrupted = false;

struct GradeOptions {
  std::vector<fs::path> submissions;
  bool classes = false;
  GradeSettings settings;
  BatchSettings batch;
};

struct HandoutOptions {
  fs::path out;
  std::optional<fs::path> course;
  bool accept = false;
};

void note_interruptions() {
  struct sigaction action = {};
  action.sa_handler = [](int) { interrupted = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);  // by nohup
}

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

int grade(GradeOptions options) {
  options.settings.jobs = options.batch.jobs;
  GradingSettings settings = settings_of(options.settings);
  std::optional<CagedReader> reader;
  if (settings.isolation != Isolation::none) reader.emplace(HAIR_READER, settings.isolation);
  Intake intake = read_submissions(options.submissions, settings.course,
                                   reader ? reader->opener() : open_here, {}, options.classes);

  check_made_by(options.batch.out, made_by(settings));  // before the reference takes its seconds
  settle_origins(options.batch.out, intake.submissions, options.batch.only, options.batch.replace);
  for (const std::string& line : intake.taken_for) std::cout << line << "\n" << std::flush;
  note_interruptions();
  const std::string open_to_others = readable_by_others(staff_places(settings, options));
  const Grading grading(std::move(settings));
  BatchSettings batch_settings = options.batch;
  batch_settings.merge = options.settings.exercise.has_value();
  const Batch batch = grade_batch(grading, intake.submissions, batch_settings, interrupted);
  if (!batch.began) {
    std::cerr << "hairgrade: interrupted while it waited; nothing was written\n";
    return 130;
  }
  print_table(std::cout, batch.results);
  std::cout << "\n" << batch.graded << " graded";
  if (batch.kept > 0) std::cout << ", " << batch.kept << " kept from before";
  if (grading.isolation() == Isolation::none) std::cout << ", without a sandbox";
  if (grading.isolation() == Isolation::container) std::cout << ", with a container's sandbox";
  if (options.settings.no_images) std::cout << ", without pictures";
  if (!grading.looks_for_memory_errors())
    std::cout << ", without a look for memory errors (no control group bounds memory)";
  std::cout << "\n" << fs::absolute(options.batch.out / "index.html").lexically_normal().string() << "\n";
  for (const std::string& problem : batch.problems)
    std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
  for (const std::string& name : batch.unreadable)
    std::cerr << "hairgrade: " << (options.batch.out / name).string()
              << ": its reports are not whole, so the class's files leave it out; grade " << name
              << " again\n";
  for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
  std::string not_final;
  for (const SubmissionResult& result : batch.results)
    if (!result.ended_by_the_clock.empty()) not_final += (not_final.empty() ? "" : ", ") + result.name;
  if (!not_final.empty())
    std::cerr << "hairgrade: not final, since the clock ended them: " << not_final
              << "; look at them, and grade them again (--resume grades no others)\n";
  if (!open_to_others.empty()) std::cerr << "hairgrade: " << open_to_others << "\n";
  if (!batch.interrupted) {
    if (!batch.problems.empty() || !intake.notices.empty()) return 1;
    return not_final.empty() ? 0 : 3;
  }
  std::cerr << "hairgrade: interrupted after " << batch.finished << " of " << intake.submissions.size()
            << " submissions; the same command with --resume goes on\n";
  return 130;
}

int handout(const HandoutOptions& options) {
  const std::string name = options.out.filename().string();
  if (!name.ends_with(".tar.gz") && !name.ends_with(".tgz"))
    throw BadInput("--out " + options.out.string() + ": the handout is a .tar.gz; give it such a name");
  const Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  const HandoutSources sources{HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR};
  if (options.accept) accept_files(sources, course);
  make_handout(sources, course, options.out);
  std::cout << options.out.string() << "\n";
  return 0;
}

int run(int argc, char* argv[]) {
  setlocale(LC_CTYPE, "C.UTF-8");  // names in archives may hold any letters
  signal(SIGPIPE, SIG_IGN);        // who reads what we write may be gone, as an archive's reader in its cage
  if (sodium_init() < 0) {
    std::cerr << "hairgrade: no source of random numbers\n";
    return 1;
  }
  CLI::App app("hairgrade: grades submissions of the hair assignment, and makes its handout");
  app.require_subcommand(1);

  GradeOptions grading;
  grading.batch.jobs = usable_jobs();
  CLI::App* grade_command = app.add_subcommand("grade", "Grade submissions and write reports");
  grade_command
      ->add_option("SUBMISSION", grading.submissions,
                   "An archive (.zip, .tar.gz), a folder, or either of these holding many")
      ->required();
  grade_command->add_option("--out", grading.batch.out, "The folder for reports")->required();
  grade_command
      ->add_option("-j", grading.batch.jobs,
                   "How many at a time (default: as many as processors and memory allow)")
      ->check(CLI::Range(1, 256));
  grade_command->add_flag("--resume", grading.batch.resume,
                          "Keep results whose submission and suite have not changed");
  grade_command->add_flag("--class", grading.classes,
                          "Each of several arguments may be a class; else each is one student's hand-in");
  grade_command->add_flag("--replace", grading.batch.replace,
                          "Replace rows of another origin: of another class, or of a hand-in from elsewhere");
  grade_command->add_option("--only", grading.batch.only, "Grade the submission of this name alone");
  grade_command->add_option("--exercise", grading.settings.exercise, "Grade this exercise alone");
  grade_command->add_option("--course", grading.settings.course,
                            "The course file: roles and points of the exercises");
  grade_command->add_option("--secret", grading.settings.secret,
                            "A file with the staff's secret (default: ~/.config/hairgrade/secret)");
  grade_command->add_option("--cache", grading.settings.cache,
                            "A folder for compiled objects (default: ~/.cache/hairgrade)");
  grade_command
      ->add_option("--cache-size", grading.settings.cache_megabytes,
                   "How many MB of compiled objects are kept; the oldest ones go (default: 2000)")
      ->check(CLI::Range(std::uintmax_t{1}, std::uintmax_t{1'000'000}));
  grade_command
      ->add_option_function<std::string>(
          "--isolation",
          [&grading](const std::string& word) { grading.settings.isolation = isolation_from(word); },
          "How student code is isolated: by namespaces, or as a container's root can (default: what works "
          "here)")
      ->check(CLI::IsMember({to_string(Isolation::namespaces), to_string(Isolation::container)}));
  grade_command->add_flag_callback(
      "--unsafe-no-sandbox", [&grading] { grading.settings.isolation = Isolation::none; },
      "Run student code unprotected; every report says so");
  grade_command->add_flag("--no-images", grading.settings.no_images,
                          "Draw nothing, where there is no OpenGL: the pictures' points go to the other "
                          "categories, and every report says so");
  grade_command->add_flag(
      "--study", grading.settings.study,
      "Show error against run time beside the reference's, in study.html; gives no points and "
      "takes none, but some seconds of CPU time for each submission");

  GradescopeOptions on_gradescope;
  CLI::App* gradescope_command = app.add_subcommand(
      "gradescope", "Grade one hand-in inside Gradescope's container (run_autograder does)");
  gradescope_command->add_option("FOLDER", on_gradescope.folder, "The folder with submission/ and results/")
      ->required();
  gradescope_command->add_option("--secret", on_gradescope.settings.secret, "A file with the staff's secret")
      ->required();
  gradescope_command->add_option("--course", on_gradescope.settings.course, "The course file");
  gradescope_command->add_option("--cache", on_gradescope.settings.cache, "A folder for compiled objects");
  gradescope_command->add_flag("--leaderboard", on_gradescope.leaderboard,
                               "Show the points on a leaderboard");

  CLI::App* package_command = app.add_subcommand("package", "Make what a platform grades with");
  package_command->require_subcommand(1);
  GradescopePackage packing;
  CLI::App* pack_gradescope =
      package_command->add_subcommand("gradescope", "Make Gradescope's autograder.zip");
  pack_gradescope->add_option("--out", packing.out, "The archive, a .zip")->required();
  pack_gradescope->add_option("--course", packing.course,
                              "The course file: roles and points of the exercises");
  pack_gradescope->add_option("--secret", packing.secret,
                              "A file with the staff's secret (default: ~/.config/hairgrade/secret)");
  pack_gradescope
      ->add_option("--minutes", packing.minutes, "The time limit that is set on Gradescope (default: 10)")
      ->check(CLI::Range(2, 40));
  pack_gradescope->add_flag(
      "--checks-only", packing.checks_only,
      "For the days before the deadline: the public checks, without points, secret and reference");
  pack_gradescope->add_flag("--leaderboard", packing.leaderboard, "Show the points on a leaderboard");

  HandoutOptions handing_out;
  CLI::App* handout_command = app.add_subcommand("handout", "Make the archive that students get");
  handout_command->add_option("--out", handing_out.out, "The archive, a .tar.gz")->required();
  handout_command->add_option("--course", handing_out.course,
                              "The course file: roles and points of the exercises");
  handout_command->add_flag("--accept", handing_out.accept,
                            "Accept the handout's files as they are now: write handout/packed.txt");

  CompareSettings comparing;
  CLI::App* compare_command =
      app.add_subcommand("compare", "Compare two pictures, or two folders of frames, worst first");
  compare_command->add_option("A", comparing.reference, "A PNG picture, or a folder of them")->required();
  compare_command->add_option("B", comparing.test, "What is compared with it: a picture, or a folder")
      ->required();
  compare_command->add_option("--out", comparing.out,
                              "A folder for heat maps, pictures side by side and a page of the worst");
  compare_command->add_flag("--json", comparing.json, "Print JSON in place of a table");

  fs::path secret_copy;
  CLI::App* secret_command = app.add_subcommand(
      "secret", "Move the staff's secret, from which every student's inputs are drawn, to another machine");
  secret_command->require_subcommand(1);
  CLI::App* export_command = secret_command->add_subcommand("export", "Write it to a new file");
  CLI::App* import_command = secret_command->add_subcommand("import", "Take it from a file");
  export_command->add_option("FILE", secret_copy, "The new file, which its owner alone can read")->required();
  import_command->add_option("FILE", secret_copy, "A file that secret export has written")->required();

  CLI::App* samples_command = app.add_subcommand("samples", "Tell of the sample class and the attacks");
  bool table = false;
  samples_command->add_flag("--table", table, "Print what each sample shows and gets, as Markdown")
      ->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    const bool without_command = argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty();
    std::cerr << "hairgrade: "
              << (without_command ? std::string(argv[1]) +
                                        " is no command; there are grade, compare, handout, package, "
                                        "gradescope, secret and samples"
                                  : error.what())
              << "; see hairgrade --help\n";
    return 2;
  }
  try {
    if (std::error_code gone; fs::current_path(gone).empty())
      throw BadInput("the folder that it was started in is gone; start it in another one");
    if (*compare_command) {
      note_interruptions();
      const int code = compare(comparing, std::cout, interrupted);
      if (code == 130) std::cerr << "hairgrade: interrupted; nothing was written\n";
      return code;
    }
    if (*samples_command) {
      std::cout << table_of(read_samples(HAIR_SOURCE_DIR));
      return 0;
    }
    if (*secret_command) {
      const std::string told = *export_command ? export_secret(secret_copy) : import_secret(secret_copy);
      std::cout << "the secret has the fingerprint " << told << "\n";
      return 0;
    }
    if (*gradescope_command) return grade_on_gradescope(on_gradescope);
    if (*package_command) return package_for_gradescope(packing);
    return *grade_command ? grade(grading) : handout(handing_out);
  } catch (const BadInput& error) {
    std::cerr << "hairgrade: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "hairgrade: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  hair::begin_output();
  // Other commands start no student's code, and keep the limits that whoever starts them has set.
  if (argc > 1 && std::string_view(argv[1]).starts_with("grade")) set_what_is_inherited(argv);
  return hair::finish_output("hairgrade", run(argc, argv));
}
