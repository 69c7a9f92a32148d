#include "hair/lab/commands/program.h"

#include <algorithm>
#include <iostream>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stub.h"

namespace hair {

int run_program(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[]) {
  try {
    app.require_subcommand(1);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "hairlab: " << error.what() << "; see hairlab --help\n";
    return kBadInput;
  }
  const auto asked =
      std::find_if(commands.begin(), commands.end(), [](const Command& one) { return one.app->parsed(); });
  try {
    return asked->run();
  } catch (const BadInput& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBadInput;
  } catch (const NotImplemented& stub) {
    std::cerr << "hairlab: this needs " << missing_part(stub) << "\n";
    return kNotWritten;
  } catch (const std::exception& error) {
    std::cerr << "hairlab: " << error.what() << "\n";
    return kBroke;
  }
}

}  // namespace hair
