// STAFF ONLY. The command that starts another one in bubblewrap's namespaces.
#pragma once

#include <string>
#include <vector>

#include "grader/sandbox/cage.h"

namespace grader::inline sandbox {

// `filtered` says that a filter of system calls is on descriptor Launch::kFilter.
std::vector<std::string> bubblewrap_command(const Cage& cage, const std::vector<std::string>& command,
                                            bool filtered);

}  // namespace grader::sandbox
