// The running program.
#pragma once

#include <filesystem>

namespace hair {

// The program's file. Reading it gives the bytes that are running, even if a newer file has replaced its
// name.
std::filesystem::path this_program();

}  // namespace hair
