// motion.json of a run (hair/view/motion.h): the content of its page.
#pragma once

#include <string>

#include "hair/lab/run/run_record.h"
#include "hair/view/motion.h"

namespace hair {

inline constexpr const char* kMotionFile = "motion.json";

// 3 for "strand 3, step 17: filter"; -1 if the text names no strand.
int strand_of(const std::string& blow_up);

// measured: with energies and other values, which belong to all strands.
std::string motion_json(const Scene& scene, const RunRecord& record, const Camera& camera,
                        const MotionFrames& frames, bool measured = true);

}  // namespace hair
