// Clamped hair without weight, bent by a moment at its tip: an arc, up to a full circle.
//
// A rod's curvature is M / EI everywhere. In a strand each joint bends by a = M l / EI, and the clamp by
// half of that. So segments have exactly the arc's angles in their middles, and particles lie on an arc as
// well, which is larger by (a/2) / sin(a/2), 1 + a^2/24 + ...; a full circle closes.
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/validations.h"
#include "particles/force_sum.h"

namespace hair {

namespace {

// The moment M on the last segment e, in the plane y = 0, from x down: forces M J e / |e|^2 and the opposite
// on its ends, with J (x, z) = (z, -x). They turn with it. As an energy, -M times the angle.
class EndMoment final : public particles::Force {
 public:
  explicit EndMoment(double moment) : moment_(moment) {}
  double energy(particles::Input x) const override {
    const Vector3d e = last_segment(x);
    return -moment_ * std::atan2(-e[2], e[0]);
  }
  void add_force(particles::Input x, particles::Input, particles::Output f) const override {
    const Vector3d e = last_segment(x);
    add_couple(moment_ / e.squaredNorm() * turned(e), f);
  }
  void add_dfdx(particles::Input x, particles::Input, particles::Input dx,
                particles::Output df) const override {
    const Vector3d e = last_segment(x), de = last_segment(dx);
    add_couple(moment_ / e.squaredNorm() * turned(de - 2 * e.dot(de) / e.squaredNorm() * e), df);
  }
  void add_dfdv(particles::Input, particles::Input, particles::Input, particles::Output) const override {}

 private:
  static Vector3d last_segment(particles::Input x) { return x.tail<3>() - x.segment<3>(x.size() - 6); }
  static Vector3d turned(const Vector3d& e) { return {e[2], 0, -e[0]}; }
  static void add_couple(const Vector3d& force, particles::Output f) {
    f.tail<3>() += force;
    f.segment<3>(f.size() - 6) -= force;
  }

  double moment_;
};

// Bent by `turn` radians in all.
void check_arc(const Material& material, int segments, double turn, const std::string& name,
               ValidationResult& result) {
  const StrandStart start = clamped_hair(material, segments, kBeamLength, Vector3d::UnitX());
  const auto strand = under_gravity(start, Vector3d::Zero());
  strand->force.emplace<EndMoment>(material.bend_rigidity() * turn / kBeamLength);
  const Balance balance = planar_balance(strand->strand, strand->force, start.state.x);
  const double joint = turn / segments, step = kBeamLength / segments;
  double worst = balance.found() ? 0 : std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < segments; ++i) {
    const Vector3d e = balance.x.segment<3>(3 * i + 3) - balance.x.segment<3>(3 * i);
    worst = std::max(
        worst, std::abs(std::remainder(std::atan2(-e[2], e[0]) - (i + 0.5) * joint, 2 * std::numbers::pi)));
  }
  const std::string id = name + "-n" + std::to_string(segments);
  const std::string shows = name + ", " + std::to_string(segments) + " segments: ";
  const double rounding = 0x1p-53 * 16 * segments * segments;
  const std::string why = "rounding: 16 n^2 of 2^-53";
  result.checks.push_back({id + "-angles",
                           shows + "the worst angle of a segment, against the arc's in its middle",
                           "curvature M / EI", 0, worst, rounding, why, "rad"});
  // The chord of the arc on which particles are.
  const double radius = step / 2 / std::sin(joint / 2);
  result.checks.push_back({id + "-chord", shows + "from root to tip, over L",
                           "the arc, larger by (a/2) / sin(a/2), a = M l / EI",
                           2 * radius * std::abs(std::sin(turn / 2)) / kBeamLength,
                           tip_of(balance).norm() / kBeamLength, rounding, why});
}

ValidationResult bend_into_arcs(const ValidationSettings& settings) {
  ValidationResult result;
  for (int segments : {10, 20, 40, 80}) {
    settings.go_on();
    check_arc({}, segments, std::numbers::pi / 2, "quarter", result);
    check_arc({}, segments, 2 * std::numbers::pi, "circle", result);
  }
  return result;
}

}  // namespace

Validation end_moment() {
  return {"end-moment", "A moment at its tip bends clamped hair into an arc", {"H1", "H2"}, bend_into_arcs};
}

}  // namespace hair
