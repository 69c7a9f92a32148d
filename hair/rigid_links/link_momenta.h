// Momenta that the links of a strand keep from one linearly implicit step to the next, for steps in which
// explicit velocity terms or weight can't hold. The links are a chain of rods with spherical joints.
//
// h c is the change of velocity that a link's centre gets at constant rates. It is also the difference of two
// velocities: v_now, of these rates at the present place, and v_kept, at the end of the previous step, at its
// place. With
//
//   m (v_kept - v_now) / h    in place of    - m c
//
// a step finds the velocities that are nearest to the kept ones, with masses as weights. Such a projection
// makes no energy. It loses some: a spin w loses the part (h w)^2 of its energy in each step.
//
// Weight is then taken at the step's end, too. Link i with its length l along u, and with all links beyond,
// has the energy -l W . u, W = g (m_i / 2 + the masses beyond). A turn of the link about an axis across u
// changes this by l W . u / 2 per rad^2. So h^2 max(0, l W . u) (1 - u u^T) adds to its J.
//
// A step needs momenta if one of these is true:
//
// (1) Velocity terms make energy. In the root's frame a step makes, 0 in a free spin,
//
//       sum of m / 2 (|v_now|^2 - |v_kept|^2 - h c . (v_now + v_end))
//
//     The sum of all steps, at least 0, exceeds kSpare of m |g| L and the kinetic energy.
//
// (2) A joint's force pulls its rod by more than the tension T that explicit steps hold. Waves of the wave
//     number k have, per metre, the mass mu, and the stiffness T k^2 (explicit) + EI k^4 (implicit). They
//     hold if, for k^2 <= 4 / l^2 (with short links this means T <= 4 sqrt(EI mu) / h),
//
//       h^2 T k^2 <= 4 mu + h^2 EI k^4
//
// Momenta stay in use until neither was true for a sixtieth of a second, with half of (1)'s bound.
#pragma once

#include <vector>

#include "hair/rigid_links/tree_motion.h"

namespace hair {

struct TreeForces;

class LinkMomenta {
 public:
  LinkMomenta(const LinkTree& tree, const TreeForces& forces);

  // The present step: true if it takes momenta; its velocities, m/s and rad/s, found at its start's places.
  bool in_use() const { return now_.in_use; }
  const std::vector<SpatialMotion>& velocities() const { return now_.velocities; }

  // The next step follows the present one, or none.
  void next() { before_ = now_; }
  void forget() {
    before_.known = before_.in_use = false;
    before_.made = before_.calm = 0;
  }

  // The present step begins, maybe again.
  void begin();

  // Between pass 1 and pass 2: takes momenta and the weight's second derivative.
  void add_to(TreeMotion& motion, double h) const;

  // After pass 3. True: the step must be repeated, with momenta.
  bool ask_for(const TreeMotion& motion, Input rates, Input accelerations, double h);

 private:
  struct Step {
    std::vector<SpatialMotion> velocities;
    bool known = false, in_use = false;
    double made = 0;  // J, by (1)
    double calm = 0;  // s, since the last need
  };
  double tension(double h) const;

  Vector3d gravity_;
  double bend_rigidity_ = 0, line_density_ = 0, shortest_ = 0, unit_ = 0;  // N m^2, kg/m, m; m |g| L, J
  std::vector<double> lengths_;
  Step before_, now_;
};

}  // namespace hair
