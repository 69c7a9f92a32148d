// study.json: a study as a file, which programs read and --resume goes on from; and its table as CSV.
//
//   program, format, finished
//   scene, shows, content, quick, duration, strand, particles, size, tolerance, most_work    the problem, and how far runs go
//   machine          processor, cores, compiler, build, eigen
//   program_digest   of the program's own bytes: with another, forces and methods may be others
//   reference        method, agreement, least_error, inextensible, from_cache, seconds
//   space_error      null, or levels (segments, error), order, time_error, stretch, seconds; or left_out, why there is none
//   floors           by norm: below it nothing is quoted
//   methods          id, name, order (that theory promises), explicit, end (why there are no finer steps), left_out, runs
//   runs             steps_per_moment, step, ending, trouble, steps, evaluations, iterations, corrections, unconverged,
//                    errors by norm (null: below the floor; a norm that the problem has not is not there; none of a run
//                    that did not finish), seconds (all repeats), time (their median)
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hair/io/plot/page.h"
#include "hair/lab/study/study.h"

namespace hair {

inline constexpr int kStudyFormat = 1;
inline constexpr std::string_view kStudyRecordBegin = "{\n  \"program\": \"hairlab study\"";

std::string study_json(const Study& study);

// The sweeps of a study that was written before, for one that would be the same: `study` has no runs yet.
// Throws BadInput for a file that is none, and for a study of something else, from elsewhere, or by another program: it
// names what differs. Before the reference is known, that and what follows from it are not compared.
void read_runs(const std::filesystem::path& file, Study& study);

Table table_of_runs(const Study& study);  // all of them; for the CSV

const char* name_of(RunEnding ending);
const char* name_of(SweepEnd end);

}  // namespace hair
