// What hairlab's programs do alike.
#pragma once

#include <vector>

#include "hair/lab/commands/command.h"

namespace hair {

// Reads the command line and runs the command that it names. What goes wrong is said in one line. Returns what the
// program is to return.
int run_program(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[]);

}  // namespace hair
