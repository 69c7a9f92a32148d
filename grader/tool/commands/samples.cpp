// STAFF ONLY. `hairgrade samples`: tells of the sample class and the attacks.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/samples/promises.h"
#include "grader/samples/table.h"
#include "grader/tool/commands/command.h"

namespace grader {

Command add_samples(CLI::App& hairgrade) {
  CLI::App* command = hairgrade.add_subcommand("samples", "Tell of the sample class and the attacks");
  const auto promises = std::make_shared<bool>(false);
  CLI::Option_group* tables = command->add_option_group("tables");
  tables->add_flag_callback(
      "--table", [] {}, "Print what each sample shows and gets, as Markdown");
  tables->add_flag(
      "--promises", *promises,
      "Print what the exercises' headers promise, and the samples that lose points for ignoring it");
  tables->require_option(1);
  return {command, [promises] {
            const std::vector<Sample> samples = read_samples(HAIR_SOURCE_DIR);
            std::cout << (*promises ? table_of(promises_of(HAIR_SOURCE_DIR, samples)) : table_of(samples));
            return 0;
          }};
}

}  // namespace grader
