// The results of validations, as text for a terminal, a page, JSON and CSV.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/lab/validate/validation.h"

namespace hair {

struct ValidationRecord {
  std::string id, title;
  std::vector<std::string> exercises;
  ValidationResult result;
  std::string left_out = {};  // not run: the exercise that is a stub, with its file and function
  std::string broke = {};     // the message of an exception
  double cpu_seconds = 0;

  bool ran() const { return left_out.empty(); }
  bool holds() const;  // it ran, and all of its checks hold
};

std::string calls(const std::vector<std::string>& exercises);  // "S1, H1"; or "no exercise"

// "41 of 42 checks hold; 1 of 9 validations broke; 2 of 9 validations are left out": a validation that broke
// or was left out has no checks.
std::string summary(const std::vector<ValidationRecord>& records);

// One line for each check in aligned columns, with a heading, for a terminal of 120 columns.
std::string terminal_text(const ValidationRecord& record);

// validate.csv: one row for each check of all validations, and one for each validation that broke or was left
// out.
std::vector<Row> check_rows(const std::vector<ValidationRecord>& records);

Page page_of(const std::vector<ValidationRecord>& records);

// validate.json: everything except the figures. `measured` is null if it is not finite. Equal runs give equal
// text, except for "cpu_seconds".
OrderedJson json_of(const std::vector<ValidationRecord>& records);

}  // namespace hair
