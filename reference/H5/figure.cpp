// STAFF ONLY. H5's figure: a stretched hair after Newton steps and after sweeps.
#include "hair/length_correction.h"
#include "hair/strand/make_strand.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

constexpr int kSegments = 24;

// A wavy hair that is 2 % too long.
VectorXd stretched() {
  VectorXd x = VectorXd::Zero(3 * kSegments + 3);
  for (int i = 1; i <= kSegments; ++i) {
    const double angle = 0.5 * std::sin(0.4 * i);
    x.segment<3>(3 * i) = x.segment<3>(3 * i - 3) + 0.0102 * Vector3d(std::sin(angle), -std::cos(angle), 0);
  }
  return x;
}

void draw_hair(Drawing& drawing, const Spot& root, const hair::Strand& strand, const VectorXd& x, int look,
               const std::string& name, double error) {
  const View view = {root, 900};
  Spots spots;
  for (int i = 0; i <= kSegments; ++i) spots.push_back(view(x.segment<3>(3 * i)));
  for (int i = 0; i < kSegments; ++i) {
    const double length = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    const bool wrong = std::abs(length / strand.rest_length[i] - 1) > 1e-4;
    drawing.line({spots[i], spots[i + 1]}, {wrong ? colour(1) : colour(look), 2.5});
  }
  for (const Spot& spot : spots) drawing.dot(spot, kText, 1.6);
  drawing.dot(root, kText, 5);
  drawing.words({root[0], 46}, name, {kText, "middle", 16, "bold"});
  drawing.words({root[0], 312},
                error > 1e-4    ? "off by " + fixed(100 * error, error < 0.01 ? 2 : 0) + " %"
                : error > 1e-12 ? "off by " + hair::to_text(error)
                                : "exact",
                {kText, "middle", 13});
}

}  // namespace

std::string draw_H5() {
  Drawing drawing("H5", "How many Newton steps, and how many sweeps, give a stretched hair its lengths?",
                  "A hair that is 2 percent too long, after one to three Newton steps, and after 10, "
                  "100 and 1,000 sweeps of relaxation. "
                  "Three Newton steps leave less than a millionth, a hundred sweeps half a percent.",
                  330);
  const hair::Strand strand = hair::uniform_strand({}, kSegments, 0.01 * kSegments);
  Eigen::MatrixXd scratch(3 * kSegments + 3, hair::kCorrectionScratch);
  double at = 56;
  for (const int steps : {0, 1, 2, 3}) {
    VectorXd x = stretched();
    const hair::CorrectionReport report = hair::correct_lengths(strand, 1e-12, steps, x, scratch);
    draw_hair(drawing, {at, 68}, strand, x, 0, std::to_string(steps), report.error);
    at += 100;
  }
  for (const int sweeps : {10, 100, 1000}) {
    VectorXd x = stretched();
    const hair::CorrectionReport report = hair::relax_lengths(strand, 1e-12, sweeps, x);
    draw_hair(drawing, {at, 68}, strand, x, 0, std::to_string(sweeps), report.error);
    at += 100;
  }
  drawing.words({206, 22}, "Newton steps", {colour(0)});
  drawing.words({556, 22}, "sweeps of relaxation", {colour(0)});
  return drawing.svg();
}

}  // namespace figures
