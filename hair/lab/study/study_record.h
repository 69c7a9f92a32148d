// study.json: a study as a file that programs read; also its table as CSV.
//
//   program, format, finished
//   scene, shows, content, quick, duration, strand, particles, size, tolerance, most_work
//                    the problem, and the limit of a run
//   machine          processor, cores, compiler, build, eigen
//   reference        method, agreement, least_error, inextensible, from_cache, seconds
//   space_error      null, or levels (segments, error), order, time_error, stretch, seconds; or left_out, the
//                    reason why there is none
//   floors           by norm: smaller errors are not reported
//   methods          id, name, order (by theory), explicit, end (why there are no finer steps), left_out,
//                    runs
//   runs             steps_per_moment, step, ending, trouble, steps, evaluations, iterations, corrections,
//                    unconverged, errors by norm (null: below the floor; norms that the problem does not
//                    have are missing; no errors if the run did not finish), seconds (all repeats), time
//                    (their median)
#pragma once

#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/io/plot/figure.h"
#include "hair/lab/study/study.h"

namespace hair {

inline constexpr int kStudyFormat = 1;

OrderedJson study_json(const Study& study);

// The page: the cheapest method for each error, the observed orders, and the failures.
Page study_page(const Study& study);

enum class Against { time, step, work };

// An error, for all methods, against the cost or against the step. A run that did not finish is drawn at the
// upper edge, at the cost of a whole run. An error below the reference's accuracy is drawn on the line that
// marks that accuracy.
Figure error_figure(const Study& study, Norm norm, Against against);

std::vector<Row> run_rows(const Study& study);  // all runs: study.csv
Row row_of_level(const SpaceLevel& level);

bool has(const Study& study, Norm norm);  // true if the problem has such errors

const char* name_of(RunEnding ending);
const char* name_of(SweepEnd end);

}  // namespace hair
