// hairlab-live: runs a scene while somebody watches and changes it. `hairlab live` starts it.
#include <filesystem>
#include <memory>

#include "hair/io/files/start_program.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/interruption.h"
#include "hair/live/live.h"
#include "hair/live/runner.h"

namespace {

struct Options {
  std::string scene;
  int port = 0;
  bool plays = false;
};

hair::Command add_live_command(CLI::App& program, const std::vector<std::string>& words) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("live", "Play a scene while it is computed, in a browser");
  app->add_option("SCENE", options->scene, "A scene's file, or the name of one that comes along")->required();
  app->add_option("--port", options->port, "The server's port (default: a free one)")
      ->check(CLI::Range(1, 65535));
  app->add_flag("--plays-for-page", options->plays, "The server starts itself so")->group("");
  return {app, [options, words](const hair::Course& course) {
            if (options->plays) return hair::play_for_page(options->scene, course);
            const hair::Scene outline = hair::read_course_outline(options->scene, course);
            hair::LiveOptions live{outline.name, outline.shows, options->port, words};
            hair::ProgramFile file(std::filesystem::canonical(hair::this_program()));
            live.words.front() = file.path().string();
            live.words.emplace_back("--plays-for-page");
            const std::atomic<bool>& interrupted = hair::catch_interruption("\n");
            hair::serve_live(live, std::move(file), interrupted);
            return 0;
          }};
}

}  // namespace

int main(int argc, char* argv[]) {
  CLI::App app("hairlab live: plays a scene while it is computed");
  const std::vector<hair::Command> commands = {add_live_command(app, {argv, argv + argc})};
  return hair::run_program(app, commands, argc, argv);
}
