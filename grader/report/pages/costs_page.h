// STAFF ONLY. costs.html: the time of grading, the most expensive first, compared with the reference. It has
// times, so it differs from run to run. timing.json tells the parts of each cost.
#pragma once

#include <string>

#include "grader/result/costs.h"
#include "grader/roster/class_list.h"

namespace grader::inline report {

std::string costs_page(const ClassCosts& costs, const NamesForPeople& people = {});

}  // namespace grader::report
