// STAFF ONLY. The command that starts another one in bubblewrap's namespaces.
#pragma once

#include <string>
#include <vector>

#include "grader/sandbox/sandbox.h"

namespace grader::inline sandbox {

// `filtered` says that a filter of system calls is on descriptor Launch::kFilter.
std::vector<std::string> bubblewrap_command(const Sandbox& sandbox, const std::vector<std::string>& command,
                                            bool filtered);

}  // namespace grader::sandbox
