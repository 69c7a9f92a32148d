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

struct Errors {
  int segments;
  double roots[kModes], errors[kModes];  // errors of w^2, relative
};

Errors errors_of(const Material& material, int segments) {
  Errors result{segments, {}, {}};
  const BeamModes modes = beam_modes(clamped_hair(material, segments, kBeamLength, Vector3d::UnitX()));
  for (int mode = 1; mode <= kModes; ++mode) {
    const double root = beam_root_of(material, kBeamLength, modes.frequencies[mode - 1]);
    result.roots[mode - 1] = root;
    result.errors[mode - 1] = std::pow(root / clamped_beam_root(mode), 4) - 1;
  }
  return result;
}

double order(const Errors& coarse, const Errors& fine, int mode) {
  return std::log2(coarse.errors[mode - 1] / fine.errors[mode - 1]);
}

void check(const Errors& now, const Errors* coarse, std::vector<Check>& checks) {
  const std::string n = std::to_string(now.segments);
  for (int mode = 1; mode <= kModes; ++mode) {
    const std::string id = "mode" + std::to_string(mode) + "-n" + n;
    const std::string shows = "mode " + std::to_string(mode) + ", " + n + " segments: ";
    const double expected = -clamped_beam_error(mode) / (now.segments * now.segments);
    const double rounding = rounding_of(clamped_beam_root(mode), now.segments);
    checks.push_back({id + "-error", shows + "relative error of w^2",
                      "Rayleigh's quotient with the strand's energies (clamped_hair.h)", expected,
                      now.errors[mode - 1], expected * expected + rounding,
                      "the next term: about the square of this one; and rounding of the eigenvalues"});
    if (coarse)
      checks.push_back(
          {id + "-order", shows + "order of convergence", "central differences, clamped by half a segment", 2,
           order(*coarse, now, mode), 1.1 * 4 * std::abs(expected) + 1.5 * rounding / std::abs(expected),
           "the error's next term: 3/4 of it at half as many segments, over log(2); and rounding"});
  }
}

ValidationResult find_frequencies(const ValidationSettings& settings) {
  ValidationResult result;
  const double published[] = {1.875104, 4.694091, 7.854757};
  for (int mode = 1; mode <= kModes; ++mode)
    result.checks.push_back({"root" + std::to_string(mode),
                             "root " + std::to_string(mode) + " of cos b cosh b = -1",
                             "S. S. Rao, Vibration of Continuous Systems, 2007", published[mode - 1],
                             clamped_beam_root(mode), 5e-7, "half of the last published digit"});

  std::vector<Errors> sweep;
  for (int segments : {10, 20, 40, 80}) {
    settings.go_on();
    sweep.push_back(errors_of({}, segments));
    check(sweep.back(), sweep.size() > 1 ? &sweep[sweep.size() - 2] : nullptr, result.checks);
  }

  Table table{"Frequencies of clamped hair: b = L (w^2 rho A / EI)^(1/4)",
              {"segments", "mode 1", "mode 2", "mode 3"},
              {}};
  for (const Errors& one : sweep) {
    std::vector<std::string>& row = table.rows.emplace_back(std::vector{std::to_string(one.segments)});
    for (const double root : one.roots) row.push_back(printed("%.9g", root));
  }
  result.tables = {table};
  return result;
}

}  // namespace

Validation beam_frequencies() {
  return {"beam-frequencies",
          "Frequencies of hair that is clamped and weighs nothing",
          {"H1", "H2"},
          find_frequencies};
}

}  // namespace hair
