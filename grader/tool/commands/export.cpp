// STAFF ONLY. `hairgrade export`: prints a record as JSON, for other programs.
#include <iostream>

#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {

Command add_export(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  CLI::App* command =
      hairgrade.add_subcommand("export", "Print the record of a class as JSON, without pictures");
  add_folder(*command, *options);
  return {command, [options] {
            std::cout << open_record(options->folder, options->hand_in)->export_json();
            return 0;
          }};
}

}  // namespace grader::tool
