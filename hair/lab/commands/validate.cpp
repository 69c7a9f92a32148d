#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/io/machine.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/stub.h"
#include "hair/lab/validate/record.h"
#include "solver/timing.h"

namespace hair {

namespace {

struct ValidateOptions {
  std::vector<std::string> ids;
  bool quick = false, list = false, writes = false;
  std::filesystem::path out;
};

int list_validations(const Course& course) {
  for (const Validation& one : all_validations(course.absent())) {
    std::string exercises;
    for (const std::string& id : one.exercises) exercises += (exercises.empty() ? "" : ", ") + id;
    std::cout << one.id << ": " << one.title << " (" << (exercises.empty() ? "no exercise" : exercises)
              << ")\n";
  }
  return 0;
}

// Those that are asked for, in the list's order; all, if none is.
std::vector<Validation> chosen(const std::vector<std::string>& ids, const Course& course) {
  std::vector<Validation> all = all_validations(course.absent());
  std::string known;
  for (const Validation& one : all) known += (known.empty() ? "" : ", ") + one.id;
  for (const std::string& id : ids)
    if (std::none_of(all.begin(), all.end(), [&](const Validation& one) { return one.id == id; }))
      throw BadInput("there is no validation \"" + printable(id) + "\"; there are " + known);
  if (!ids.empty())
    std::erase_if(
        all, [&](const Validation& one) { return std::find(ids.begin(), ids.end(), one.id) == ids.end(); });
  return all;
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

const OutputKind& validate_output() {
  static const OutputKind kind{
      "hairlab validate", "validate.json", kValidationJsonBegin, {"index.html", "validate.csv"}};
  return kind;
}

void write_results(OutputFolder& folder, const std::vector<ValidationRecord>& records, bool quick) {
  write_file(folder.now("validate.csv"), to_csv(table_of_checks(records)));
  const std::string machine = measured_on(this_machine());
  write_file(folder.now("index.html"), to_html(page_of(records, quick, machine)));
  write_file(folder.now("validate.json"), json_of(records, quick, machine));
  folder.keep();
  std::cout << folder.then("index.html").string() << "\n";
}

int run(const ValidateOptions& options, const Course& course) {
  if (options.list) return list_validations(course);
  const std::vector<Validation> validations = chosen(options.ids, course);
  const std::atomic<bool>& interrupted = catch_interruption("\nhairlab: stopping; once more ends at once\n");
  const ValidationSettings settings{options.quick, &interrupted};
  std::optional<OutputFolder> folder;
  if (options.writes) folder.emplace(options.out, validate_output());
  const bool terminal = isatty(STDERR_FILENO) != 0;

  std::vector<ValidationRecord> records;
  for (const Validation& one : validations) {
    if (terminal)
      std::cerr << "\r\x1b[K" << records.size() + 1 << " of " << validations.size() << ": " << one.id
                << std::flush;
    std::optional<ValidationRecord> record;
    try {
      record = run_one(one, settings);
    } catch (const Interrupted&) {
    }
    if (terminal) std::cerr << "\r\x1b[K" << std::flush;
    if (!record) break;
    std::cout << terminal_text(*record) << std::flush;
    records.push_back(std::move(*record));
  }
  if (folder && !records.empty()) write_results(*folder, records, options.quick);
  if (records.size() < validations.size()) {
    std::cerr << "hairlab: interrupted after " << records.size() << " of " << validations.size()
              << " validations\n";
    return kInterrupted;
  }

  const bool all_hold = std::all_of(records.begin(), records.end(),
                                    [](const ValidationRecord& one) { return !one.ran() || one.holds(); });
  // What calls no exercise says nothing of them.
  const bool none_called = std::all_of(records.begin(), records.end(), [](const ValidationRecord& one) {
    return !one.ran() || one.exercises.empty();
  });
  const auto stub =
      std::find_if(records.begin(), records.end(), [](const ValidationRecord& one) { return !one.ran(); });
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
  CLI::App* app = program.add_subcommand(kValidation.name, kValidation.what);
  app->add_option("ID", options->ids, "Which (default: all)");
  app->add_flag("--list", options->list, "Say which there are, and the exercises that they call");
  app->add_flag("--quick", options->quick, "Fewer and coarser: seconds instead of a minute");
  CLI::Option* out = app->add_option("--out", options->out, "A folder for the same as page, CSV and JSON");
  app->final_callback([options, out] { options->writes = out->count() > 0; });
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
