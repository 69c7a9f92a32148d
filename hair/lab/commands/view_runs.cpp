#include "hair/lab/commands/view_runs.h"

#include <iostream>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/commands/exit_codes.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/run.h"
#include "hair/lab/stub.h"
#include "hair/view/view_page.h"

namespace hair {

namespace {

namespace fs = std::filesystem;

NamedMotion of_folder(const fs::path& folder) {
  const fs::path file = folder / kMotionFile;
  if (!fs::exists(file))
    throw BadInput(folder.string() +
                   ": is no run that can be shown; give the folder that `hairlab run` wrote");
  const std::string name = fs::weakly_canonical(folder).filename().string();
  return {name, bytes_of(file)};
}

NamedMotion of_scene(const std::string& name, const Course& course) {
  const Scene scene = read_course_scene(name, course);
  const TemporaryFolder folder("hairlab-view");
  RunSettings settings;
  settings.out = folder.path() / "run";
  settings.render = false;
  settings.draws = true;
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: finishing this frame; once more ends at once\n");
  const RunResult played = run_scene(scene, settings, interrupted, std::cerr, nullptr);
  if (played.record.ending == Ending::blow_up)
    std::cerr << "hairlab: " << scene.name << " broke: " << played.record.blow_up
              << "; the page shows where\n";
  return {scene.name, bytes_of(settings.out / kMotionFile)};
}

}  // namespace

int view_runs(const ViewOptions& options, const Course& course) try {
  const bool folder = fs::is_directory(options.run);
  std::vector<NamedMotion> motions;
  for (const std::string& one : {options.run, options.other})
    if (!one.empty()) motions.push_back(fs::is_directory(one) ? of_folder(one) : of_scene(one, course));
  if (motions.size() == 2 && motions[0].name == motions[1].name) motions[1].name += " (the other)";
  const fs::path out = !options.out.empty() ? options.out
                       : folder             ? fs::path(options.run) / "view.html"
                                            : fs::path(motions.front().name + ".html");
  write_file(out, view_page(motions));
  std::cout << out.string() << ": open it in a browser\n";
  return 0;
} catch (const NotImplemented& stub) {
  std::cerr << "hairlab: " << options.run << " needs " << missing_part(stub) << "\n";
  return kNotWritten;
}

}  // namespace hair
