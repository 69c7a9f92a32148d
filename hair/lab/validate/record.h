// What validations found, as text for a terminal, a page, JSON and CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hair/lab/validate/validation.h"

namespace hair {

// How every validate.json begins.
inline constexpr std::string_view kValidationJsonBegin = "{\n \"format\": \"hairlab validate 1\"";

struct ValidationRecord {
  std::string id, title;
  std::vector<std::string> exercises;
  ValidationResult result;
  std::string left_out = {};  // not run: the exercise that is not written yet, with its file and function
  std::string broke = {};     // what was thrown on the way
  double cpu_seconds = 0;

  bool ran() const { return left_out.empty(); }
  bool holds() const;  // it ran, and all of its checks hold
};

// "41 of 42 checks hold; 1 of 9 validations broke; 2 of 9 validations are left out": what broke or was left
// out has no checks.
std::string summary(const std::vector<ValidationRecord>& records);

// A line for each check in aligned columns, with a heading, for a terminal of 120 columns.
std::string terminal_text(const ValidationRecord& record);

// All checks of all validations, a row each; and a row for each validation that broke or was left out.
Table table_of_checks(const std::vector<ValidationRecord>& records);

// `machine`: on which times were measured (hair/io/machine.h).
Page page_of(const std::vector<ValidationRecord>& records, bool quick, const std::string& machine);

// validate.json: all of it but the figures. `measured` is null where it is not finite. All but "cpu_seconds"
// and "times" is the same whenever the same is run again.
std::string json_of(const std::vector<ValidationRecord>& records, bool quick, const std::string& machine);

}  // namespace hair
