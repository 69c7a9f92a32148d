// Clamped hair without weight swings in its first mode. A method's frequency, corrected for its own
// dispersion, is that of the strand's matrices.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

constexpr int kBeamSegments = 10;

struct SwingMethod {
  Method method;
  const char *id, *name;
  double (*undo)(double measured, double step);
  double (*decay)(double phase);  // decay of the amplitude in a step that turns by `phase`; or null
};

// Both implicit methods multiply the amplitude by the cosine of the phase: see dispersion.h. With Runge-Kutta
// the fastest axial mode has the phase 1 in a step; the first mode shows no decay.
double cosine_decay(double phase) {
  return -std::log(std::cos(phase));
}

constexpr SwingMethod kSwingMethods[] = {
    {Method::runge_kutta_4, "rk4", "Runge-Kutta 4", undo_runge_kutta_4, nullptr},
    {Method::implicit_euler, "h4", "H4", undo_implicit_euler, cosine_decay},
    {Method::predictor_corrector, "h6", "H6", undo_filters, cosine_decay},
};

struct BeamSwing {
  double step;  // s
  int steps;    // from one sample to the next
  Sinusoid fit;
};

// The first mode, sampled 40 times a period; far less than a hair's radius high: moved sideways by a, a
// strand is longer by a^2 / 2 L, and pulls back by EA of that.
constexpr double kHeight = 1e-9;  // over L

BeamSwing sample_swing(const StrandStart& rest, const BeamModes& modes, Method method,
                       const ValidationSettings& settings) {
  const Strand& strand = rest.strand;
  const double period = 2 * std::numbers::pi / modes.frequencies[0];
  // Below 2 / w of the fastest axial mode, or, if no mode is too fast, long enough to show the dispersion.
  const double fastest = 2 * std::sqrt(strand.stretch_rigidity / (strand.mass[1] * strand.rest_length[0]));
  const int steps =
      method == Method::runge_kutta_4 ? static_cast<int>(std::ceil(period / 40 * fastest / 2)) : 1;
  BeamSwing result{period / 40 / steps, steps, {}};

  Description description;
  description.strands = {rest};
  const Eigen::VectorXd shape = modes.shapes.col(0) / modes.shapes.col(0).cwiseAbs().maxCoeff();
  for (int i = 1; i <= kBeamSegments; ++i)
    description.strands[0].state.x[3 * i + 2] = kHeight * kBeamLength * shape[i - 1];
  description.method = method;
  description.step = result.step;
  description.gravity.setZero();
  Simulation simulation(std::move(description));

  Eigen::VectorXd samples(method == Method::runge_kutta_4 && settings.quick ? 80 : 160);
  for (Eigen::Index k = 0; k < samples.size(); ++k) {
    settings.go_on();
    samples[k] = simulation.state(0).x[3 * kBeamSegments + 2] / (kHeight * kBeamLength);
    if (!simulation.advance(result.steps)) continue;
    samples.setConstant(std::numeric_limits<double>::quiet_NaN());  // the run broke
    break;
  }
  result.fit = fit_sinusoid(samples);
  return result;
}

ValidationResult swing_beam(const SwingMethod& known, const ValidationSettings& settings) {
  const StrandStart rest = clamped_hair({}, kBeamSegments, kBeamLength, Vector3d::UnitX());
  const BeamModes modes = beam_modes(rest);
  const BeamSwing swung = sample_swing(rest, modes, known.method, settings);
  const double phase = swung.fit.frequency / swung.steps;  // in a step
  const double measured = known.undo(phase / swung.step, swung.step) / modes.frequencies[0];

  ValidationResult result;
  const Strand& strand = rest.strand;
  const double tolerance = 1e-10 + strand.stretch_rigidity * kBeamLength * kBeamLength /
                                       strand.bend_rigidity * (0x1p-53 * kBeamSegments + kHeight * kHeight);
  const std::string why =
      "solves, 1e-10; and what EA makes of a stretch, L^2 EA / EI, by 2^-53 n of rounding and by the swing's "
      "height, squared";
  result.checks.push_back({"frequency", "w, its dispersion undone, over that of the matrices",
                           "the method's dispersion (dispersion.h)", 1, measured, tolerance, why});
  const double off = -clamped_beam_error(1) / (kBeamSegments * kBeamSegments);
  result.checks.push_back({"root", "b = L (w^2 rho A / EI)^(1/4), of 10 segments",
                           "a beam's 1.875104, less the strand's error (clamped_hair.h)",
                           clamped_beam_root(1) * std::pow(1 + off, 0.25),
                           beam_root_of({}, kBeamLength, measured * modes.frequencies[0]),
                           clamped_beam_root(1) * off * off / 4 * 1.1,
                           "the error's next term: about the square of the first"});
  if (known.decay)
    result.checks.push_back({"decay", "what a step takes from the amplitude",
                             "the method's amplification of an oscillation", known.decay(phase),
                             swung.fit.decay / swung.steps, tolerance * phase, "that of the phase"});
  return result;
}

}  // namespace

std::vector<Validation> beam_swings() {
  std::vector<Validation> all;
  for (const SwingMethod& known : kSwingMethods) {
    const auto own = row_of(known.method).exercises;
    Validation& one = all.emplace_back();
    one.id = std::string("beam-swing-") + known.id;
    one.title = std::string("Clamped hair swings in its first mode, ") + known.name;
    one.exercises.assign(own.begin(), own.end());
    one.exercises.insert(one.exercises.end(), {"H1", "H2"});
    one.run = [&known](const ValidationSettings& settings) { return swing_beam(known, settings); };
  }
  return all;
}

}  // namespace hair
