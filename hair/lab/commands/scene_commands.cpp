#include <memory>

#include "hair/lab/commands/command.h"
#include "hair/lab/commands/play.h"

namespace hair {

Command add_run_command(CLI::App& program) {
  const auto options = std::make_shared<PlayOptions>();
  CLI::App* app = program.add_subcommand("run", "Play a scene, and write what it does into a folder");
  app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along")->required();
  CLI::Option* out = app->add_option("--out", options->out, "The folder");
  app->add_option("--frames", options->frames, "How many, after the first (default: the scene's)")
      ->check(CLI::Range(0, 1'000'000));
  app->add_flag("--explain", options->explain,
                "Say which parts the scene needs, and which not; without --out that is all");
  app->add_flag("--no-render", options->no_render, "No pictures: OpenGL is not loaded");
  app->add_option("--jobs", options->jobs,
                  "Threads that move strands; 0: one for each processor (default: 1)")
      ->check(CLI::Range(0, 256));
  app->add_flag("--strict", options->strict, "With warnings the exit code is 1");
  app->final_callback([options, out] {
    if (out->count() == 0 && !options->explain)
      throw CLI::RequiredError("--out, a folder for what the run writes,");
  });
  return {app, [options](const Course& course) { return play_scene(*options, course); }};
}

Command add_scenes_command(CLI::App& program) {
  const auto keys = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand("scenes", "List the scenes that come along");
  app->add_flag("--keys", *keys,
                "List all keys that a scene can have instead, with their bounds, as Markdown");
  return {app, [keys](const Course& course) { return *keys ? list_keys() : list_scenes(course); }};
}

Command add_view_command(CLI::App& program) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* app = program.add_subcommand("view", "Write a page that plays a run: it opens in a browser");
  app->add_option("RUN", options->run, "The folder of a run; or a scene, which is played")->required();
  app->add_option("--with", options->other,
                  "Another run or scene, to compare with; reference: the reference's run of this scene");
  app->add_option("--out", options->out, "The page (default: view.html in the run's folder, or SCENE.html)");
  return {app, [options](const Course& course) { return view_runs(*options, course); }};
}

}  // namespace hair
