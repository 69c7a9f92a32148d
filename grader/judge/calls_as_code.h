// STAFF ONLY. Writes recorded requests (student/recording.h) as C++ calls of a contract's functions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "grader/judge/declared.h"
#include "grader/judge/student/recording.h"

namespace grader::inline judge {

struct CallsAsCode {
  std::string inputs, statements,
      given;                 // structs Call1, ...; statements of main; definitions of given functions
  std::string answers;       // are those of the case's objects, as replay.h reads them
  std::vector<double> seen;  // are the numbers that the calls returned, in the order of `statements`
};

// `functions` are those of the exercise and its prerequisites, by id. Throws NotWritable.
CallsAsCode as_code(const std::vector<Recording::Request>& requests, const std::string& exercise,
                    const std::map<std::string, std::vector<Declared>>& functions);

}  // namespace grader::judge
