// STAFF ONLY. Reads the control groups (v1 or v2) of this process and their share of the machine. A
// container's programs count all processors and all memory of the host if they ask the machine.
#pragma once

#include <filesystem>
#include <vector>

namespace grader::inline sandbox {

// Lists folders of the groups with this controller ("": those of v2): our own, then those above it, up to the
// mounted one. Empty if there are no groups. `root` holds /proc and the mounted folders.
std::vector<std::filesystem::path> own_groups(const std::string& controller,
                                              const std::filesystem::path& root = "/");

double usable_processors(const std::filesystem::path& root = "/");         // counts parts of a processor, too
std::size_t usable_memory_bytes(const std::filesystem::path& root = "/");  // is the machine's memory, or less

// Counts the submissions to grade at a time: one a processor, if each has memory for a compiler.
int usable_jobs(const std::filesystem::path& root = "/");

// Counts the processes of our own group that the kernel has ended because memory ran out.
long ended_for_memory();
long ended_for_memory(const std::filesystem::path& group);

}  // namespace grader::sandbox
