// A curl without gravity stays as it is, at any place and in any direction: it moves only by rounding.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

// At rest near the origin; then turned and moved by its own length, so that all coordinates are rounded anew.
StrandStart turned_curl(const Material& material, int segments, double length) {
  const RestShape shape = curly_shape(segments, length, 0.01, 0.02, {});
  StrandStart start = start_at_rest(material, shape);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3d move = length * Vector3d(3, -2, 6) / 7;
  for (int i = 0; i <= segments; ++i)
    start.state.x.segment<3>(3 * i) = turn * start.state.x.segment<3>(3 * i) + move;
  start.strand.root_tangent = (turn * start.strand.root_tangent).normalized();
  start.root_normal = turn * start.root_normal;
  return start;
}

// m. Coordinates and rest lengths are rounded: a length is off by e, 2^-51 of the largest coordinate, and the
// energy by n EA e^2 / 2 l. As no method gains energy, the softest mode of stiffness c, c r^2 = n EA e^2 / l,
// is moved by r at most. Of a straight hair c = 12.36 EI / n L^3 (clamped_hair.h: b^4 of mode 1); that of a
// curl is higher (of three turns: 13 to 15 times).
double moved_by_rounding(const Strand& strand, const Eigen::VectorXd& x) {
  const double n = strand.segments(), length = strand.rest_length.sum();
  const double e = 0x1p-51 * x.cwiseAbs().maxCoeff();
  const double softest = 12.36 * strand.bend_rigidity / (n * std::pow(length, 3));
  return std::sqrt(n * strand.stretch_rigidity * e * e / strand.rest_length.minCoeff() / softest);
}

ValidationResult watch_curl(Method method, const ValidationSettings& settings) {
  const Material hair;
  constexpr double kLength = 0.2, kSeconds = 1, kStep = 1.0 / 240;
  ValidationResult result;
  for (int segments : {16, 32}) {
    if (settings.quick && segments > 16) continue;
    Description description;
    description.strands = {turned_curl(hair, segments, kLength)};
    description.method = method;
    description.step = kStep;
    description.gravity.setZero();
    const Eigen::VectorXd x = description.strands[0].state.x;
    Simulation simulation(std::move(description));
    const double bound = moved_by_rounding(simulation.strand(0), x);
    double farthest = 0;
    while (simulation.time() < kSeconds) {
      settings.go_on();
      if (simulation.step()) {  // it broke
        farthest = std::numeric_limits<double>::quiet_NaN();
        break;
      }
      for (int i = 0; i <= segments; ++i)
        farthest = std::max(farthest, (simulation.state(0).x - x).segment<3>(3 * i).norm());
    }
    result.checks.push_back(
        {"n" + std::to_string(segments),
         std::to_string(segments) + " segments, 1 s: the farthest that a particle was from its place, over L",
         "nothing pulls at it", 0, farthest / kLength, bound / kLength,
         "the energy that rounding of coordinates may bring, 2^-51 of the largest, and the stiffness of a "
         "straight hair's first mode: a curl's is higher"});
  }
  return result;
}

}  // namespace

Validation curl_at_rest(Method method) {
  const bool h4 = method == Method::implicit_euler;
  return {h4 ? "curl-h4" : "curl-h6", std::string("A curl without gravity stays put, ") + (h4 ? "H4" : "H6"),
          h4 ? std::vector<std::string>{"S1", "H1", "H4"}
             : std::vector<std::string>{"S1", "H1", "H4", "H5", "H6"},
          [method](const ValidationSettings& settings) { return watch_curl(method, settings); }};
}

}  // namespace hair
