// The common parts of fuzz programs. libFuzzer makes new inputs from the known ones, and keeps the inputs
// that reach new code. Source: https://llvm.org/docs/LibFuzzer.html
//
// A program defines try_input, seeds and most_memory; fuzz.cpp does the rest. It takes libFuzzer's options,
// and
//
//   NAME_fuzz --seeds FOLDER      writes the seeds into a folder, one file each
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

// Defined by each program. Returns if the reader keeps its promises for these bytes. Any exception that it
// throws is a finding, so it catches only the exceptions that the reader's header names.
void try_input(std::string_view bytes);

// Defined by each program: valid inputs of every kind, each small.
std::vector<std::string> seeds();

// Defined by each program: the most bytes of memory that try_input may hold for so many bytes of input.
std::size_t most_memory(std::size_t input);

// For try_input: a broken promise ends the program, which is a finding.
void expect(bool kept, std::string_view promise);

// The same for a message to people: one line, without control characters.
void expect_readable(std::string_view message);

}  // namespace fuzz
