#include "hair/lab/commands/studies.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <system_error>

#include "hair/io/files/this_program.h"
#include "hair/lab/commands/exit_codes.h"

namespace hair {

namespace fs = std::filesystem;

bool is_study(std::string_view command) {
  return std::any_of(kStudyCommands.begin(), kStudyCommands.end(),
                     [&](const StudyCommand& one) { return one.name == command; });
}

int hand_over_to_studies(char* argv[]) {
  std::error_code error;
  const fs::path hairlab = fs::canonical(this_program(), error);
  const std::string name = hairlab.filename().string();
  const fs::path studies = hairlab.parent_path() / (name + "-study");
  const fs::file_time_type built = fs::last_write_time(studies, error);
  if (error || built < fs::last_write_time(hairlab, error)) {
    std::cerr << "hairlab: " << argv[1] << " is in a program of its own, which is "
              << (fs::exists(studies, error) ? "older than hairlab" : "not built yet")
              << "; build it with: cmake --build '" << HAIR_BUILD_DIR << "' --target " << name
              << "_studies --parallel 4\n";
    return kBadInput;
  }
  execv(studies.c_str(), argv);
  error = {errno, std::generic_category()};
  std::cerr << "hairlab: " << studies.string() << " does not run (" << error.message() << ")\n";
  return kBroke;
}

}  // namespace hair
