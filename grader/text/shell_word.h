// STAFF ONLY. Writes a word of a shell's command.
#pragma once

#include <string>

namespace grader::inline text {

// Quotes the word, unless it has only letters, digits and signs that mean nothing to a shell.
std::string shell_word(const std::string& word);

}  // namespace grader::text
