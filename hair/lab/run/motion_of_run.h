// motion.json of a run (hair/view/motion.h): what its page shows.
#pragma once

#include <string>

#include "hair/lab/run/run_record.h"
#include "hair/view/motion.h"

namespace hair {

inline constexpr const char* kMotionFile = "motion.json";

// "strand 3, step 17: filter" is of strand 3; -1: of none.
int strand_of(const std::string& blow_up);

// measured: with energies and so on, which are of all strands.
std::string motion_json(const Scene& scene, const RunRecord& record, const Camera& camera,
                        const MotionFrames& frames, bool measured = true);

}  // namespace hair
