// head.json: the study of a head for programs to read, and its runs as a table.
//
//   program, format, quick, threads, machine
//   frames_per_second, steps_per_frame, moving     of the motion: `moving` frames are measured
//   cases      hair, head (whether it collides), simulated_by ("engine" or "exercises"), strands, points (of a strand), length (m),
//              seconds (CPU time of every strand simulated), runs
//   runs       guides, simulation (CPU s of the guides), modes: for each way of synthesis (interpolate, extrapolate, blend) synthesis
//              (CPU s), and the errors start, end, all, motion (head_errors.h), each with rms and most, m
//   pictures   hair, file, guides; no_pictures: why there are none, or null
#pragma once

#include <string>
#include <string_view>

#include "hair/io/plot/page.h"
#include "hair/lab/head/head_study.h"

namespace hair::head_study {

inline constexpr std::string_view kHeadRecordBegin = "{\n  \"program\": \"hairlab study head\"";

std::string head_json(const HeadStudy& study, const std::string& machine);

Table table_of_runs(const HeadStudy& study);  // for head.csv: a row for each way of synthesis

}  // namespace hair::head_study
