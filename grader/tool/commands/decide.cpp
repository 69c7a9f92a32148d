// STAFF ONLY. `hairgrade set`, `excuse`, `late-days`, `hold`, `unset` and `unhold`: decisions of people,
// which survive each regrade.
#include <iostream>

#include "grader/course/input.h"
#include "grader/report/facts/text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct DecideOptions : OfARecord {
  Decision decision;
  std::string kind = "points";
};

// Writes "H2.3 1.5, 20 of 200 points".
std::string points_in(Record& record, const std::string& name, const std::string& place) {
  const std::optional<Recorded> found = record.find_decided(name);
  if (!found) return "no points";
  const std::optional<double> here = points_at(found->result, place);
  return (here ? place + " " + shown_points(*here) + ", " : "") + shown_points(points(found->result)) +
         " of " + shown_points(max_points(found->result)) + " points";
}

// Prints the points before and after.
int change_decisions(const DecideOptions& options,
                     const std::function<void(Record&, const std::string& name)>& change) {
  return change_record(options, [&](Record& record, const std::string& name) {
    const std::string& place = options.decision.place;
    const std::string who = called(name, record.names_for_people());
    const std::string before = points_in(record, name, place);
    change(record, name);
    std::cout << who << ": " << before << " -> " << points_in(record, name, place) << "\n";
  });
}

int decide(const DecideOptions& options) {
  return change_decisions(
      options, [&](Record& record, const std::string& name) { record.decide(name, options.decision); });
}

int undo(const DecideOptions& options) {
  return change_decisions(options, [&](Record& record, const std::string& name) {
    record.undo(name, *decision_kind_from(options.kind), options.decision.place);
  });
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

void add_why(CLI::App& command, DecideOptions& options,
             const char* help = "The reason; the student sees it") {
  command.add_option("--why", options.decision.why, help)->required();
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
  return {command, [options] { return undo(*options); }};
}

Command add_hold(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command =
      add(hairgrade, "hold", "Keep a student out of gradebooks and feedback", DecisionKind::hold, options);
  add_why(*command, *options, "The reason, for staff alone");
  return {command, [options] { return decide(*options); }};
}

Command add_unhold(CLI::App& hairgrade) {
  const auto options = std::make_shared<DecideOptions>();
  CLI::App* command =
      add(hairgrade, "unhold", "Let a student have grade and feedback again", DecisionKind::hold, options);
  options->kind = to_string(DecisionKind::hold);
  return {command, [options] { return undo(*options); }};
}

}  // namespace grader::tool
