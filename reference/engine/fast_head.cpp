// STAFF ONLY. The engine in hairlab's study of a head (hair/lab/head/moving_head.h).
#include <stdexcept>
#include <string>

#include "hair/dense/full_head.h"
#include "hair/lab/head/moving_head.h"
#include "particles/require.h"

namespace hair::head_study {
namespace {

FullHeadSettings engine_settings(const MovingHeadSettings& settings) {
  FullHeadSettings all;
  all.drag = kDrag / all.material.line_density();
  if (settings.collides) all.head = settings.bust;
  all.friction = kFriction;
  all.threads = settings.threads;
  return all;
}

// The engine's segments have one length. As hair grows round a bust, they differ from their mean by up to
// 0.15.
constexpr double kMostUnlike = 0.25;

double mean_segment(std::size_t strand, const Eigen::VectorXd& x) {
  const Eigen::Index segments = x.size() / 3 - 1;
  Eigen::VectorXd lengths(segments);
  for (Eigen::Index k = 0; k < segments; ++k)
    lengths[k] = (x.segment<3>(3 * k + 3) - x.segment<3>(3 * k)).norm();
  const double mean = lengths.mean(), unlike = (lengths.array() / mean - 1).abs().maxCoeff();
  particles::require(
      unlike <= kMostUnlike,
      "what segments of strand " + std::to_string(strand) + " differ by from their mean length", unlike,
      "at most 0.25 of it: give the strand points at equal distances");
  return mean;
}

class FastHead : public MovingHead {
 public:
  FastHead(const GrownHead& head, std::span<const std::size_t> which, const MovingHeadSettings& settings)
      : points_(head.hair->points),
        motion_(turn_of_head()),
        head_(std::vector<int>(which.size(), points_), engine_settings(settings)) {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(3 * points_);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const Eigen::VectorXd& x = head.strands[which[i]];
      head_.set_strand(static_cast<int>(i), mean_segment(which[i], x),
                       (x.segment<3>(3) - x.head<3>()).normalized(), x, still);
    }
  }

  void advance() override {
    constexpr double h = 1 / (kFramesPerSecond * kStepsPerFrame);
    for (int step = 0; step < kStepsPerFrame; ++step) {
      const Way way = way_at(motion_, ++steps_ * h);
      head_.step(h, Eigen::Translation3d(way.to) * way.rotation * Eigen::Translation3d(-way.from));
    }
    if (head_.broken() > 0)
      throw std::runtime_error("the hair broke: " + std::to_string(head_.broken()) + " strands by step " +
                               std::to_string(steps_));
  }

  void read(std::span<double> points) const override {
    Eigen::VectorXd v(3 * points_);
    for (int k = 0; k < head_.strands(); ++k)
      head_.get_strand(k, Eigen::Map<Eigen::VectorXd>(points.data() + 3L * points_ * k, 3L * points_), v);
  }

 private:
  int points_;
  Motion motion_;
  FullHead head_;
  int steps_ = 0;
};

}  // namespace

bool has_fast_head() {
  return true;
}

std::unique_ptr<MovingHead> fast_head(const GrownHead& head, std::span<const std::size_t> which,
                                      const MovingHeadSettings& settings) {
  if (head.hair->curved) return nullptr;
  return std::make_unique<FastHead>(head, which, settings);
}

}  // namespace hair::head_study
