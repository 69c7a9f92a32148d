// STAFF ONLY. The exercises that occur in a class's results: the columns of its tables.
#pragma once

#include <string>
#include <vector>

#include "grader/result/result.h"

namespace grader::inline report {

struct Column {
  std::string id, title;
  double max_points = 0;
  bool extra_credit = false;
};

std::vector<Column> columns_of(const std::vector<SubmissionResult>& results);  // in order of first occurrence
const ExerciseResult* find_exercise(const SubmissionResult& result,
                                    const std::string& id);  // null if there is none

// Writes a result in at most five letters: the points, "stub", "crash". "!" after points means that a case
// crashed, ran into a limit or broke the rules; "*" means that a person gave points.
std::string in_short(const ExerciseResult& exercise);

bool is_excused_from_all(const SubmissionResult& result);  // it has no total

std::string in_short(const Decided& decided);                  // "points S1.2", "conflict: points S1.2"
std::string decided_in_short(const SubmissionResult& result);  // "points S1.2, comment"; "": nothing

// Writes "Oral examination is not given yet"; "" if all points by hand are given: else the total is not final.
std::string not_given_yet(const SubmissionResult& result);

std::string in_a_row(const std::vector<std::string>& words);  // "S1, H4"

Isolation least_isolation(const std::vector<SubmissionResult>& results);
bool all_with_images(const std::vector<SubmissionResult>& results);

}  // namespace grader::report
