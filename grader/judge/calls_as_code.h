// STAFF ONLY. Writes recorded requests (student/recording.h) as C++ calls of a contract's functions.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/judge/student/recording.h"

namespace grader::inline judge {

// Reads how a contract's header declares the functions of an exercise.
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

struct CallsAsCode {
  std::string inputs, statements;  // structs Call1, ...; statements of main
  std::string given;               // definitions of given functions
  std::string answers;             // are those of the case's objects, as replay.h reads them
  std::vector<double> seen;        // are the numbers that the calls returned, in the order of `statements`
};

// `functions` are those of the exercise and its prerequisites, by id. Throws NotWritable.
CallsAsCode as_code(const std::vector<Recording::Request>& requests, const std::string& exercise,
                    const std::map<std::string, std::vector<Declared>>& functions);

}  // namespace grader::judge
