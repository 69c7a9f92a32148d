// The program that runs.
#pragma once

#include <filesystem>

namespace hair {

// Its file: what is read there are the bytes that run, even where a newer file has taken its name meanwhile.
std::filesystem::path this_program();

}  // namespace hair
