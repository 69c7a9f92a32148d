// STAFF ONLY. Mutants: wrong programs that one small change makes of a right one (DeMillo, Lipton, Sayward
// 1978). A suite that gives one of them all points does not test the changed part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace grader::inline mutants {

struct Mutation {
  std::size_t at, length;  // are the removed bytes of the source
  std::string instead;     // replaces them
  // "operator", "comparison", "constant", "index", "argument", "name", "sign", "condition", "function",
  // "statement"
  std::string kind;
};

// Returns all changes of a C++ source in clang-format's layout, in its order. It looks at words and signs
// alone, so some do not compile, and some change nothing.
std::vector<Mutation> mutations_of(const std::string& source);

// Returns all of them in the order of trials: one of each kind in turn, drawn by the seed.
std::vector<Mutation> drawn(std::vector<Mutation> all, std::uint64_t seed);

std::string mutated(const std::string& source, const Mutation& mutation);

// Return the line where it begins, without white space at its ends; and the change, "`<` to `<=`".
std::string line_of(const std::string& source, const Mutation& mutation);
std::string change_of(const std::string& source, const Mutation& mutation);
// Counts from 1 which of the line's equal words, or places of an addition, is changed.
int occurrence_of(const std::string& source, const Mutation& mutation);
int line_number(const std::string& source, const Mutation& mutation);  // from 1

}  // namespace grader::mutants
