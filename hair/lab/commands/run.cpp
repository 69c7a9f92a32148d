#include "hair/lab/run.h"

#include <unistd.h>

#include <iostream>
#include <memory>

#include "hair/files/printable.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/explain.h"
#include "hair/lab/interruption.h"
#include "hair/lab/shipped_scenes.h"
#include "hair/lab/stub.h"

namespace hair {

namespace {

struct RunOptions {
  std::string scene;
  bool explain = false, no_render = false;
  RunSettings settings;
};

int run(const RunOptions& options) {
  const Scene scene = read_scene(find_scene(options.scene, HAIR_SCENES_DIR));
  RunSettings settings = options.settings;
  settings.render = !options.no_render;
  if (options.explain) {
    std::cout << scene.name << ": " << printable(scene.shows, 200) << "\n"
              << explanation(explain(scene, settings.render)) << std::flush;
    if (settings.out.empty()) return 0;
  }
  const std::atomic<bool>& interrupted =
      catch_interruption("\nhairlab: finishing this frame; once more ends at once\n");
  const bool terminal = isatty(STDERR_FILENO) != 0;
  std::optional<RunResult> played;
  try {
    played = run_scene(scene, settings, interrupted, std::cerr, terminal ? &std::cerr : nullptr);
  } catch (const NotImplemented& stub) {
    std::cerr << (terminal ? "\r" : "") << "hairlab: " << scene.name << " needs " << missing_part(stub)
              << "\n";
    return kNotWritten;
  }
  const RunResult& result = *played;
  const RunRecord& record = result.record;
  std::cout << result.folder.string() << ": " << record.frames.size() << " frames"
            << (record.no_pictures ? ", no pictures"
                : record.no_film   ? ""
                                   : ", film.mp4")
            << "\n";
  if (record.ending == Ending::blow_up) {
    std::cerr << "hairlab: " << scene.name << " broke: " << record.blow_up << "; what came before is kept\n";
    return kBroke;
  }
  if (record.ending == Ending::interrupted) {
    std::cerr << "hairlab: interrupted after " << record.frames.size() << " of " << record.frames_asked + 1
              << " frames, which are kept\n";
    return kInterrupted;
  }
  return 0;
}

}  // namespace

Command add_run_command(CLI::App& program) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* app = program.add_subcommand("run", "Play a scene, and write what it does into a folder");
  app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along")->required();
  CLI::Option* out = app->add_option("--out", options->settings.out, "The folder");
  app->add_option("--frames", options->settings.frames, "How many, after the first (default: the scene's)")
      ->check(CLI::Range(0, 1'000'000));
  app->add_flag("--explain", options->explain,
                "Say which parts the scene needs, and which not; without --out that is all");
  app->add_flag("--no-render", options->no_render, "No pictures: OpenGL is not loaded");
  app->final_callback([options, out] {
    if (out->count() == 0 && !options->explain)
      throw CLI::RequiredError("--out, a folder for what the run writes,");
  });
  return {app, [options] { return run(*options); }};
}

}  // namespace hair
