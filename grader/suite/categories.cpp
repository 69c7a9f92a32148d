// STAFF ONLY. Which exercise has which hidden suite.
#include <map>

#include "grader/course/input.h"
#include "grader/suite/h1_categories.h"
#include "grader/suite/h2_categories.h"
#include "grader/suite/h3_categories.h"
#include "grader/suite/h4_categories.h"
#include "grader/suite/h5_categories.h"
#include "grader/suite/h6_categories.h"
#include "grader/suite/p1_categories.h"
#include "grader/suite/p2_categories.h"
#include "grader/suite/s1_categories.h"
#include "grader/suite/s2_categories.h"
#include "grader/suite/trial.h"

namespace grader {

std::vector<Category> categories(const std::string& exercise) {
  static const std::map<std::string, std::vector<Category> (*)()> suites = {
      {"H1", h1::categories}, {"H2", h2::categories}, {"H3", h3::categories}, {"H4", h4::categories},
      {"H5", h5::categories}, {"H6", h6::categories}, {"P1", p1::categories}, {"P2", p2::categories},
      {"S1", s1::categories}, {"S2", s2::categories},
  };
  const auto suite = suites.find(exercise);
  if (suite == suites.end())
    throw BadInput("exercise " + exercise + " has no hidden suite; add it in grader/suite/categories.cpp");
  return suite->second();
}

}  // namespace grader
