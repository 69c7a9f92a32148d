// STAFF ONLY. A source that switches the look for memory errors off in a part of itself: by an attribute
// (GCC's and clang's spellings: no_sanitize, no_sanitize_address, ...), or by assembler, which no sanitizer
// looks into and which can redefine the instructions that call it. A section's name, too, is written to the
// assembler as it is, with all the lines that it holds. Macros can make both of pieces, so the preprocessed
// source decides. It costs the compiler some time, and is made only for a source with a word that neither can
// do without.
//
// Code that searches for the sanitizer's shadow memory and changes it is not found.
#pragma once

#include <optional>
#include <string>

namespace grader::inline compile {

struct SwitchedOff {
  int line = 0;      // of the student's file; 0: a macro's in a header
  std::string word;  // "no_sanitize"
};

bool may_switch_off(const std::string& source);

// `preprocessed`: the source's, with line markers. `file`: its name in them.
std::optional<SwitchedOff> find_switch(const std::string& source, const std::string& preprocessed,
                                       const std::string& file);

}  // namespace grader::compile
