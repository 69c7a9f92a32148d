// STAFF ONLY. Which isolation this machine can give to student code.
#pragma once

#include <optional>

#include "grader/compile/kit.h"
#include "grader/course/isolation.h"

namespace grader::inline tool {

// The kind that is asked for, or else the first of namespaces and container whose fences hold here: each is
// tried. Throws BadInput with the fence that is open, and a remedy.
Isolation isolation_here(const StagedKit& kit, std::optional<Isolation> asked);

}  // namespace grader::tool
