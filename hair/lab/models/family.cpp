#include "hair/lab/models/family.h"

namespace hair::model_study {

namespace {

using enum GeometricTerm;

constexpr Family kFamilies[] = {
    {.id = "springs-h4",
     .name = "springs, H4",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = filtered},
    {.id = "springs-h4-dropped",
     .name = "springs, H4, dropped",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = dropped},
    {.id = "springs-h6",
     .name = "springs, H6",
     .model = "mass_spring",
     .method = Method::predictor_corrector,
     .geometric_term = dropped},
    {.id = "springs-symplectic",
     .name = "springs, symplectic Euler",
     .model = "mass_spring",
     .method = Method::symplectic_euler},
    {.id = "links",
     .name = "rigid links, implicit",
     .model = "rigid_links",
     .method = Method::implicit_euler},
    {.id = "links-stiff-twist",
     .name = "rigid links, 1,000 GJ",
     .model = "rigid_links",
     .method = Method::implicit_euler,
     .twist_factor = 1000},
    {.id = "links-rk4", .name = "rigid links, RK4", .model = "rigid_links", .method = Method::runge_kutta_4},
    {.id = "helices", .name = "super-helices", .model = "super_helix", .method = Method::implicit_euler},
};

constexpr Family kStiff[] = {
    {.id = "springs-1",
     .name = "springs, hair's EA",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = filtered,
     .stretch_factor = 1},
    {.id = "springs-100",
     .name = "springs, 100 EA",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = filtered,
     .stretch_factor = 100},
    {.id = "springs-10000",
     .name = "springs, 10,000 EA",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = filtered,
     .stretch_factor = 10'000},
    {.id = "springs-10000-dropped",
     .name = "springs, 10,000 EA, dropped",
     .model = "mass_spring",
     .method = Method::implicit_euler,
     .geometric_term = dropped,
     .stretch_factor = 10'000},
    {.id = "links", .name = "rigid links", .model = "rigid_links", .method = Method::implicit_euler},
};

}  // namespace

std::span<const Family> families() {
  return kFamilies;
}

std::span<const Family> stiff_families() {
  return kStiff;
}

}  // namespace hair::model_study
