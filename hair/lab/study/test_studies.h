// STAFF ONLY. Soft problems, whose studies take almost no time.
#pragma once

#include <string>
#include <vector>

#include "hair/lab/study/sweep.h"
#include "solver/test_refusal.h"

namespace reference_tests {

using tests::says;

// 12 cm in 6 segments, ten thousand times as easy to stretch as hair; starts horizontal and swings.
inline const char* const kSoftHair =
    R"({"shows": "soft hair", "frames": 3, "hair": [{"segments": 6, "length": 0.12,
  "clamped": false, "material": {"stretch_factor": 1e-4},
  "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

// Real hair, 4 cm in 4 segments.
inline const char* const kHair = R"({"shows": "hair", "frames": 3, "hair": [{"segments": 4, "length": 0.04,
  "clamped": false, "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

// A double pendulum made of springs.
inline const char* const kPendulum = R"({"shows": "a pendulum", "frames": 3, "toys": [{
  "particles": [{"position": [0, 0, 0], "mass": 1, "pinned": true}, {"position": [0.4, 0, -0.3], "mass": 0.3},
                {"position": [0.4, 0, -0.8], "mass": 0.2}],
  "springs": [{"between": [0, 1], "stiffness": 400}, {"between": [1, 2], "stiffness": 300}]}]})";

struct Studied {
  hair::Problem problem;
  hair::Study study;
};

// The first `duration` seconds of a scene with these methods; each run is made once.
Studied studied(const char* scene, double duration, const std::vector<std::string>& methods,
                double most_work);

const hair::Sweep& sweep_of(const hair::Study& study, const std::string& id);

// A description of its runs, for failure messages.
std::string shown(const hair::Sweep& sweep);

}  // namespace reference_tests
