// hairlab's subcommands: each adds its options to the program's and returns the function to run after
// parsing.
//
// The return value of a command is the program's exit code. A command may throw BadInput (exit code 2),
// NotInCourse (2), NotImplemented (3), or anything else (1).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "hair/course/course.h"
#include "hair/lab/commands/exit_codes.h"

namespace hair {

struct Command {
  CLI::App* app;
  std::function<int(const Course&)> run;
};

Command add_bowl_command(CLI::App& program);
Command add_convert_command(CLI::App& program);
Command add_groom_command(CLI::App& program);
Command add_info_command(CLI::App& program);
Command add_phase_command(CLI::App& program);
Command add_run_command(CLI::App& program);
Command add_scenes_command(CLI::App& program);
Command add_solver_command(CLI::App& program);
Command add_stability_command(CLI::App& program);
Command add_study_command(CLI::App& program);
Command add_study_head_command(CLI::App& study);  // a command of the command `study`
Command add_validate_command(CLI::App& program);
Command add_view_command(CLI::App& program);

// The common main function of hairlab's programs. Parses the command line, reads the course (each command has
// --course), marks the program's stubs, and runs the named command; without one, runs `overview`, if there is
// one, before the error. Prints an error as one line, also for results that the standard output does not
// accept. Returns the exit code.
int run_program(CLI::App& app, const std::vector<Command>& commands, int argc, char* argv[],
                const std::function<void(const Course&)>& overview = {});

}  // namespace hair
