// A comparison of strand models: for programs to read, as tables, and as a page with figures.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/lab/models/comparison.h"

namespace hair::model_study {

std::string step_text(double step);  // s: "1/60"
Row row_of_run(const ModelRun& run);
Row row_of_cost(const HelixCost& cost);

// models.csv: all runs, of all families. lengths.csv: the length of straight hair over time.
std::vector<Row> model_rows(const Comparison& comparison);
std::vector<Row> length_rows(const Comparison& comparison);

OrderedJson models_json(const Comparison& comparison);

// The runs that no other run of the family beats in both error and time, in the order of time.
std::vector<const ModelRun*> best_of(const FamilyRuns& family);

Page models_page(const Comparison& comparison);

}  // namespace hair::model_study
