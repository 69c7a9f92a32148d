#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/stability/report.h"
#include "hair/lab/stub.h"

namespace hair {

namespace {

struct StabilityOptions {
  std::string scene, out;
  bool quick = false, resume = false;
  StabilitySettings settings;
};

const OutputKind& stability_output() {
  static const OutputKind kind{"hairlab stability",
                               "stability.json",
                               kStabilityBegin,
                               {"index.html", "boundaries.csv", "curves.csv", "extremes.csv"},
                               false};
  return kind;
}

void write(const OutputFolder& folder, const StabilityReport& report) {
  write_file(folder.now("boundaries.csv"), to_csv(table_of_boundaries(report)));
  write_file(folder.now("curves.csv"), to_csv(table_of_curves(report)));
  write_file(folder.now("extremes.csv"), to_csv(table_of_extremes(report)));
  write_file(folder.now("stability.json"), json_of(report));
  write_file(folder.now("index.html"), to_html(page_of(report)));
}

int run(const StabilityOptions& options, const Course& course) {
  const Scene scene = read_course_scene(options.scene, course);
  StabilitySettings settings = options.settings;
  settings.absent = course.absent();
  settings.quick = options.quick;
  if (options.quick) settings.maps = quick_maps();
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: stopping, what is finished is kept; once more ends at once\n");
  OutputFolder folder(options.out, stability_output());
  if (options.resume) settings.finished = read_maps(folder.earlier_record(), identity_of(scene, settings));
  const bool terminal = isatty(STDERR_FILENO) != 0;
  StabilityReport report = study_stability(scene, settings, interrupted, [&](const std::string& what) {
    if (terminal) std::cerr << "\r\x1b[K" << what << std::flush;
  });
  if (terminal) std::cerr << "\r\x1b[K" << std::flush;

  for (LeftOut& one : report.left_out) {
    one.why = one.stub ? "it needs " + missing_part(*one.stub) : printable(one.why);
    std::cerr << "hairlab: " << one.method.name << " is left out: " << one.why << "\n";
  }
  if (report.maps.empty() && report.extremes.empty()) {
    if (report.interrupted) {
      std::cerr << "hairlab: interrupted before a map was finished; nothing is written\n";
      return kInterrupted;
    }
    const bool stub = std::any_of(report.left_out.begin(), report.left_out.end(),
                                  [](const LeftOut& one) { return one.stub.has_value(); });
    std::cerr << "hairlab: no method is left; nothing is written\n";
    return stub ? kNotWritten : kBroke;
  }
  write(folder, report);
  folder.keep();
  std::cout << folder.then("index.html").string() << ": " << report.maps.size() << " maps, "
            << report.extremes.size() << " extreme cases\n";
  if (report.interrupted) {
    std::cerr << "hairlab: interrupted after " << report.maps.size() << " of " << report.maps_asked
              << " maps, which are kept; --resume goes on\n";
    return kInterrupted;
  }
  return 0;
}

}  // namespace

Command add_stability_command(CLI::App& program) {
  const auto options = std::make_shared<StabilityOptions>();
  CLI::App* app = program.add_subcommand(kStabilityStudy.name, kStabilityStudy.what);
  app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along")->required();
  app->add_option("--out", options->out, "The folder for page, CSV and JSON")->required();
  app->add_flag("--quick", options->quick, "Coarser maps: seconds instead of half a minute");
  app->add_flag("--resume", options->resume, "Go on with the study in the folder, which was interrupted");
  app->add_option("--strand", options->settings.strand, "Which strand, counted from 0")
      ->check(CLI::Range(0, 100'000'000));
  app->add_option("--segments", options->settings.segments,
                  "Divide it anew into so many (default: the scene's, at most 10)")
      ->check(CLI::Range(1, 200));
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
