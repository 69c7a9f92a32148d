// Strand models side by side: the error of each against the fine motion, and its run time, for several numbers of elements
// and several steps.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hair/lab/models/compared_hair.h"
#include "hair/lab/models/family.h"
#include "hair/lab/models/fine_motion.h"
#include "hair/lab/models/helix_cost.h"

namespace hair::model_study {

struct ModelRun {
  int elements = 0;
  double step = 0;      // s
  std::string trouble;  // why it did not get to its end; empty: it did
  double error = 0;     // m, root mean square over points and moments
  double seconds = 0;   // CPU time for a second of motion
  // At the end of each step, of a run at 1/60 s: the length of the whole line over that at rest. Else empty.
  std::vector<double> lengths;
};

struct FamilyRuns {
  Family family;
  std::vector<ModelRun> runs;
  std::string left_out;  // why there are none
};

struct HairComparison {
  ComparedHair hair;
  double uncertainty = 0;  // m, of the fine motion
  double fine_seconds = 0;
  std::vector<FamilyRuns> families;
  std::vector<FamilyRuns> stiff;  // of straight hair: stiff_families() at a sixtieth of a second
};

struct Comparison {
  std::vector<HairComparison> hairs;
  std::vector<HelixCost> helix_costs;  // none if the course has no H8, or it is not written
};

// Of these hairs (compared_hairs). Empty if `interrupted`. `say` is told what is being done. Throws NotImplemented if H7, which makes the fine motion, is not
// written; families whose exercise is not written, or `absent`, are left out.
std::optional<Comparison> compare_models(const std::vector<ComparedHair>& hairs, bool quick,
                                         const std::vector<std::string>& absent,
                                         const std::atomic<bool>& interrupted,
                                         const std::function<void(const std::string&)>& say);

}  // namespace hair::model_study
