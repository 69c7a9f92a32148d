#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/machine.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_file.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/stub.h"
#include "hair/lab/study/study_page.h"
#include "hair/lab/study/study_record.h"
#include "hair/lab/study/sweep.h"

namespace hair {

namespace {

// What a run may take at most: evaluations and iterations times particles. A second or so, and a fifth of
// that.
constexpr double kMostWork = 1e7, kMostQuickWork = 5e5;
constexpr double kEnoughQuick = 0.05;  // s, that repeats of a run take together

using Clock = std::chrono::steady_clock;
constexpr Clock::duration kKeptEvery = std::chrono::seconds(1);

struct StudyOptions {
  std::string scene;
  std::filesystem::path out, cache;
  bool quick = false, resume = false, names_cache = false, no_cache = false, space = false;
  int strand = 0;
  std::optional<double> duration;
  std::vector<std::string> methods;
};

const OutputKind& study_output() {
  static const OutputKind kind{"hairlab study", "study.json", kStudyRecordBegin, {"study.csv", "index.html"}};
  return kind;
}

void require_writable(const std::filesystem::path& cache) {
  if (cache.empty()) throw BadInput("--cache: is empty; give the path of a folder");
  std::error_code error;
  std::filesystem::create_directories(cache, error);
  if (!error && access(cache.c_str(), W_OK | X_OK) != 0) error = {errno, std::generic_category()};
  if (error)
    throw BadInput("--cache: " + printable(cache.string(), 4096) + " can't be written (" + error.message() +
                   "); give a folder that can be, or --no-cache");
}

// One that is named must do; without, there may be none.
std::optional<std::filesystem::path> cache_folder(const StudyOptions& options) {
  if (options.no_cache) return {};
  if (options.names_cache) {
    require_writable(options.cache);
    return options.cache;
  }
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value ? value : "");
  };
  if (const auto folder = variable("XDG_CACHE_HOME"); folder.is_absolute()) return folder / "hairlab";
  if (const auto home = variable("HOME"); home.is_absolute()) return home / ".cache" / "hairlab";
  return {};
}

ProblemSettings problem_settings(const Scene& scene, const StudyOptions& options) {
  ProblemSettings settings{options.strand, options.duration, {}};
  if (!options.quick) return settings;
  const std::optional<int> segments = segments_to_divide(scene, options.strand);
  if (segments && *segments > kQuickSegments) settings.segments = kQuickSegments;
  return settings;
}

std::vector<StudyMethod> chosen_methods(const Problem& problem, const std::vector<std::string>& ids,
                                        const Course& course) {
  std::vector<StudyMethod> methods = methods_for(problem, course.absent());
  std::string known;
  for (const StudyMethod& method : methods) known += (known.empty() ? "" : ", ") + method.id;
  for (const std::string& id : ids)
    if (std::none_of(methods.begin(), methods.end(), [&](const StudyMethod& one) { return one.id == id; }))
      throw BadInput("--methods: there is no \"" + printable(id) + "\" for this scene; there are " + known);
  if (!ids.empty())
    std::erase_if(methods, [&](const StudyMethod& one) {
      return std::find(ids.begin(), ids.end(), one.id) == ids.end();
    });
  if (methods.empty()) throw BadInput(problem.scene.name + ": this course leaves out all methods for it");
  return methods;
}

void keep(const Study& study, OutputFolder& folder) {
  write_whole(folder, "study.csv", to_csv(table_of_runs(study)));
  write_whole(folder, "index.html", to_html(study_page(study)));
  write_whole(folder, "study.json", study_json(study));
  folder.keep();
}

// A line that is written over and over, on a terminal alone.
class Progress {
 public:
  void say(const std::string& what) const {
    if (terminal_) std::cerr << "\r\x1b[K" << what << std::flush;
  }
  void clear() const { say(""); }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

// Whether a run got anywhere.
bool has_runs(const Study& study) {
  return std::any_of(study.sweeps.begin(), study.sweeps.end(),
                     [](const Sweep& sweep) { return !sweep.runs.empty(); });
}

int run(const StudyOptions& options, const Course& course) {
  if (!have_accurate_motion()) {
    std::cerr
        << "hairlab: a study needs SUNDIALS, and this hairlab was built without it: install libsundials-dev, "
           "then configure and build anew\n";
    return kBroke;
  }
  // Also nan, which CLI::Range lets pass.
  if (options.duration && !(*options.duration >= 1e-6 && *options.duration <= 1000))
    throw BadInput("--duration: " + to_exact_text(*options.duration) + " is not right; give 1e-6 to 1000");
  const Scene scene = read_course_scene(options.scene, course);
  const Problem problem = make_problem(scene, problem_settings(scene, options));
  const std::vector<StudyMethod> methods = chosen_methods(problem, options.methods, course);
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: keeping what is finished; once more ends at once\n");
  std::optional<OutputFolder> folder(std::in_place, options.out, study_output());

  StudySettings settings;
  settings.most_work = options.quick ? kMostQuickWork : kMostWork;
  if (options.quick) settings.repeats.enough = kEnoughQuick;
  Study study = prepare_study(problem, methods, settings);
  study.quick = options.quick;
  study.strand = options.strand;
  study.program_digest = program_digest();
  // What can't be resumed is refused at once, not after the accurate motion, which takes long.
  if (options.resume) read_runs(folder->earlier_record(), study);

  const Progress progress;
  progress.say("the accurate motion");
  const std::optional<AccurateMotion> motion =
      accurate_motion(problem, {kTightest, cache_folder(options)}, interrupted);
  progress.clear();
  if (!motion) {
    std::cerr << "hairlab: interrupted before the accurate motion was known; nothing is written\n";
    return kInterrupted;
  }

  set_reference(problem, *motion, study);
  if (options.resume) read_runs(folder->earlier_record(), study);

  // A run that never ends, in an exercise, loses no more than what came within a second before it.
  auto kept = Clock::now() - kKeptEvery;
  settings.progress = [&](const std::string& what) {
    progress.say(what);
    if (!has_runs(study) || Clock::now() - kept < kKeptEvery) return;
    keep(study, *folder);
    folder.emplace(options.out, study_output());
    kept = Clock::now();
  };
  progress.say("the space error");
  study.space_error =
      space_error(problem, options.space ? Patience::minutes : Patience::seconds, interrupted);
  const bool finished = finish_study(problem, *motion, settings, study, interrupted);
  progress.clear();

  if (!has_runs(study)) {
    if (!finished) {
      std::cerr << "hairlab: interrupted before a run was finished; nothing is written\n";
      return kInterrupted;
    }
    std::cerr << "hairlab: " << study.scene << " needs " << missing_part(study.sweeps[0].left_out) << "\n";
    return kNotWritten;
  }
  keep(study, *folder);

  for (const Sweep& sweep : study.sweeps)
    if (!sweep.left_out.empty())
      std::cerr << "hairlab: " << sweep.method.name << " is left out: " << missing_part(sweep.left_out)
                << "\n";
  std::cout << (folder->path() / "index.html").string() << "\n";
  if (!finished) {
    std::cerr << "hairlab: interrupted; what is finished is kept, and --resume goes on\n";
    return kInterrupted;
  }
  return 0;
}

}  // namespace

Command add_study_command(CLI::App& program) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* app = program.add_subcommand(kErrorStudy.name, kErrorStudy.what);
  CLI::Option* scene =
      app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along");
  CLI::Option* out =
      app->add_option("--out", options->out, "The folder for index.html, study.csv and study.json");
  // Both are required, but not of a command of its own (`study head`).
  app->parse_complete_callback([app, scene, out] {
    if (!app->get_subcommands().empty()) return;
    for (const CLI::Option* one : {scene, out})
      if (one->count() == 0) throw CLI::RequiredError(one->get_name());
  });
  app->add_flag("--quick", options->quick, "10 segments, and shorter sweeps: seconds instead of a minute");
  app->add_flag("--resume", options->resume, "Go on with the study in the folder, which was interrupted");
  app->add_flag("--space", options->space,
                "Also of soft hair, how far its segments are from infinitely many: that may take minutes");
  app->add_option("--strand", options->strand, "Which of the scene's strands, or toys (default: 0)")
      ->check(CLI::Range(0, 10'000'000));
  app->add_option("--duration", options->duration, "s, 1e-6 to 1000 (default: the scene's, but at most 0.2)");
  app->add_option("--methods", options->methods, "Which, with commas between (default: all that fit)")
      ->delimiter(',');
  CLI::Option* cache = app->add_option("--cache", options->cache, "Where accurate motions are kept");
  app->add_flag("--no-cache", options->no_cache, "Keep none, and use none that was kept")->excludes(cache);
  return {app, [options, cache](const Course& course) {
            options->names_cache = cache->count() > 0;
            return run(*options, course);
          }};
}

}  // namespace hair
