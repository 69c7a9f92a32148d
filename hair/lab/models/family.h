// A family: a strand model with a method, which runs with any number of elements and any step.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hair/geometric_term.h"
#include "hair/simulation/description.h"

namespace hair::model_study {

struct Family {
  const char* id;    // "springs-h4"
  const char* name;  // "springs, H4"
  const char* model;
  Method method;
  std::optional<GeometricTerm> geometric_term = {};
  double stretch_factor = 1;  // of EA
  double twist_factor = 1;    // of GJ
};

// All that are compared. The course may leave out the exercises of some.
std::span<const Family> families();

// Springs with EA 1, 100 and 10,000 times hair's, and rigid links: all at h = 1/60 s.
std::span<const Family> stiff_families();

// Why such a strand can't be there, as it calls one of the `absent` exercises; empty if it can.
std::string left_out(const Family& family, const StrandSpec& spec, const std::vector<std::string>& absent);

// Without weight in `spec`'s family's way: the model, the method, the factor. `left_out` is empty.
Description description_of(const Family& family, const StrandSpec& spec, int elements, double step);

// The longest step, s, with which an explicit method of this family holds for such elements: half of theory's limit.
double explicit_step(const Family& family, const StrandSpec& spec, int elements);

}  // namespace hair::model_study
