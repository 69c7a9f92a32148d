// STAFF ONLY. H5's figure: a stretched hair after Newton steps and after sweeps.
#include "hair/io/plot/page.h"
#include "hair/length_correction.h"
#include "hair/strand/make_strand.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

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

}  // namespace

std::string draw_h5() {
  Drawing drawing("H5", 346, "How fast does a stretched hair get its lengths back?",
                  "A hair after Newton steps and after sweeps; wrong segments have a colour of their own.");
  const hair::Strand strand = hair::uniform_strand({}, kSegments, 0.01 * kSegments);
  Eigen::MatrixXd scratch(3 * kSegments + 3, hair::kCorrectionScratch);
  double middle = 52;
  for (const int iterations : {0, 1, 2, 3, 4, 10, 100, 1000}) {
    VectorXd x = stretched();
    const double error = iterations < 10 ? hair::correct_lengths(strand, 1e-12, iterations, x, scratch).error
                                         : hair::relax_lengths(strand, 1e-12, iterations, x).error;
    const View view = {{middle, 68}, 900};
    for (int i = 0; i < kSegments; ++i) {
      const Vector3d from = x.segment<3>(3 * i), to = x.segment<3>(3 * i + 3);
      const bool wrong = std::abs((to - from).norm() / strand.rest_length[i] - 1) > 1e-4;
      drawing.line({view(from), view(to)}, {colour(wrong ? 1 : 0), 2.5});
      drawing.dot(view(from), kText, i == 0 ? 5 : 1.6);
    }
    drawing.words({middle, 46}, std::to_string(iterations), {kText, "middle", 16, "bold"});
    drawing.words({middle, 312}, error < 1e-12 ? "< 1e-12" : hair::to_text(error));
    middle += 88;
  }
  drawing.words({360, 340}, "Numbers: the largest error. This colour: an error above 1e-4.", {colour(1)});
  drawing.words({272, 22}, "Newton steps");
  drawing.words({580, 22}, "sweeps of relaxation");
  return drawing.svg();
}

}  // namespace figures
