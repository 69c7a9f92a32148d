// STAFF ONLY. Lists what sandboxes need of the system, as mounts. In namespaces whole folders are mounted; in
// a container, which copies or links each file, only the necessary files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/sandbox/sandbox.h"

namespace grader::inline sandbox {

// Holds this program's own C++ library and libseccomp: a worker needs no others.
std::vector<Mount> runtime_library_mounts();

// Holds the libraries of these programs, or all.
std::vector<Mount> library_mounts(Isolation kind, const std::vector<std::filesystem::path>& programs);

// Holds the compiler and linker, without any headers.
std::vector<Mount> toolchain_mounts(Isolation kind = Isolation::namespaces);

// Holds the headers of the C and C++ libraries, and `folders` of /usr/include; no other installed headers.
std::vector<Mount> header_mounts(Isolation kind, const std::filesystem::path& empty_folder,
                                 const std::vector<std::string>& folders = {});

// Holds programs, by their paths, with their libraries, and all links on the way.
std::vector<Mount> program_mounts(const std::vector<std::filesystem::path>& programs);

// Returns /usr/bin/g++, or else another compiler, without links. Throws BadInput.
std::filesystem::path system_compiler();

}  // namespace grader::sandbox
