#include <iostream>
#include <memory>

#include "hair/lab/commands/study_shell.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/stub.h"
#include "hair/lab/stability/report.h"

namespace hair {

namespace {

struct StabilityOptions : ShellOptions {
  std::string scene;
  StabilitySettings settings;
};

int run(const StabilityOptions& options, const Course& course) {
  const Scene scene = read_course_scene(options.scene, course);
  StabilitySettings settings = options.settings;
  settings.absent = course.absent();
  if (options.quick) settings.maps = kQuickMaps;
  StudyShell shell(options, "hairlab stability", "stability.json",
                   {"index.html", "boundaries.csv", "curves.csv", "extremes.csv"}, WhenInterrupted::keeps);
  StabilityReport report = study_stability(scene, settings, shell.interrupted(), shell.teller());
  shell.say("");

  for (LeftOut& one : report.left_out) {
    one.why = one.stub ? "it needs " + missing_part(*one.stub) : printable(one.why);
    std::cerr << "hairlab: " << one.method.name << " is left out: " << one.why << "\n";
  }
  if (!report.maps.empty() || !report.extremes.empty()) {
    shell.keep(json_of(report), page_of(report),
               {{"boundaries.csv", limit_rows(report)},
                {"curves.csv", curve_rows(report)},
                {"extremes.csv", rows_of(report.extremes, row_of_extreme)}});
  } else if (!report.interrupted) {
    std::cerr << "hairlab: no method is left; nothing is written\n";
    return std::ranges::any_of(report.left_out, [](const LeftOut& one) { return one.stub.has_value(); })
               ? kNotWritten
               : kBroke;
  }
  return shell.end(!report.interrupted, ": " + std::to_string(report.maps.size()) + " maps, " +
                                            std::to_string(report.extremes.size()) + " extreme cases");
}

}  // namespace

Command add_stability_command(CLI::App& program) {
  const auto options = std::make_shared<StabilityOptions>();
  CLI::App* app = add_study(program, kStabilityStudy, *options,
                            "a coarser grid, and shorter runs: seconds instead of half a minute");
  app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along")->required();
  app->add_option("--strand", options->settings.strand, "Which strand, counted from 0")
      ->check(CLI::Range(0, 100'000'000));
  app->add_option("--segments", options->settings.segments,
                  "Divide it anew into so many (default: the scene's, at most 10)")
      ->check(CLI::Range(1, 200));
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
