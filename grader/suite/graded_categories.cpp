// STAFF ONLY. Lists all categories of an exercise.
#include "grader/suite/graded_categories.h"

#include "grader/suite/memory_errors.h"
#include "grader/suite/suite_table.h"
#include "grader/suite/whole_run.h"

namespace grader {

std::vector<Category> graded_categories(const std::string& exercise) {
  std::vector<Category> all = categories(exercise), of_the_run;
  if (const WholeRunPoints run = whole_run_points(exercise); run.run > 0)
    of_the_run = {{"WholeRun", kRunTitle, run.run, {}}, {"Pictures", kPicturesTitle, run.pictures, {}}};
  pay_for_memory_errors(all, of_the_run);
  all.insert(all.end(), of_the_run.begin(), of_the_run.end());
  all.push_back({"Memory", kMemoryTitle, kMemoryPoints, {}});
  return all;
}

}  // namespace grader
