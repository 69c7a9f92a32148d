// The first three frequencies of clamped hair without weight, compared with those of a beam.
#include <cmath>
#include <string>
#include <vector>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

constexpr int kModes = 3;

// The largest eigenvalue is (2n / b)^4 times that of mode b, and its rounding error is relative to it.
double rounding_of(double root, int segments) {
  return 0x1p-53 * std::pow(2 * segments / root, 4);
}

}  // namespace

ValidationResult beam_frequencies(const ValidationSettings& settings) {
  ValidationResult result;
  const double published[] = {1.875104, 4.694091, 7.854757};
  for (int mode = 1; mode <= kModes; ++mode)
    result.checks.push_back({"root" + std::to_string(mode),
                             "root " + std::to_string(mode) + " of cos b cosh b = -1",
                             "S. S. Rao, Vibration of Continuous Systems, 2007", published[mode - 1],
                             clamped_beam_root(mode), 5e-7, "half of the last published digit"});

  Table table{"Frequencies of clamped hair: b = L (w^2 rho A / EI)^(1/4)",
              {"segments", "mode 1", "mode 2", "mode 3"},
              {}};
  double before[kModes] = {};  // the errors with half as many segments
  for (const int segments : {10, 20, 40, 80}) {
    settings.go_on();
    const BeamModes modes = beam_modes(clamped_hair({}, segments, kBeamLength, Vector3d::UnitX()));
    const std::string n = std::to_string(segments);
    std::vector<std::string>& row = table.rows.emplace_back(1, n);
    for (int mode = 1; mode <= kModes; ++mode) {
      const double exact = clamped_beam_root(mode),
                   expected = -clamped_beam_error(mode) / (segments * segments);
      const double root = beam_root_of({}, kBeamLength, modes.frequencies[mode - 1]);
      const double error = std::pow(root / exact, 4) - 1;  // relative, of w^2
      const double rounding = rounding_of(exact, segments);
      const std::string id = "mode" + std::to_string(mode) + "-n" + n,
                        shows = "mode " + std::to_string(mode) + ", " + n + " segments: ";
      result.checks.push_back(
          {id + "-error", shows + "relative error of w^2",
           "Rayleigh's quotient with the strand's energies (clamped_hair.h)", expected, error,
           expected * expected + rounding,
           "the next term: about the square of this one; and rounding of the eigenvalues"});
      if (segments > 10)
        result.checks.push_back(
            {id + "-order", shows + "order of convergence", "central differences, clamped by half a segment",
             2, std::log2(before[mode - 1] / error),
             1.1 * 4 * std::abs(expected) + 1.5 * rounding / std::abs(expected),
             "the error's next term: 3/4 of it at half as many segments, over log(2); and rounding"});
      before[mode - 1] = error;
      row.push_back(printed("%.9g", root));
    }
  }
  result.tables = {table};
  return result;
}

}  // namespace hair
