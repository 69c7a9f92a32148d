// STAFF ONLY. Reads how a contract's header declares the functions of an exercise.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader::inline judge {

struct Declared {
  struct Parameter {
    std::string name;         // "x" for "double x[]",
    bool is_pointer = false;  // which is one
  };
  std::string name, text;  // "hair::bend_energy", "double bend_energy(const Strand& strand, Input x)"
  std::vector<Parameter> parameters;
};

// Means that a case can't be written; a sentence for staff.
class NotWritable : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// They are in the exercise's order; `headers` is the folder that students have.
std::vector<Declared> declared(const Exercise& exercise, const std::filesystem::path& headers);

}  // namespace grader::judge
