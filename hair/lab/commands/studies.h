// hairlab's studies: commands of a separate program, hairlab-study, because it takes minutes to build. It
// lies beside hairlab, and hairlab starts it.
#pragma once

#include <array>
#include <string_view>

namespace hair {

struct StudyCommand {
  const char* name;
  const char* what;  // for --help
};

inline constexpr StudyCommand kSolverStudy = {
    "solver", "Study ConjGrad and the normal equations: error against iterations, products and time"};
inline constexpr StudyCommand kStabilityStudy = {
    "stability",
    "Map the step sizes with which each method is stable, beside theory, and what extreme cases do"};
inline constexpr StudyCommand kErrorStudy = {"study",
                                             "Error against run time, of each method that fits a scene"};
inline constexpr StudyCommand kModelsStudy = {
    "models", "Springs, links and helices side by side: error against run time, which model when"};
inline constexpr StudyCommand kValidation = {
    "validate", "Compare with what theory says: published numbers, exact solutions"};

inline constexpr std::array kStudyCommands = {kSolverStudy, kStabilityStudy, kErrorStudy, kModelsStudy,
                                              kValidation};

bool is_study(std::string_view command);

// Replaces this process by hairlab-study, with the same command line. Returns only if that fails, with the
// exit code. If hairlab-study is missing, or older than hairlab and so out of date, it prints how to build
// it.
int hand_over_to_studies(char* argv[]);

}  // namespace hair
