// STAFF ONLY. Finds the isolation that this machine can give to student code.
#pragma once

#include <optional>

#include "grader/compile/toolchain.h"
#include "grader/course/isolation.h"

namespace grader::inline grading {

// Returns the requested kind, or else the first of namespaces and container whose layers hold here: each
// layer is tried. Throws BadInput with the open layer, and a remedy.
Isolation isolation_here(const StagedKit& kit, std::optional<Isolation> asked);

}  // namespace grader::grading
