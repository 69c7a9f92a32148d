#include "hair/lab/commands/play.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/strict_json.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/commands/exit_codes.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/run.h"
#include "hair/lab/run/stub.h"
#include "hair/view/view_page.h"

namespace hair {

namespace {

namespace fs = std::filesystem;

// A folder that has a scene's name may hold something else than a run.
bool is_folder_of_run(const std::string& run) {
  if (!fs::is_directory(run)) return false;
  const std::vector<std::string> scenes = shipped_scenes(HAIR_SCENES_DIR);
  return fs::exists(fs::path(run) / kMotionFile) || std::ranges::find(scenes, run) == scenes.end();
}

NamedMotion of_folder(const fs::path& folder) {
  const fs::path file = folder / kMotionFile;
  if (!fs::exists(file))
    throw BadInput(folder.string() +
                   ": is no run that can be shown; give the folder that `hairlab run` wrote");
  const std::string name = fs::weakly_canonical(folder).filename().string();
  return {name, bytes_of(file)};
}

// The reference's run of a scene that ships.
fs::path reference_file(const std::string& scene) {
  return fs::path(HAIR_MOTIONS_DIR) / (fs::path(scene).filename().string() + ".json");
}

// A user's scene may have the name of a shipped one.
bool differs_from_shipped(const std::string& scene) {
  const fs::path file = find_scene(scene, HAIR_SCENES_DIR),
                 shipped = fs::path(HAIR_SCENES_DIR) / file.filename();
  return fs::exists(shipped) && bytes_of(file) != bytes_of(shipped);
}

NamedMotion reference_of(const std::string& scene) {
  const fs::path file = reference_file(scene);
  if (!fs::exists(file))
    throw BadInput(
        scene + ": the reference's run does not come along; it does for scenes that `hairlab scenes` lists");
  return {scene + " by the reference", bytes_of(file)};
}

bool terminal() {
  return isatty(STDERR_FILENO) != 0;
}

NamedMotion played(const Scene& scene, std::size_t most_points) {
  const TemporaryFolder folder("hairlab-view");
  RunSettings settings;
  settings.out = folder.path() / "run";
  settings.render = false;
  settings.for_page = true;
  settings.most_points = most_points;
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: finishing this frame; once more ends at once\n");
  const RunResult played =
      run_scene(scene, settings, interrupted, std::cerr, terminal() ? &std::cerr : nullptr);
  if (played.record.ending == Ending::blow_up)
    std::cerr << "hairlab: " << scene.name << " broke: " << played.record.blow_up
              << "; the page shows where\n";
  return {scene.name, bytes_of(settings.out / kMotionFile)};
}

struct Shown {
  NamedMotion motion;
  std::string scene;
  bool of_reference = false;
};

// The run of a folder or of a scene. If exercises are missing, it is the reference's run. Returns nothing,
// and names the exercises, if they are all that the scene shows.
std::optional<Shown> shown(const std::string& run, const Course& course, std::size_t most_points) {
  if (is_folder_of_run(run)) {
    const NamedMotion motion = of_folder(run);
    const fs::path file = fs::path(run) / "run.json";
    return Shown{motion, JsonValue(*read_document(file), file)["scene"].text()};
  }
  const Scene scene = read_course_scene(run, course);
  try {
    return Shown{played(scene, most_points), scene.name};
  } catch (const NotImplemented& stub) {
    std::cerr << (terminal() ? "\r" : "") << "hairlab: " << scene.name << " needs "
              << missing_parts(stub, exercises_of(scene), course);
    const bool comes_along = !differs_from_shipped(run) && fs::exists(reference_file(scene.name));
    std::cerr << (comes_along ? "; the page shows the reference's run\n" : "\n");
    if (!comes_along) return {};
    return Shown{reference_of(scene.name), scene.name, true};
  }
}

}  // namespace

int view_runs(const ViewOptions& options, const Course& course) {
  const bool folder = is_folder_of_run(options.run), with_reference = options.other == kReference;
  // The reference's run has few strands: the colours of two compared runs need the same ones.
  const std::size_t most_points = with_reference ? kMostPointsShipped : kMostPointsShown;
  if (with_reference && !folder && differs_from_shipped(options.run))
    throw BadInput(
        options.run +
        ": is another scene than the one that ships under this name, and the reference's run is of that one");
  const std::optional<Shown> one = shown(options.run, course, most_points);
  if (!one) return kNotWritten;
  std::vector<NamedMotion> motions = {one->motion};
  if (with_reference && !one->of_reference) motions.push_back(reference_of(one->scene));
  if (!with_reference && !options.other.empty()) {
    const std::optional<Shown> other = shown(options.other, course, most_points);
    if (!other) return kNotWritten;
    motions.push_back(other->motion);
  }
  if (motions.size() == 2 && motions[0].name == motions[1].name) motions[1].name += " (the other)";
  const fs::path out = !options.out.empty() ? options.out
                       : folder             ? fs::path(options.run) / "view.html"
                                            : fs::path(one->scene + ".html");
  write_file(out, view_page(motions));
  std::cout << out.string() << ": open it in a browser\n";
  return 0;
}

}  // namespace hair
