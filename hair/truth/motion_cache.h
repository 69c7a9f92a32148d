// Accurate motions that were computed before: a folder with a file for each. A file says what it is the motion of, in
// full, and ends with a digest of itself: what is of something else, cut short or changed is as good as not there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hair/truth/accurate_motion.h"
#include "hair/truth/ode.h"

namespace hair {

// All that a motion depends on, in one line: the problem, how it is solved, with what, and what the forces are:
// digests of f at the start and near it, since the code of an exercise may be another today.
std::string motion_key(const Problem& problem, Ode& ode, const std::string& method);

// As it was kept, bit by bit, with from_cache set; nothing if there is none, or none to trust.
std::optional<AccurateMotion> find_motion(const std::filesystem::path& folder, const std::string& key);

// Throws BadInput where the folder can't be written.
void keep_motion(const std::filesystem::path& folder, const std::string& key, const AccurateMotion& motion);

}  // namespace hair
