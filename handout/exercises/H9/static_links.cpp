// H9: static links and triangle strips. The contract is in hair/static_links.h, the text in
// exercises/H9/text.md.

#include "hair/static_links.h"

#include "solver/not_implemented.h"

namespace hair {

double link_strength(const StaticLink& /*link*/, double /*largest*/) {
  throw NotImplemented("H9 link_strength");
}

void remember_stretches(std::span<const StaticLink> /*links*/, std::span<const Matrix3d> /*frames*/,
                        Input /*x*/, Output /*largest*/) {
  throw NotImplemented("H9 remember_stretches");
}

double link_energy(std::span<const StaticLink> /*links*/, std::span<const Matrix3d> /*frames*/,
                   Input /*largest*/, Input /*x*/) {
  throw NotImplemented("H9 link_energy");
}

void add_link_force(std::span<const StaticLink> /*links*/, std::span<const Matrix3d> /*frames*/,
                    Input /*largest*/, Input /*x*/, Output /*f*/) {
  throw NotImplemented("H9 add_link_force");
}

void add_link_product(std::span<const StaticLink> /*links*/, Input /*largest*/, Input /*dx*/, Output /*df*/) {
  throw NotImplemented("H9 add_link_product");
}

bool touch_strip(int /*point*/, const std::array<int, 3>& /*corners*/, double /*side*/, double /*thickness*/,
                 Input /*x*/, Input /*tangents*/, StripContact& /*contact*/) {
  throw NotImplemented("H9 touch_strip");
}

double strip_energy(std::span<const StripContact> /*contacts*/, const StripLaw& /*law*/, Input /*x*/) {
  throw NotImplemented("H9 strip_energy");
}

void add_strip_force(std::span<const StripContact> /*contacts*/, const StripLaw& /*law*/, Input /*x*/,
                     Output /*f*/) {
  throw NotImplemented("H9 add_strip_force");
}

void add_strip_product(std::span<const StripContact> /*contacts*/, const StripLaw& /*law*/, Input /*x*/,
                       Input /*dx*/, Output /*df*/) {
  throw NotImplemented("H9 add_strip_product");
}

void apply_strip_friction(std::span<const StripContact> /*contacts*/, const StripLaw& /*law*/,
                          Input /*inverse_mass*/, double /*h*/, Input /*x*/, Output /*v*/) {
  throw NotImplemented("H9 apply_strip_friction");
}

}  // namespace hair
