#include "hair/lab/commands/hand_over.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "hair/io/files/start_program.h"
#include "hair/lab/commands/exit_codes.h"

namespace hair {

namespace fs = std::filesystem;

const OtherCommand* other_command(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(kOtherCommands, [&](const OtherCommand& one) { return one.name == name; });
  return found == kOtherCommands.end() ? nullptr : found;
}

int hand_over(const OtherProgram& program, const std::string& what, char* argv[]) {
  std::error_code error;
  const fs::path hairlab = fs::canonical(this_program(), error);
  const std::string name = hairlab.filename().string();
  const fs::path other = hairlab.parent_path() / (name + "-" + program.name);
  const fs::file_time_type built = fs::last_write_time(other, error);
  if (error || built < fs::last_write_time(hairlab, error)) {
    std::cerr << "hairlab: " << what << " is in a program of its own, which is "
              << (fs::exists(other, error) ? "older than hairlab" : "not built yet")
              << "; build it with: cmake --build '" << HAIR_BUILD_DIR << "' --target " << name << "_"
              << program.target << " --parallel 4\n";
    return kBadInput;
  }
  execv(other.c_str(), argv);
  error = {errno, std::generic_category()};
  std::cerr << "hairlab: " << other.string() << " does not run (" << error.message() << ")\n";
  return kBroke;
}

}  // namespace hair
