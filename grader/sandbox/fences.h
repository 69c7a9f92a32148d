// STAFF ONLY. Tries the layers of a sandbox from inside, before student code runs in it.
#pragma once

#include <filesystem>
#include <string>

#include "grader/sandbox/sandboxed_process.h"

namespace grader::inline sandbox {

// Returns an empty text if each layer holds; otherwise a phrase for the first one that does not: "student
// code can reach the network". `probe` is the program hairprobe, and `sandbox` holds it as /probe, with its
// libraries. Throws std::system_error if no sandbox can be made.
// Tests call it with a layer left out.
std::string open_fence(const Sandbox& sandbox, const SandboxedProcess::LeaveOut& leave_out = {});

}  // namespace grader::sandbox
