#include <memory>

#include "hair/lab/commands/command.h"
#include "hair/lab/commands/view_runs.h"

namespace hair {

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
