#include <memory>

#include "hair/lab/commands/study_shell.h"
#include "hair/lab/models/models_record.h"

namespace hair {

namespace {

struct ModelsOptions : ShellOptions {
  std::vector<std::string> hairs;  // none: all
};

int run(const ModelsOptions& options, const Course& course) {
  using namespace model_study;
  if (!course.has("H7"))
    throw BadInput("models: makes the fine motion with H7, which this course leaves out");
  const std::vector<ComparedHair> hairs = chosen(compared_hairs(options.quick), options.hairs, "--hair");
  StudyShell shell(options, "hairlab models", "models.json", {"index.html", "models.csv", "lengths.csv"},
                   WhenInterrupted::loses);
  const auto comparison =
      compare_models(hairs, options.quick, course.absent(), shell.interrupted(), shell.teller());
  if (comparison)
    shell.keep(models_json(*comparison), models_page(*comparison),
               {{"models.csv", model_rows(*comparison)}, {"lengths.csv", length_rows(*comparison)}});
  return shell.end(comparison.has_value());
}

}  // namespace

Command add_models_command(CLI::App& program) {
  const auto options = std::make_shared<ModelsOptions>();
  CLI::App* app =
      add_study(program, kModelsStudy, *options, "fewer elements and steps, and a coarser fine motion");
  app->add_option("--hair", options->hairs, "Which: straight, wavy, curly, uncoiling (default: all)");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
