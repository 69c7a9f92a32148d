// hairlab: plays scenes of hair with the exercises' code, and studies how well they are played. Its exit codes are
// in hair/lab/commands/command.h.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "hair/files/bad_input.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/stub.h"

int main(int argc, char* argv[]) {
  CLI::App app("hairlab: plays scenes of hair with your code");
  app.require_subcommand(1);
  const std::vector<hair::Command> commands = {
      hair::add_run_command(app),       hair::add_scenes_command(app), hair::add_solver_command(app),
      hair::add_stability_command(app), hair::add_study_command(app),  hair::add_validate_command(app)};
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hairlab: " << error.what() << "; see hairlab --help\n";
    return hair::kBadInput;
  }
  const auto asked = std::find_if(commands.begin(), commands.end(),
                                  [](const hair::Command& one) { return one.app->parsed(); });
  try {
    return asked->run();
  } catch (const hair::BadInput& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return hair::kBadInput;
  } catch (const NotImplemented& stub) {
    std::cerr << "hairlab: this needs " << hair::missing_part(stub) << "\n";
    return hair::kNotWritten;
  } catch (const std::exception& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return hair::kBroke;
  }
}
