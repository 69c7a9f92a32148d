// What a control mesh costs a guide: a step of guides with links, and with links and strips, beside a step of the same guides
// without, each by itself; and whether threads would pay for it.
//
// Guides of 14 segments grow in rows of ten, 1 cm apart, and swing. Each round times a few steps of all three in turn, by the
// thread's CPU time; the medians of rounds are compared.
//
//   linked_bench            no arguments
#include <cstdio>
#include <functional>
#include <optional>
#include <vector>

#include "hair/head/control_mesh.h"
#include "hair/simulation/simulation.h"
#include "hair/simulation/strand_threads.h"
#include "solver/block_band.h"
#include "solver/timing.h"

namespace linked_bench {
namespace {

using hair::Description, hair::Simulation, hair::Vector3d;

constexpr double kStep = 1.0 / 240;
constexpr int kSegments = 14, kRow = 10, kStepsBefore = 40, kRounds = 15;

Description swinging_guides(int count) {
  Description description;
  description.method = hair::Method::implicit_euler;
  description.step = kStep;
  description.drag = 2e-4;
  description.watched = false;
  for (int i = 0; i < count; ++i) {
    hair::StrandSpec spec;
    spec.elements = kSegments;
    spec.length = 0.01 * kSegments;
    const int row = i / kRow;
    spec.root.position = 0.01 * Vector3d(i % kRow, row, 0);
    spec.root.axis = Vector3d(0.5, 0.2 + 0.02 * (i % 3), -1).normalized();
    spec.root.side = hair::side_of(spec.root.axis);
    description.strands.push_back(discretise(spec));
  }
  return description;
}

Description linked(Description guides, bool strips) {
  std::vector<int> rows;
  for (int i = 0; i < static_cast<int>(guides.strands.size()); i += kRow) rows.push_back(i);
  const std::vector<hair::Pair> pairs =
      hair::neighbours(rows, static_cast<int>(guides.strands.size()), hair::Neighbours::rows);
  hair::MeshSpec spec{5e-4, 0.1, 0.5};
  if (strips) spec.strips = hair::StripLaw{0.004, 0.02, 0.3};
  guides.mesh = control_mesh(guides.strands, pairs, spec);
  return guides;
}

struct Timed {
  explicit Timed(Description description) : simulation(std::move(description)) {
    simulation.advance(kStepsBefore);
  }
  void round(long steps) {
    const long before = simulation.work().solver_steps;
    const double start = timing::cpu_seconds();
    simulation.advance(steps);
    seconds.push_back((timing::cpu_seconds() - start) / static_cast<double>(steps));
    iterations = static_cast<double>(simulation.work().solver_steps - before) / static_cast<double>(steps);
  }
  double median() const { return timing::median(seconds); }

  Simulation simulation;
  std::vector<double> seconds;
  double iterations = 0;  // of the solver, in a step
};

// Wall time of what each strand does by itself in a linked step, on so many threads: the least of many.
class OfStrands {
 public:
  OfStrands(const Simulation& simulation, int threads) : simulation_(simulation), threads_(threads) {
    for (int i = 0; i < simulation.strands(); ++i) {
      const Eigen::Index size = simulation.state(i).x.size();
      dx_.emplace_back(1e-3 * simulation.state(i).x);
      df_.emplace_back(Eigen::VectorXd::Zero(size));
      bands_.emplace_back(Eigen::MatrixXd::Zero(size, solver::BlockBand::kColumns));
      work_.emplace_back(Eigen::MatrixXd::Zero(size, particles::kBandScratch));
    }
  }
  double product() {
    return least([&](int, int i) {
      simulation_.force(i).add_dfdx(simulation_.state(i).x, simulation_.state(i).v, dx_[i], df_[i]);
    });
  }
  double band() {
    return least([&](int, int i) {
      solver::BlockBand band(bands_[i]);
      simulation_.force(i).add_band(simulation_.state(i).x, simulation_.state(i).v, -kStep * kStep, -kStep,
                                    band, work_[i]);
    });
  }

 private:
  template <class Of>
  double least(const Of& of) {
    const hair::StrandThreads::Task task = std::ref(of);
    double least = 1e9;
    for (int k = 0; k < 400; ++k) {
      const timing::Stopwatch watch;
      threads_.run(simulation_.strands(), task);
      least = std::min(least, watch.seconds());
    }
    return least;
  }

  const Simulation& simulation_;
  hair::StrandThreads threads_;
  std::vector<Eigen::VectorXd> dx_, df_;
  std::vector<Eigen::MatrixXd> bands_, work_;
};

void measure(int guides) {
  const Description plain = swinging_guides(guides);
  Timed alone(plain), links(linked(plain, false)), strips(linked(plain, true));
  const long steps = std::max(1, 500 / guides);
  for (int round = 0; round < kRounds; ++round)
    for (Timed* one : {&alone, &links, &strips}) one->round(steps);
  const double base = alone.median();
  OfStrands one(alone.simulation, 1), two(alone.simulation, 2);
  const double products = (links.iterations + 3) * one.product(), band = one.band(),
               saved = products + band - (links.iterations + 3) * two.product() - two.band();
  std::printf("| %d | %.1f | %.1f (%.1f) | %.1f (%.1f) | %.0f | %.0f %%, %.0f %% | %.0f %%, %.0f %% |\n",
              guides, 1e6 * base / guides, 1e6 * links.median() / guides, links.median() / base,
              1e6 * strips.median() / guides, strips.median() / base, links.iterations,
              100 * products / links.median(), 100 * band / links.median(), 100 * saved / links.median(),
              100 * saved / strips.median());
}

}  // namespace
}  // namespace linked_bench

int main() {
  std::printf(
      "| guides | alone, us a step and guide | with links (times) | with strips, too (times) | iterations | "
      "of a step "
      "with links: the strands' products, their bands | two threads for both would save: with links, with "
      "strips |\n"
      "|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const int guides : {10, 50, 500}) linked_bench::measure(guides);
  return 0;
}
