// STAFF ONLY. `hairgrade samples`: prints the table of the sample class and the attacks.
#include <CLI/CLI.hpp>
#include <iostream>

#include "grader/samples/sample.h"
#include "grader/tool/commands/command.h"

namespace grader::inline tool {

Command add_samples(CLI::App& hairgrade) {
  CLI::App* command = hairgrade.add_subcommand("samples", "Tell of the sample class and the attacks");
  command
      ->add_flag_callback(
          "--table", [] {}, "Print what each sample shows and gets, as Markdown")
      ->required();
  return {command, [] {
            std::cout << table_of(read_samples(HAIR_SOURCE_DIR));
            return 0;
          }};
}

}  // namespace grader::tool
