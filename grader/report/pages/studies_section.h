// STAFF ONLY. Ratios of run times for the same error (PartStudy::ratio), in words and on a track.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/result/study.h"
#include "hair/io/plot/html.h"

namespace grader::inline report {

using hair::Html, hair::html;

struct Dot {
  double ratio = 1;
  std::string title;
};

// This is the study of a submission, with its name for people.
struct Studied {
  std::string name;
  SubmissionStudy study;
};

bool is_noise(const PartStudy& part);         // the ratio says nothing
std::string in_words(const PartStudy& part);  // "1.31, beyond the noise, 0.93 to 1.07"

Html track(const std::vector<Dot>& dots, const std::optional<TimeRatio>& noise);

// Shows methods with their tracks. `heads` are those of the columns behind the tracks.
Html table_of_tracks(const Html& heads, const Html& rows);

// Shows a class: a row a method, a dot a submission. Empty without studies.
Html studies_section(const std::vector<Studied>& studies);

}  // namespace grader::report
