#include "hair/lab/commands/play.h"

#include <unistd.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <thread>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/lab/commands/exit_codes.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/explain.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/run.h"
#include "hair/lab/run/stub.h"
#include "solver/timing.h"

namespace hair {

constexpr double kFarOff = 0.1;  // times a strand's length: it is seen

int play_scene(const PlayOptions& options, const Course& course) {
  const timing::Stopwatch reading;
  Scene scene = read_course_scene(options.scene, course);
  const double read_seconds = reading.seconds();
  scene.hair.jobs =
      options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const RunSettings settings{.out = options.out,
                             .frames = options.frames,
                             .render = !options.no_render,
                             .read_seconds = read_seconds};
  if (options.explain) {
    std::cout << scene.name << ": " << printable(scene.shows, 200) << "\n"
              << explanation(explain(scene, settings.render, course)) << std::flush;
    if (settings.out.empty()) return 0;
  }
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: finishing this frame; once more ends at once\n");
  const bool terminal = isatty(STDERR_FILENO) != 0;
  std::optional<RunResult> played;
  try {
    played = run_scene(scene, settings, interrupted, std::cerr, terminal ? &std::cerr : nullptr);
  } catch (const NotImplemented& stub) {
    std::cerr << (terminal ? "\r" : "") << "hairlab: " << scene.name << " needs "
              << missing_parts(stub, exercises_of(scene), course) << "\n";
    return kNotWritten;
  }
  const RunResult& result = *played;
  const RunRecord& record = result.record;
  std::cout << result.folder.string() << ": " << record.frames.size() << " frames"
            << (record.no_pictures ? ", no pictures"
                : record.no_film   ? ""
                                   : ", film.mp4");
  if (!record.off_by)
    std::cout << "; not compared with a finer step";
  else if (*record.off_by > 1)
    std::cout << "; steps take most of the energy, so places can't be trusted";
  else if (*record.off_by > kFarOff)
    std::cout << std::setprecision(2) << "; steps take energy, so places are off by about " << *record.off_by
              << " of a strand's length";
  std::cout << "\n";
  if (!record.warnings.empty())
    std::cerr << "hairlab: " << scene.name << ": warning: " << warning_text(record.warnings) << "\n";
  if (record.ending == Ending::blow_up) {
    std::cerr << "hairlab: " << scene.name << " broke: " << record.blow_up << "; what came before is kept\n";
    return kBroke;
  }
  if (record.ending == Ending::interrupted) {
    std::cerr << "hairlab: interrupted after " << record.frames.size() << " of " << record.frames_asked + 1
              << " frames, which are kept\n";
    return kInterrupted;
  }
  return options.strict && !record.warnings.empty() ? kBroke : 0;
}

void show_overview(const Course& course) {
  std::vector<std::string> all;
  for (const Exercise& exercise : course.exercises)
    if (exercise.role != Role::absent) all.push_back(exercise.id);
  const std::string stubs = stubs_among(all, course);
  if (stubs.empty()) return;
  std::string playing;
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR)) try {
      if (stubs_among(exercises_of(read_course_outline(name, course)), course).empty())
        playing += (playing.empty() ? "" : ", ") + name;
    } catch (const BadInput&) {  // the course lacks an exercise of the scene
    }
  std::cout << "Not written yet: " << stubs
            << "\nScenes that play without them: " << (playing.empty() ? "none" : playing)
            << "\nAll others, as the reference moves them: hairlab view SCENE" << std::endl;
}

int list_scenes(const Course& course) {
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR)) try {
      const Scene scene = read_course_outline(name, course);
      std::string exercises, stubs;
      for (const std::string& id : exercises_of(scene)) {
        exercises += (exercises.empty() ? "" : ", ") + id;
        if (const Exercise* one = course.find(id); one && one->stub)
          stubs += (stubs.empty() ? "" : ", ") + id;
      }
      std::cout << name << ": " << printable(scene.shows, 200) << " (" << exercises
                << (stubs.empty() ? "" : "; stubs: " + stubs) << ")\n";
    } catch (const BadInput& error) {
      // The message names an exercise that is not in this course.
      std::cout << name << ": can't be played: " << error.what() << "\n";
    }
  return 0;
}

int list_keys() {
  std::cout << scene_keys() << std::flush;
  return 0;
}

}  // namespace hair
