// STAFF ONLY. The control groups (v1 or v2) that this process is in, and what they leave of the machine. A
// container's programs count all processors and all memory of the host if they ask the machine.
#pragma once

#include <filesystem>
#include <vector>

namespace grader::inline sandbox {

// Folders of the groups with this controller ("": those of v2): our own, then those above it, up to the one
// that is mounted. Empty if there are none. `root` holds /proc and the mounted folders.
std::vector<std::filesystem::path> own_groups(const std::string& controller,
                                              const std::filesystem::path& root = "/");

double usable_processors(const std::filesystem::path& root = "/");         // a part of one counts, too
std::size_t usable_memory_bytes(const std::filesystem::path& root = "/");  // the machine's, or less

// Submissions that are graded at a time: as many as processors, as long as each has memory for a compiler.
int usable_jobs(const std::filesystem::path& root = "/");

// How many processes of our own group the kernel has ended because memory ran out.
long ended_for_memory();
long ended_for_memory(const std::filesystem::path& group);

}  // namespace grader::sandbox
