// The study of a head: head.json, its rows, and the page: error against run time for each hair, and pictures.
// In head.json:
//
//   program, quick, machine, format
//   frames_per_second, steps_per_frame, moving     of the motion: `moving` frames are measured
//   cases      hair, head (true if it collides), simulated_by ("exercises"), strands, points (in a strand),
//              length (m), seconds (CPU time of every strand simulated), runs
//   runs       guides, simulation (CPU s of the guides), modes: for each way of synthesis (interpolate,
//              extrapolate, blend) synthesis (CPU s), and the errors start, end, all, motion (head_errors.h),
//              each with rms and most, m
//   pictures   hair, file, guides; no_pictures: why there are none, or null
#pragma once

#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/lab/head/head_study.h"

namespace hair::head_study {

// The time that a way of synthesis takes, and its errors.
Row row_of_mode(const ModeRun& run);

OrderedJson head_json(const HeadStudy& study);
Page head_page(const HeadStudy& study);

// head.csv: a row for each way of synthesis, and one for every strand.
std::vector<Row> head_rows(const HeadStudy& study);

}  // namespace hair::head_study
