#include "hair/lab/models/family.h"

namespace hair::model_study {

namespace {

using enum GeometricTerm;

constexpr Family kFamilies[] = {
    {"springs-h4", "springs, H4", "mass_spring", Method::implicit_euler, filtered},
    {"springs-h4-dropped", "springs, H4, dropped", "mass_spring", Method::implicit_euler, dropped},
    {"springs-h6", "springs, H6", "mass_spring", Method::predictor_corrector, dropped},
    {"springs-symplectic", "springs, symplectic Euler", "mass_spring", Method::symplectic_euler},
    {"links", "rigid links, implicit", "rigid_links", Method::implicit_euler},
    {"links-stiff-twist", "rigid links, 1,000 GJ", "rigid_links", Method::implicit_euler, {}, 1, 1000},
    {"links-rk4", "rigid links, RK4", "rigid_links", Method::runge_kutta_4},
    {"helices", "super-helices", "super_helix", Method::implicit_euler},
};

constexpr Family kStiff[] = {
    {"springs-1", "springs, hair's EA", "mass_spring", Method::implicit_euler, filtered, 1},
    {"springs-100", "springs, 100 EA", "mass_spring", Method::implicit_euler, filtered, 100},
    {"springs-10000", "springs, 10,000 EA", "mass_spring", Method::implicit_euler, filtered, 10'000},
    {"springs-10000-dropped", "springs, 10,000 EA, dropped", "mass_spring", Method::implicit_euler, dropped,
     10'000},
    {"links", "rigid links", "rigid_links", Method::implicit_euler},
};

}  // namespace

std::span<const Family> families() {
  return kFamilies;
}

std::span<const Family> stiff_families() {
  return kStiff;
}

}  // namespace hair::model_study
