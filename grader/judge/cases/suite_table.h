// STAFF ONLY. The table of hidden suites: an exercise's categories, as its categories.json declares them,
// with the function in reference/<ID>/ that tests each: nearly_straight for NearlyStraight.
#pragma once

#include <string>
#include <vector>

#include "grader/judge/cases/trial.h"
#include "handout/check/category.h"

namespace grader::inline judge {

// Returns all declared categories, also one without cases: the whole run. Throws
// BadInput for an exercise without a suite.
const std::vector<checks::Category>& declared_categories(const std::string& exercise);

// Returns the category with this id, to be run by `run`. Throws std::out_of_range if it is not declared.
Category category_of(const std::string& exercise, const std::string& id, std::function<void(Trial&)> run);

// Returns the categories with hidden cases.
std::vector<Category> categories(const std::string& exercise);

}  // namespace grader::judge
