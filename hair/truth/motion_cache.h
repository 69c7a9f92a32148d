// A cache of accurate motions: files that are kept (hair/io/files/kept_file.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hair/truth/accurate_motion.h"
#include "hair/truth/ode.h"

namespace hair {

// Everything that a motion depends on, in one line: the problem, the solution method, the versions, and the
// forces, as digests of f at the start and near it, because the code of an exercise may have changed.
std::string motion_key(const Problem& problem, Ode& ode, const std::string& method);

// The stored motion, bit by bit, with from_cache set; nothing if there is none, or if the file is not valid.
std::optional<AccurateMotion> find_motion(const std::filesystem::path& folder, const std::string& key);

// Throws BadInput if the folder can't be written.
void keep_motion(const std::filesystem::path& folder, const std::string& key, const AccurateMotion& motion);

}  // namespace hair
