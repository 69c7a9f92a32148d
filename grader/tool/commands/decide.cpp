// STAFF ONLY. `hairgrade set`, `excuse`, `late-days` and `unset`: decisions of people, which
// survive each regrade.
#include <iostream>

#include "grader/course/input.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct DecideOptions : OfARecord {
  Decision decision;
  std::string kind = "points";
};

int decide(const DecideOptions& options) {
  return change_record(options, [&](Record& record) { record.decide(options.name, options.decision); });
}

CLI::App* add(CLI::App& hairgrade, const char* name, const char* help, DecisionKind kind,
              const std::shared_ptr<DecideOptions>& options) {
  options->decision.kind = kind;
  CLI::App* command = hairgrade.add_subcommand(name, help);
  add_name(*command, *options);
  add_folder(*command, *options);
  return command;
}

void add_place(CLI::App& command, DecideOptions& options, bool needed) {
  command.add_option("PLACE", options.decision.place, "An exercise, \"H2\", or its third category, \"H2.3\"")
      ->required(needed);
}

void add_why(CLI::App& command, DecideOptions& options) {
  command.add_option("--why", options.decision.why, "The reason; the student sees it")->required();
}

}  // namespace

Command add_set(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command =
      add(hairgrade, "set", "Set points of an exercise or a category", DecisionKind::points, options);
  add_place(*command, *options, true);
  command->add_option("POINTS", options->decision.number, "So many")->required();
  add_why(*command, *options);
  return {command, [options] { return decide(*options); }};
}

Command add_excuse(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command = add(hairgrade, "excuse", "Let an exercise, or all, not count for a student",
                          DecisionKind::excuse, options);
  add_place(*command, *options, false);
  add_why(*command, *options);
  return {command, [options] { return decide(*options); }};
}

Command add_late_days(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command =
      add(hairgrade, "late-days", "Give a student more days", DecisionKind::late_days, options);
  command->add_option("DAYS", options->decision.number, "So many")->required();
  add_why(*command, *options);
  return {command, [options] { return decide(*options); }};
}

Command add_unset(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command = hairgrade.add_subcommand("unset", "Take a decision back");
  add_name(*command, *options);
  add_place(*command, *options, false);
  add_folder(*command, *options);
  command->add_option("--kind", options->kind, "points (the default), excuse, comment or late-days")
      ->check(CLI::IsMember({"points", "excuse", "comment", "late-days"}));
  return {command, [options] {
            return change_record(*options, [&](Record& record) {
              record.undo(options->name, *decision_kind_from(options->kind), options->decision.place);
            });
          }};
}

}  // namespace grader::tool
