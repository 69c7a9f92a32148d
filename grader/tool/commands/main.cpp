// STAFF ONLY. hairgrade, the staff's program. Its commands are in grader/tool/commands.
//
// Exit code 0: all submissions have results (or the handout is written). 1: the grader itself failed, or a
// gate of the handout closed. 2: bad input or usage. 3: a person must look: intake left something over (a
// line each, all else is graded), the clock on the wall ended a submission, or a picture is missing or could
// not be compared. 130: interrupted; finished results are kept, and --resume goes on.
#include <locale.h>
#include <signal.h>
#include <sodium.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <vector>

#include "grader/course/input.h"
#include "grader/sandbox/inherited.h"
#include "grader/tool/commands/command.h"
#include "hair/io/files/finish_output.h"

namespace grader::inline tool {
namespace {

std::atomic<bool> signal_came = false;  // a signal handler may change nothing else

}  // namespace

const std::atomic<bool>& note_interruptions() {
  struct sigaction action = {};
  action.sa_handler = [](int) { signal_came = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);  // nohup ignores it
  return signal_came;
}

}  // namespace grader::tool

namespace {

using namespace grader;

// Joins names: "grade, compare and handout".
std::string names_of(const std::vector<Command>& commands) {
  std::string names;
  for (std::size_t i = 0; i < commands.size(); ++i)
    names += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " and ") + commands[i].options->get_name();
  return names;
}

int run(int argc, char* argv[]) {
  setlocale(LC_CTYPE, "C.UTF-8");  // names in archives may hold any letters
  signal(SIGPIPE, SIG_IGN);        // a reader of our pipes may end early, as in its sandbox
  if (sodium_init() < 0) {
    std::cerr << "hairgrade: no source of random numbers\n";
    return 1;
  }
  CLI::App app("hairgrade: grades submissions of the hair assignment, and makes its handout");
  app.require_subcommand(1);
  std::vector<Command> commands;
  for (const AddCommand add : kCommands) commands.push_back(add(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    const bool without_command = argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty();
    std::cerr << "hairgrade: "
              << (without_command ? std::string(argv[1]) + " is no command; there are " + names_of(commands)
                                  : error.what())
              << "; see hairgrade --help\n";
    return 2;
  }
  try {
    if (std::error_code gone; std::filesystem::current_path(gone).empty())
      throw BadInput("the folder that it was started in is gone; start it in another one");
    for (const Command& command : commands)
      if (command.options->parsed()) return command.run();
    return 2;  // is not reached: a command is required
  } catch (const BadInput& error) {
    std::cerr << "hairgrade: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "hairgrade: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  hair::begin_output();
  // Other commands start no student code, and keep the limits of their starter. With --slurm, Slurm's
  // programs need its environment.
  if (const std::string_view command = argc > 1 ? argv[1] : "";
      command == "gradescope" || command == "prairielearn" ||
      (command == "grade" && std::count(argv, argv + argc, std::string_view("--slurm")) == 0))
    set_what_is_inherited(argv);
  return hair::finish_output("hairgrade", run(argc, argv));
}
