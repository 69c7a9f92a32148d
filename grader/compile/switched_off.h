// STAFF ONLY. Finds sources that switch the search for memory errors off in a part of themselves: by an
// attribute (GCC's and clang's spellings: no_sanitize, no_sanitize_address, ...), or by assembler, which
// sanitizers don't check and which can redefine the instructions that call them. A section's name is also
// written to the assembler unchanged, with all its lines. Macros can make both of pieces, so the preprocessed
// source decides. It costs compile time, and is made only for a source with a word that both need.
//
// Code that searches for the sanitizer's shadow memory and changes it is not found.
#pragma once

#include <optional>
#include <string>

namespace grader::inline compile {

struct SwitchedOff {
  int line = 0;      // is in the student's file; 0: in a header's macro
  std::string word;  // "no_sanitize"
};

bool may_switch_off(const std::string& source);

// `preprocessed` is the source after the preprocessor, with line markers. `file` is its name in them.
std::optional<SwitchedOff> find_switch(const std::string& source, const std::string& preprocessed,
                                       const std::string& file);

}  // namespace grader::compile
