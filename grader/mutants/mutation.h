// STAFF ONLY. Mutants: wrong programs that are made of a right one by one small change (DeMillo, Lipton,
// Sayward 1978). A suite that gives one of them all points does not ask for what the change broke.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace grader::inline mutants {

struct Mutation {
  std::size_t at, length;  // the bytes of the source that go
  std::string instead;     // what stands in their place
  // "operator", "comparison", "constant", "index", "argument", "name", "sign", "condition", "function",
  // "statement"
  std::string kind;
};

// All changes of a C++ source as clang-format writes it, in its order. It looks at words and signs alone, so
// some do not compile, and some change nothing.
std::vector<Mutation> mutations_of(const std::string& source);

// All of them in the order in which they are tried: one of each kind in turn, drawn by the seed.
std::vector<Mutation> drawn(std::vector<Mutation> all, std::uint64_t seed);

std::string mutated(const std::string& source, const Mutation& mutation);

// The line where it begins, without the white space at its ends; and what is changed, "`<` to `<=`".
std::string line_of(const std::string& source, const Mutation& mutation);
std::string change_of(const std::string& source, const Mutation& mutation);
// Which of the line's words like this one, or places for what is added, is changed: from 1.
int occurrence_of(const std::string& source, const Mutation& mutation);
int line_number(const std::string& source, const Mutation& mutation);  // from 1

}  // namespace grader::mutants
