// STAFF ONLY. `hairgrade compare`: compares two pictures, or two folders of frames.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/tool/commands/command.h"
#include "grader/tool/comparing.h"

namespace grader::inline tool {

Command add_compare(CLI::App& hairgrade) {
  const auto settings = std::make_shared<CompareSettings>();
  CLI::App* command =
      hairgrade.add_subcommand("compare", "Compare two pictures, or two folders of frames, worst first");
  command->add_option("A", settings->reference, "A PNG picture, or a folder of them")->required();
  command->add_option("B", settings->test, "What is compared with it: a picture, or a folder")->required();
  command->add_option("--out", settings->out,
                      "A folder for heat maps, pictures side by side and a page of the worst");
  command->add_flag("--json", settings->json, "Print JSON in place of a table");
  return {command, [settings] {
            const int code = compare_pictures(*settings, std::cout, note_interruptions());
            if (code == 130) std::cerr << "hairgrade: interrupted; nothing was written\n";
            return code;
          }};
}

}  // namespace grader::tool
