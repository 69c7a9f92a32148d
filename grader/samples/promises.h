// STAFF ONLY. The promises of the exercises' headers, and the wrong programs that lose points for ignoring them. A sample quotes the
// words that it ignores ("breaks"), and a group the words that promise nothing about a program ("explains"): a definition, a unit, a
// source, what given code does. So each sentence of a header is either quoted by a wrong program, or explained, or a promise that
// nothing asks.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grader/samples/sample.h"

namespace grader {

// The sentences of a header's comments, in one line each. They end at the full stop before a blank, at an empty comment and at code.
std::vector<std::string> sentences_of(const std::string& header);

struct Promise {
  std::string sentence;
  std::vector<const Sample*> broken_by;
  bool explained = false;
};

struct Promises {
  std::string exercise, header;  // the id; the path in the project
  std::vector<Promise> sentences;
};

// A list for each exercise of the course, in its order; they point into `samples`. Throws BadInput for words that no header of their
// sample's exercises has.
std::vector<Promises> promises_of(const std::filesystem::path& project, const std::vector<Sample>& samples);

// The first case that failed in the first category that a sample must lose, as a grading has it.
struct FailedCase {
  std::string input, student_reads;
};
using FindFailedCase = std::function<FailedCase(const Sample&, const std::string& exercise)>;

// Markdown: each sentence that is not explained, the programs that ignore it, and the categories that they lose; and behind these, if
// there is a grading, how it shows.
std::string table_of(const std::vector<Promises>& promises, const FindFailedCase& find_failed_case = {});

}  // namespace grader
