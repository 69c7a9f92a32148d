#include "hair/lab/models/helix_cost.h"

#include "hair/super_helix/helix_forces.h"
#include "hair/super_helix/helix_start.h"
#include "solver/timing.h"

namespace hair::model_study {

namespace {

constexpr double kMeasured = 0.01;  // s of CPU time for a measurement, of which there are five
constexpr double kCostStep = 1.0 / 240;

// s of CPU time of a call: the median of five measurements of many calls.
template <typename Call>
double time_of(Call call) {
  std::vector<double> seconds;
  for (int k = 0; k < 5; ++k) {
    const double start = timing::cpu_seconds();
    double passed = 0;
    long calls = 0;
    for (; passed < kMeasured; passed = timing::cpu_seconds() - start, ++calls) call();
    seconds.push_back(passed / static_cast<double>(calls));
  }
  return timing::median(seconds);
}

HelixCost cost_of(int elements) {
  StrandSpec spec;
  spec.form = Curly{0.005, 0.02};
  spec.length = 0.04 * elements;
  spec.elements = elements;
  const HelixStart start = helix_start(spec);
  HelixMotion motion(start.strand);
  motion.place(start.root.frame, start.q);
  add_weight(Vector3d(0, 0, -9.81), motion);
  const Eigen::Index size = start.q.size();
  const Eigen::VectorXd rates = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd change(size);
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Zero(size, size + 10), M(size, size);
  HelixCost cost{elements, 0, 0};
  cost.step = time_of([&] {
    helix_step(start.strand, motion.elements, motion.points, start.q, rates, kCostStep, scratch, change);
  });
  cost.mass_matrix = time_of([&] { mass_matrix(motion.elements, motion.points, M); });
  return cost;
}

}  // namespace

std::optional<std::vector<HelixCost>> helix_costs(bool quick, const std::atomic<bool>& interrupted) {
  std::vector<HelixCost> costs;
  for (int elements = 1; elements <= (quick ? 16 : 160);
       elements = elements < 5 ? elements + 1 : 2 * elements) {
    if (interrupted) return {};
    costs.push_back(cost_of(elements));
  }
  return costs;
}

}  // namespace hair::model_study
