// STAFF ONLY. `hairgrade samples`: tells of the sample class and the attacks.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/course/input.h"
#include "grader/samples/promises.h"
#include "grader/samples/table.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader {
namespace {

struct SamplesOptions {
  bool promises = false;
  std::vector<std::filesystem::path> graded;
};

FailedCase failed_case_of(const CaseResult& one) {
  // Trial puts the description of a case in front of its numbers.
  const std::string input = one.detail.substr(0, one.detail.find(": "));
  return {input, one.feedback + (one.hint.empty() ? "" : ". " + one.hint)};
}

FindFailedCase in_gradings(const std::vector<std::filesystem::path>& folders) {
  auto records = std::make_shared<std::vector<std::unique_ptr<Record>>>();
  for (const std::filesystem::path& folder : folders) records->push_back(open_record(folder, ""));
  return [records](const Sample& sample, const std::string& exercise) {
    const std::vector<std::string>& lost = sample.expected.at(exercise).failed;
    for (const std::unique_ptr<Record>& record : *records) {
      const std::optional<Recorded> recorded = record->find(sample.name);
      if (!recorded) continue;
      for (const ExerciseResult& result : recorded->result.exercises) {
        if (result.id != exercise) continue;
        if (lost.empty()) return FailedCase{"", result.feedback};
        for (const CaseResult& one : result.cases)
          if (one.name == lost[0] && one.status != Status::passed) return failed_case_of(one);
      }
    }
    throw BadInput("sample " + sample.name + ": loses nothing of what it should in " + exercise +
                   ", in no folder of --graded; grade it again");
  };
}

int tell(const SamplesOptions& options) {
  const std::vector<Sample> samples = read_samples(HAIR_SOURCE_DIR);
  if (!options.promises)
    std::cout << table_of(samples);
  else
    std::cout << table_of(promises_of(HAIR_SOURCE_DIR, samples),
                          options.graded.empty() ? FindFailedCase() : in_gradings(options.graded));
  return 0;
}

}  // namespace

Command add_samples(CLI::App& hairgrade) {
  CLI::App* command = hairgrade.add_subcommand("samples", "Tell of the sample class and the attacks");
  const auto options = std::make_shared<SamplesOptions>();
  CLI::Option_group* tables = command->add_option_group("tables");
  tables->add_flag_callback(
      "--table", [] {}, "Print what each sample shows and gets, as Markdown");
  CLI::Option* promises = tables->add_flag(
      "--promises", options->promises,
      "Print what the exercises' headers promise, and the samples that lose points for ignoring it");
  tables->require_option(1);
  command
      ->add_option("--graded", options->graded,
                   "Folders of grades of the sample class: print the inputs that showed it, too")
      ->needs(promises);
  return {command, [options] { return tell(*options); }};
}

}  // namespace grader
