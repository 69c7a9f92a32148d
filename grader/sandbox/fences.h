// STAFF ONLY. Tries the fences of a sandbox, from inside, before anybody's code is in it.
#pragma once

#include <filesystem>
#include <string>

#include "grader/sandbox/cage.h"

namespace grader::inline sandbox {

// Empty if each fence holds; otherwise a phrase for the first one that does not: "student code can reach the
// network". `probe` is the program hairprobe, and `cage` holds it as /probe, with the libraries that it
// needs. Throws std::system_error if no sandbox can be made.
std::string open_fence(const Cage& cage);
// For tests: with a fence left out.
std::string open_fence(const Cage& cage, const CagedProcess::LeaveOut& leave_out);

}  // namespace grader::sandbox
