// STAFF ONLY. Writes the page of a whole run beside the reference's.
#include "grader/report/pages/pages.h"
#include "grader/report/pages/pictures.h"
#include "hair/view/view_page.h"

namespace grader::inline report {

std::string run_page(const SubmissionResult& result, const ExerciseResult& exercise,
                     const NamesForPeople& people) {
  const std::string whose = shown_name(result.name, people);
  const Html measured =
      moments(exercise, "As measured", run_breaks_off(exercise) ? RunEnding::breaks_off : RunEnding::whole,
              whose, {});
  return hair::view_page({{exercise.id + " of " + whose, exercise.motions.student},
                          {"the reference", exercise.motions.reference}},
                         measured);
}

}  // namespace grader::report
