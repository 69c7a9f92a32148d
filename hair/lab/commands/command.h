// hairlab's subcommands: each adds its options to the program's, and says what to do once they are read.
//
// What a command returns is the program's exit code. 0: done. 1: something broke on the way, or did not hold (what
// came before is kept), or the code of an exercise threw. 2: bad input or usage. 3: an exercise that is needed is
// not written yet. 130: interrupted; what was finished is kept. A command may throw BadInput (2), NotImplemented (3),
// or anything else (1).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace hair {

inline constexpr int kBroke = 1, kBadInput = 2, kNotWritten = 3, kInterrupted = 130;

struct Command {
  CLI::App* app;
  std::function<int()> run;
};

Command add_run_command(CLI::App& program);
Command add_scenes_command(CLI::App& program);
Command add_solver_command(CLI::App& program);
Command add_stability_command(CLI::App& program);
Command add_study_command(CLI::App& program);
Command add_validate_command(CLI::App& program);

}  // namespace hair
