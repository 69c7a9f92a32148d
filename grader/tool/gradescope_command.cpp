// STAFF ONLY. Grades one hand-in as Gradescope lays it down, and packs the grader.
#include "grader/tool/gradescope_command.h"

#include <iostream>

#include "grader/course/input.h"
#include "grader/intake/caged_archive.h"
#include "grader/intake/submission.h"
#include "grader/report/report.h"
#include "grader/tool/gradescope.h"
#include "grader/tool/grading.h"
#include "grader/tool/secret.h"

namespace grader {

int grade_on_gradescope(const GradescopeOptions& options) {
  const Course course = read_course(HAIR_EXERCISES_JSON, options.settings.course);
  GradescopeResults results(options.folder, course, {.pictures = true, .leaderboard = options.leaderboard});
  try {
    const Metadata metadata = read_metadata(options.folder / "submission_metadata.json");
    results.belong_to(metadata);
    GradingSettings settings = settings_of(options.settings);
    const CagedReader reader(HAIR_READER, settings.isolation);
    const Intake intake =
        read_hand_in(options.folder / "submission", metadata.student, course, reader.opener());
    for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
    const Grading grading(std::move(settings));
    const Graded graded = grading.grade(intake.submissions.front(),
                                        [&](const SubmissionResult& so_far) { results.write(so_far); });
    results.write(graded.result);
    for (const std::string& problem : graded.problems)
      std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
    print_table(std::cout, {graded.result});
    return graded.problems.empty() ? 0 : 1;
  } catch (const std::exception&) {
    results.could_not_grade();
    throw;
  }
}

int package_for_gradescope(const GradescopePackage& options) {
  if (options.out.extension() != ".zip")
    throw BadInput("--out " + options.out.string() + ": Gradescope takes a .zip; give it such a name");
  const Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  const HandoutSources sources{HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR};
  write_gradescope_package(sources, options.checks_only ? "" : read_secret(options.secret), course, options);
  std::cout << options.out.string() << "\n";
  if (!options.checks_only) std::cout << advice_for_gradescope(course, options.minutes) << "\n";
  return 0;
}

}  // namespace grader
