#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/io/machine.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/models/models_page.h"
#include "hair/lab/models/models_record.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_folder.h"

namespace hair {

namespace {

struct ModelsOptions {
  std::filesystem::path out;
  std::vector<std::string> hairs;  // none: all
  bool quick = false;
};

std::vector<model_study::ComparedHair> chosen(const ModelsOptions& options) {
  std::vector<model_study::ComparedHair> all = model_study::compared_hairs(options.quick);
  std::string known;
  for (const auto& one : all) known += (known.empty() ? "" : ", ") + one.id;
  for (const std::string& id : options.hairs)
    if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.id == id; }))
      throw BadInput("--hair: there is no \"" + printable(id) + "\"; there are " + known);
  if (!options.hairs.empty())
    std::erase_if(all, [&](const auto& one) {
      return std::find(options.hairs.begin(), options.hairs.end(), one.id) == options.hairs.end();
    });
  return all;
}

const OutputKind& models_output() {
  static const OutputKind kind = {"hairlab models",
                                  "models.json",
                                  model_study::kModelsRecordBegin,
                                  {"index.html", "models.csv", "lengths.csv"}};
  return kind;
}

int run(const ModelsOptions& options, const Course& course) {
  if (!course.has("H7"))
    throw BadInput("models: makes the fine motion with H7, which this course leaves out");
  const std::vector<model_study::ComparedHair> hairs = chosen(options);
  const std::atomic<bool>& interrupted = catch_interruption("\nhairlab: stopping; once more ends at once\n");
  OutputFolder folder(options.out, models_output());
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto say = [&](const std::string& what) {
    if (terminal) std::cerr << "\r\x1b[K" << what << std::flush;
  };
  const auto comparison =
      model_study::compare_models(hairs, options.quick, course.absent(), interrupted, say);
  say("");
  if (!comparison) {
    std::cerr << "hairlab: interrupted; nothing is written\n";
    return kInterrupted;
  }
  const std::string machine = measured_on(this_machine());
  write_file(folder.now("models.json"), model_study::models_json(*comparison, machine));
  write_file(folder.now("models.csv"), to_csv(model_study::table_of_runs(*comparison)));
  write_file(folder.now("lengths.csv"), to_csv(model_study::table_of_lengths(*comparison)));
  write_file(folder.now("index.html"), to_html(model_study::models_page(*comparison, machine)));
  folder.keep();
  std::cout << (folder.path() / "index.html").string() << "\n";
  return 0;
}

}  // namespace

Command add_models_command(CLI::App& program) {
  const auto options = std::make_shared<ModelsOptions>();
  CLI::App* app = program.add_subcommand(kModelsStudy.name, kModelsStudy.what);
  app->add_option("--out", options->out, "The folder for page, JSON and CSV")->required();
  app->add_option("--hair", options->hairs, "Which: straight, wavy, curly, uncoiling (default: all)");
  app->add_flag("--quick", options->quick, "Fewer elements and steps, and a coarser fine motion");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
