// STAFF ONLY. What sandboxes need of the system, as mounts. In namespaces whole folders are mounted; where
// each file has to be copied or linked, the files alone that are used.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/sandbox/cage.h"

namespace grader::inline sandbox {

// This program's own C++ library and libseccomp: all that a worker needs.
std::vector<Mount> runtime_library_mounts();

// The libraries that programs are linked with, or all.
std::vector<Mount> library_mounts(Isolation kind, const std::vector<std::filesystem::path>& programs);

// The compiler and linker, without any headers.
std::vector<Mount> toolchain_mounts(Isolation kind = Isolation::namespaces);

// The headers of the C and C++ libraries, and those in `folders` of /usr/include; no other installed headers.
std::vector<Mount> header_mounts(Isolation kind, const std::filesystem::path& empty_folder,
                                 const std::vector<std::string>& folders = {});

// Programs, by their paths, with their libraries. All of their places, as links lead from one to the next.
std::vector<Mount> program_mounts(const std::vector<std::filesystem::path>& programs);

// /usr/bin/g++, or the compiler that there is, without links. Throws BadInput.
std::filesystem::path system_compiler();

}  // namespace grader::sandbox
