// What a fuzz program is made of. libFuzzer makes inputs of those that it has, and keeps the ones that reach
// new code. Source: https://llvm.org/docs/LibFuzzer.html
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

// Defined by each program. Returns if the reader keeps its promises for these bytes. Whatever it throws is a
// finding, so it catches what the reader's header says that the reader throws, and nothing else.
void try_input(std::string_view bytes);

// Defined by each program: valid inputs of every kind, each small.
std::vector<std::string> seeds();

// Defined by each program: how many bytes of memory try_input may have at once for so many bytes of input.
std::size_t most_memory(std::size_t input);

// For try_input: a promise that is not kept ends the program, which is a finding.
void expect(bool kept, std::string_view promise);

// The same for a message to people: one line, without control characters.
void expect_readable(std::string_view message);

}  // namespace fuzz
