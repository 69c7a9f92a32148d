// STAFF ONLY. `hairgrade secret`: moves the staff's secret to another machine.
#include "grader/grading/secret.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/tool/commands/command.h"

namespace grader::inline tool {

Command add_secret(CLI::App& hairgrade) {
  const auto file = std::make_shared<std::filesystem::path>();
  CLI::App* command = hairgrade.add_subcommand(
      "secret", "Move the staff's secret, from which every student's inputs are drawn, to another machine");
  command->require_subcommand(1);
  CLI::App* exporting = command->add_subcommand("export", "Write it to a new file");
  CLI::App* importing = command->add_subcommand("import", "Take it from a file");
  exporting->add_option("FILE", *file, "The new file, which its owner alone can read")->required();
  importing->add_option("FILE", *file, "A file that secret export has written")->required();
  return {command, [file, exporting] {
            const std::string told = *exporting ? export_secret(*file) : import_secret(*file);
            std::cout << "the secret has the fingerprint " << told << "\n";
            return 0;
          }};
}

}  // namespace grader::tool
