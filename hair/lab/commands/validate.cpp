#include <iostream>
#include <memory>

#include "hair/lab/commands/study_shell.h"
#include "hair/lab/run/stub.h"
#include "hair/lab/validate/record.h"
#include "solver/timing.h"

namespace hair {

namespace {

struct ValidateOptions : ShellOptions {
  std::vector<std::string> ids;
  bool list = false;
};

int list_validations(const Course& course) {
  for (const Validation& one : all_validations(course.absent()))
    std::cout << one.id << ": " << one.title << " (" << calls(one.exercises) << ")\n";
  return 0;
}

// Throws Interrupted.
ValidationRecord run_one(const Validation& one, const ValidationSettings& settings) {
  ValidationRecord record{one.id, one.title, one.exercises, {}};
  const double start = timing::cpu_seconds();
  try {
    record.result = one.run(settings);
  } catch (const NotImplemented& stub) {
    record.left_out = missing_part(stub);
  } catch (const std::exception& error) {
    record.broke = printable(error.what(), 500);
  }
  record.cpu_seconds = timing::cpu_seconds() - start;
  return record;
}

int run(const ValidateOptions& options, const Course& course) {
  if (options.list) return list_validations(course);
  const std::vector<Validation> validations =
      chosen(all_validations(course.absent()), options.ids, "validate");
  StudyShell shell(options, "hairlab validate", "validate.json", {"index.html", "validate.csv"},
                   WhenInterrupted::keeps);
  const ValidationSettings settings{options.quick, &shell.interrupted()};

  std::vector<ValidationRecord> records;
  for (const Validation& one : validations) {
    shell.say(std::to_string(records.size() + 1) + " of " + std::to_string(validations.size()) + ": " +
              one.id);
    std::optional<ValidationRecord> record;
    try {
      record = run_one(one, settings);
    } catch (const Interrupted&) {
    }
    shell.say("");
    if (!record) break;
    std::cout << terminal_text(*record) << std::flush;
    records.push_back(std::move(*record));
  }
  if (options.writes && !records.empty())
    shell.keep(json_of(records), page_of(records), {{"validate.csv", check_rows(records)}});
  if (const int code = shell.end(records.size() == validations.size()); code != 0) return code;

  const bool all_hold =
      std::ranges::all_of(records, [](const ValidationRecord& one) { return !one.ran() || one.holds(); });
  // Validations that call no exercise need no stub's message.
  const bool none_called = std::ranges::all_of(
      records, [](const ValidationRecord& one) { return !one.ran() || one.exercises.empty(); });
  const auto stub = std::ranges::find_if(records, [](const ValidationRecord& one) { return !one.ran(); });
  if (stub != records.end() && none_called && all_hold) {
    std::cerr << "hairlab: this needs " << stub->left_out << "\n";
    return kNotWritten;
  }
  std::cout << summary(records) << "\n";
  return all_hold ? 0 : kBroke;
}

}  // namespace

Command add_validate_command(CLI::App& program) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* app =
      add_study(program, kValidation, *options, "fewer and coarser: seconds instead of a minute", false);
  app->add_option("ID", options->ids, "Which (default: all)");
  app->add_flag("--list", options->list, "Say which there are, and the exercises that they call");
  app->final_callback([options, app] { options->writes = app->count("--out") > 0; });
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
