// STAFF ONLY. costs.html: where the time of grading went, the most expensive first, beside the reference. It has
// times, so it differs from run to run. It knows no exercise and no kind of cost by name.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace grader {

// What a submission costs is the sum of its wall_seconds; the other columns are parts of these.
enum class CostKind { wall_seconds, cpu_seconds, count };

struct CostColumn {
  std::string heading, explanation;
  CostKind kind = CostKind::cpu_seconds;
};

// By exercise, or another part such as the end-to-end runs: a value for each column.
using CostsByPart = std::map<std::string, std::vector<double>>;

struct Costs {
  std::vector<CostColumn> columns;
  CostsByPart reference;
  std::map<std::string, CostsByPart> submissions;  // by name
};

std::string costs_page(const Costs& costs);

}  // namespace grader
