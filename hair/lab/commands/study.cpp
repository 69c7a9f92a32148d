#include <chrono>
#include <iostream>
#include <memory>

#include "hair/io/files/kept_file.h"
#include "hair/lab/commands/study_shell.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/stub.h"
#include "hair/lab/study/study_record.h"
#include "hair/lab/study/written_down.h"

namespace hair {

namespace {

// The most work of a run: evaluations and iterations times particles. It takes about a second, or a fifth of
// that.
constexpr double kMostWork = 1e7, kMostQuickWork = 5e5;
constexpr double kEnoughQuick = 0.05;  // s, that repeats of a run take together

using Clock = std::chrono::steady_clock;
constexpr Clock::duration kKeptEvery = std::chrono::seconds(1);

struct StudyOptions : ShellOptions {
  std::string scene;
  bool no_cache = false;
  int strand = 0;
  std::optional<double> duration;
  std::vector<std::string> methods;
};

ProblemSettings problem_settings(const Scene& scene, const StudyOptions& options) {
  ProblemSettings settings{options.strand, options.duration, {}};
  if (!options.quick) return settings;
  const std::optional<int> segments = segments_to_divide(scene, options.strand);
  if (segments && *segments > kQuickSegments) settings.segments = kQuickSegments;
  return settings;
}

std::vector<StudyMethod> chosen_methods(const Problem& problem, const StudyOptions& options,
                                        const Course& course) {
  const std::vector<StudyMethod> all = methods_for(problem, course.absent());
  if (all.empty()) throw BadInput(problem.scene.name + ": this course leaves out all methods for it");
  return chosen(all, options.methods, "--methods");
}

// True if a run took a step.
bool has_runs(const Study& study) {
  return std::ranges::any_of(study.sweeps, [](const Sweep& sweep) { return !sweep.runs.empty(); });
}

int run(const StudyOptions& options, const Course& course) {
  if (!have_accurate_motion()) {
    std::cerr << "hairlab: a study needs SUNDIALS, and this hairlab was built without it: install "
                 "libsundials-dev, then configure and build anew\n";
    return kBroke;
  }
  // Also nan, which CLI::Range lets pass.
  if (options.duration && !(*options.duration >= 1e-6 && *options.duration <= 1000))
    throw BadInput("--duration: " + to_exact_text(*options.duration) + " is not right; give 1e-6 to 1000");
  const Scene scene = read_course_scene(options.scene, course);
  const Problem problem = make_problem(scene, problem_settings(scene, options));
  const std::vector<StudyMethod> methods = chosen_methods(problem, options, course);
  StudyShell shell(options, "hairlab study", "study.json", {"study.csv", "index.html"},
                   WhenInterrupted::keeps);
  const std::atomic<bool>& interrupted = shell.interrupted();

  StudySettings settings;
  settings.most_work = options.quick ? kMostQuickWork : kMostWork;
  if (options.quick) settings.repeats.enough = kEnoughQuick;
  shell.say("the accurate motion");
  std::optional<AccurateMotion> motion =
      accurate_motion(problem, {kTightest, options.no_cache ? std::nullopt : cache_folder()}, interrupted);
  if (!motion) return shell.end(false);
  Study study = prepare_study(problem, methods, settings, std::move(*motion));
  study.quick = options.quick;
  study.strand = options.strand;

  // If an exercise never returns, only the results of the last second are lost.
  const auto keep = [&] {
    shell.keep(study_json(study), study_page(study), {{"study.csv", run_rows(study)}});
  };
  auto kept = Clock::now() - kKeptEvery;
  settings.progress = [&](const std::string& what) {
    shell.say(what);
    if (!has_runs(study) || Clock::now() - kept < kKeptEvery) return;
    keep();
    kept = Clock::now();
  };
  shell.say("the space error");
  study.space_error = space_error(problem, interrupted);
  const bool finished = finish_study(problem, settings, study, interrupted);
  if (finished && options.methods.empty()) add_written_down(problem, study, interrupted);
  shell.say("");

  if (has_runs(study)) {
    keep();
    for (const Sweep& sweep : study.sweeps)
      if (!sweep.left_out.empty())
        std::cerr << "hairlab: " << sweep.method.name << " is left out: " << missing_part(sweep.left_out)
                  << "\n";
  } else if (finished) {
    std::cerr << "hairlab: " << study.scene << " needs " << missing_part(study.sweeps[0].left_out) << "\n";
    return kNotWritten;
  }
  return shell.end(finished);
}

}  // namespace

Command add_study_command(CLI::App& program) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* app = add_study(program, kErrorStudy, *options,
                            "at most 10 segments, and shorter sweeps: seconds instead of a minute", false);
  CLI::Option* scene =
      app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along");
  // Both are required, except for a command of its own (`study head`).
  app->parse_complete_callback([app, scene] {
    if (!app->get_subcommands().empty()) return;
    for (const CLI::Option* one : {scene, app->get_option("--out")})
      if (one->count() == 0) throw CLI::RequiredError(one->get_name());
  });
  app->add_option("--strand", options->strand, "Which of the scene's strands, or toys (default: 0)")
      ->check(CLI::Range(0, 10'000'000));
  app->add_option("--duration", options->duration, "s, 1e-6 to 1000 (default: the scene's, but at most 0.2)");
  app->add_option("--methods", options->methods, "Which, with commas between (default: all that fit)")
      ->delimiter(',');
  app->add_flag("--no-cache", options->no_cache, "Keep no accurate motion, and use none that was kept");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
