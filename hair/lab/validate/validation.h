// Validation: compares the exercises' code with theory and published numbers about hair and the methods that
// move it.
//
//   validation ──▶ checks: a known number, a measured one, and the difference that the theory allows
//              └─▶ figures and tables: the error against n, h, ...
//
// A validation lists the exercises that it calls, so that it can run before the others are written. Each
// validation has its own file; validations.cpp lists them.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "hair/io/plot/figure.h"
#include "hair/io/plot/page.h"

namespace hair {

// A check holds if |measured - expected| <= tolerance; it fails if one of these numbers is not finite.
struct Check {
  std::string id;      // unique in its validation: letters, digits, hyphens: "n10-mode1"
  std::string shows;   // a line: "10 masses, mode 1: l w^2 / g"
  std::string source;  // the source of `expected`: a published number, or a theory with its citation
  double expected = 0;
  double measured = 0;
  double tolerance = 0;
  std::string tolerance_from;  // how the tolerance is derived: "amplitude^2 / 16 + ..."
  std::string unit = {};       // none: a ratio

  double error() const { return measured - expected; }
  bool holds() const;
};

struct ValidationResult {
  std::vector<Check> checks;
  std::vector<Figure> figures = {};
  std::vector<Table> tables = {};
};

// Thrown by a validation that was interrupted.
struct Interrupted {};

struct ValidationSettings {
  bool quick = false;  // fewer and coarser runs: at most a second for each validation
  const std::atomic<bool>* interrupted = nullptr;

  // Throws Interrupted after Ctrl-C. Must be called at least every tenth of a second.
  void go_on() const;
};

// A validation throws NotImplemented if an exercise is a stub; any other exception counts as a failed
// validation.
struct Validation {
  std::string id;                      // "chain-h6"
  std::string title;                   // a line
  std::vector<std::string> exercises;  // the exercises that it calls: "S1", ...
  std::function<ValidationResult(const ValidationSettings&)> run;
};

// The validations that call none of the `absent` exercises, in the order of display.
std::vector<Validation> all_validations(const std::vector<std::string>& absent);

}  // namespace hair
