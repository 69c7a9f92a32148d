// hairlab: plays scenes of hair with the exercises' code.
//
// Exit code 0: done. 1: it broke on the way (what came before is kept), or the code of an exercise threw.
// 2: bad input or usage. 3: an exercise that the scene calls is not written yet. 130: interrupted; what was
// finished is kept.
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <iostream>

#include "hair/files/bad_input.h"
#include "hair/files/printable.h"
#include "hair/lab/explain.h"
#include "hair/lab/run.h"
#include "hair/lab/shipped_scenes.h"
#include "hair/lab/stub.h"

namespace {

using namespace hair;

constexpr int kBroke = 1, kBadInput = 2, kNotWritten = 3, kInterrupted = 130;

// A signal handler has nothing else that it may touch.
std::atomic<bool> interrupted = false;

// The second time it ends at once.
void on_interrupt(int) {
  interrupted = true;
  constexpr std::string_view kMessage = "\nhairlab: finishing this frame; once more ends at once\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
}

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
  // Writing then fails, and says why.
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

struct RunOptions {
  std::string scene;
  bool explain = false, no_render = false;
  RunSettings settings;
};

int run(const RunOptions& options) {
  const Scene scene = read_scene(find_scene(options.scene, HAIR_SCENES_DIR));
  if (options.explain) {
    std::cout << scene.name << ": " << printable(scene.shows, 200) << "\n"
              << explanation(explain(scene, options.settings.render)) << std::flush;
    if (options.settings.out.empty()) return 0;
  }
  catch_signals();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  try {
    const RunResult result =
        run_scene(scene, options.settings, interrupted, std::cerr, terminal ? &std::cerr : nullptr);
    const RunRecord& record = result.record;
    std::cout << result.folder.string() << ": " << record.frames.size() << " frames"
              << (record.no_pictures ? ", no pictures"
                  : record.no_film   ? ""
                                     : ", film.mp4")
              << "\n";
    if (record.ending == Ending::blow_up) {
      std::cerr << "hairlab: " << scene.name << " broke: " << record.blow_up
                << "; what came before is kept\n";
      return kBroke;
    }
    if (record.ending == Ending::interrupted) {
      std::cerr << "hairlab: interrupted after " << record.frames.size() << " of " << record.frames_asked + 1
                << " frames, which are kept\n";
      return kInterrupted;
    }
    return 0;
  } catch (const NotImplemented& stub) {
    std::cerr << (terminal ? "\r" : "") << "hairlab: " << scene.name << " needs " << missing_part(stub)
              << "\n";
    return kNotWritten;
  }
}

int list_scenes() {
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR)) try {
      const Scene scene = read_scene(find_scene(name, HAIR_SCENES_DIR));
      std::string exercises;
      for (const std::string& id : exercises_of(scene)) exercises += (exercises.empty() ? "" : ", ") + id;
      std::cout << name << ": " << printable(scene.shows, 200) << " (" << exercises << ")\n";
    } catch (const BadInput& error) {
      // One that needs what this course leaves out says so.
      std::cout << name << ": can't be played: " << error.what() << "\n";
    }
  return 0;
}

}  // namespace

int main(int argc, char* argv[]) {
  CLI::App app("hairlab: plays scenes of hair with your code");
  app.require_subcommand(1);

  RunOptions running;
  CLI::App* run_command = app.add_subcommand("run", "Play a scene, and write what it does into a folder");
  run_command->add_option("SCENE", running.scene, "A scene's file, or the name of one that comes along")
      ->required();
  CLI::Option* out = run_command->add_option("--out", running.settings.out, "The folder");
  run_command
      ->add_option("--frames", running.settings.frames, "How many, after the first (default: the scene's)")
      ->check(CLI::Range(0, 1'000'000));
  CLI::Option* explained =
      run_command->add_flag("--explain", running.explain,
                            "Say which parts the scene needs, and which not; without --out that is all");
  run_command->add_flag("--no-render", running.no_render, "No pictures: OpenGL is not loaded");

  CLI::App* scenes_command = app.add_subcommand("scenes", "List the scenes that come along");

  try {
    app.parse(argc, argv);
    if (*run_command && out->count() == 0 && explained->count() == 0)
      throw CLI::RequiredError("--out, a folder for what the run writes,");
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hairlab: " << error.what() << "; see hairlab --help\n";
    return kBadInput;
  }
  running.settings.render = !running.no_render;
  try {
    return *scenes_command ? list_scenes() : run(running);
  } catch (const BadInput& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBroke;
  }
}
