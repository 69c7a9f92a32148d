#include "hair/lab/models/fine_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hair/lab/models/family.h"
#include "hair/simulation/simulation.h"
#include "solver/timing.h"

namespace hair::model_study {

namespace {

constexpr Family kChain = {"fine", "fine chain", "rigid_links", Method::runge_kutta_4};

std::optional<std::vector<Eigen::VectorXd>> chain(const ComparedHair& hair, int links,
                                                  const std::atomic<bool>& interrupted) {
  const double moment = kComparedTime / kMoments;
  const long steps = std::lround(std::ceil(moment / explicit_step(kChain, hair.spec, links)));
  Simulation simulation(description_of(kChain, hair.spec, links, moment / static_cast<double>(steps)));
  const Body& body = simulation.body(0);
  Eigen::VectorXd q(body.size()), rate(body.size()), x(3 * body.points()), v(x.size());
  std::vector<Eigen::VectorXd> lines;
  for (int k = 0; k < kMoments; ++k) {
    for (long step = 0; step < steps; ++step) {
      if (interrupted) return {};
      if (simulation.step()) throw std::runtime_error("the fine chain of rigid links blows up");
    }
    body.read(q, rate);
    body.centre_line(q, rate, x, v);
    lines.push_back(compared_points(hair, x, body.arc_lengths()));
  }
  return lines;
}

}  // namespace

Eigen::VectorXd compared_points(const ComparedHair& hair, const Eigen::VectorXd& x,
                                const Eigen::VectorXd& at) {
  const int count = hair.elements.front();
  const Eigen::Index last = at.size() - 1;
  Eigen::VectorXd points(3 * count + 3);
  Eigen::Index after = 1;
  for (int k = 0; k <= count; ++k) {
    const double s = at[last] * k / count;
    while (after < last && at[after] < s) ++after;
    const Eigen::Index first = std::clamp<Eigen::Index>(after - 2, 0, std::max<Eigen::Index>(last - 3, 0));
    Vector3d point = Vector3d::Zero();
    for (Eigen::Index i = first; i <= std::min(first + 3, last); ++i) {  // Lagrange's polynomials
      double weight = 1;
      for (Eigen::Index j = first; j <= std::min(first + 3, last); ++j)
        if (j != i) weight *= (s - at[j]) / (at[i] - at[j]);
      point += weight * x.segment<3>(3 * i);
    }
    points.segment<3>(3 * k) = point;
  }
  return points;
}

double rms_distance(const std::vector<Eigen::VectorXd>& lines, const std::vector<Eigen::VectorXd>& others) {
  double squares = 0;
  long points = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    squares += (lines[k] - others[k]).squaredNorm();
    points += lines[k].size() / 3;
  }
  return std::sqrt(squares / static_cast<double>(points));
}

std::optional<FineMotion> fine_motion(const ComparedHair& hair, const std::atomic<bool>& interrupted) {
  const double start = timing::cpu_seconds();
  const auto coarse = chain(hair, hair.fine, interrupted);
  if (!coarse) return {};
  const auto fine = chain(hair, 2 * hair.fine, interrupted);
  if (!fine) return {};
  FineMotion motion;
  for (std::size_t k = 0; k < fine->size(); ++k)
    motion.lines.emplace_back((*fine)[k] + ((*fine)[k] - (*coarse)[k]) / 3);
  motion.uncertainty = rms_distance(motion.lines, *fine);
  motion.seconds = timing::cpu_seconds() - start;
  return motion;
}

}  // namespace hair::model_study
