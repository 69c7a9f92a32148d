// The common main function of hairlab's programs.
#pragma once

#include <vector>

#include "hair/lab/commands/command.h"

namespace hair {

// Parses the command line, reads the course (each command has --course), marks the program's stubs, and runs
// the named command; without one, runs `overview`, if there is one, before the error. Prints an error as one
// line, also for results that the standard output does not accept. Returns the exit code.
int run_program(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[],
                const std::function<void(const Course&)>& overview = {});

}  // namespace hair
