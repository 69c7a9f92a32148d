// motion.json of a run (hair/view/motion.h): what its page shows.
#pragma once

#include <string>

#include "hair/lab/run/run_record.h"
#include "hair/view/motion.h"

namespace hair {

inline constexpr const char* kMotionFile = "motion.json";

std::string motion_json(const Scene& scene, const RunRecord& record, const Camera& camera,
                        const MotionFrames& frames);

}  // namespace hair
