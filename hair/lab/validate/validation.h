// Truth from outside: what theory says of hair and of the methods that move it, beside what the exercises'
// code does.
//
//   validation ──▶ checks: a number that is known, one that was measured, and how far apart the theory lets them be
//              └─▶ figures and tables: the error against n, h, ...
//
// A validation lists the exercises that it calls, so that one can be run before all of them are written. Each
// has a file; validations.cpp is their list.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "hair/io/plot/figure.h"
#include "hair/io/plot/page.h"

namespace hair {

// It holds if |measured - expected| <= tolerance; of numbers that are not finite nothing does.
struct Check {
  std::string id;      // unique in its validation: letters, digits, hyphens: "n10-mode1"
  std::string shows;   // a line: "10 masses, mode 1: l w^2 / g"
  std::string source;  // where `expected` is from: a published number, a theory, with its citation
  double expected = 0;
  double measured = 0;
  double tolerance = 0;
  std::string tolerance_from;  // why so much: "amplitude^2 / 16 + ..."
  std::string unit = {};       // none: a ratio

  double error() const { return measured - expected; }
  bool holds() const;
};

struct ValidationResult {
  std::vector<Check> checks;
  std::vector<Figure> figures = {};
  std::vector<Table> tables = {};
  std::vector<Table> times = {};  // with CPU times: no second run finds the same
};

// As printf writes it: "%.9g".
std::string printed(const char* format, double value);

// Of a figure with a logarithmic axis: an error that it can't show is one that failed.
Point error_point(double x, double error, std::string note = {});

// Thrown out of a validation that was told to stop.
struct Interrupted {};

struct ValidationSettings {
  bool quick = false;  // fewer and coarser: a second at most for each validation
  const std::atomic<bool>* interrupted = nullptr;

  // Throws Interrupted once Ctrl-C was pressed: called every tenth of a second or more often.
  void go_on() const;
};

// A validation throws NotImplemented if an exercise is a stub; whatever else it throws counts as one that
// does not hold.
struct Validation {
  std::string id;                      // "chain-h6"
  std::string title;                   // a line
  std::vector<std::string> exercises;  // what it calls: "S1", ...
  std::function<ValidationResult(const ValidationSettings&)> run;
};

// All whose exercises the course has, in the order in which they are shown.
std::vector<Validation> all_validations();

}  // namespace hair
