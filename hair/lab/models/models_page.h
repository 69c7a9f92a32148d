// A comparison of strand models as tables, and as a page with figures.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/page.h"
#include "hair/lab/models/comparison.h"

namespace hair::model_study {

// The runs that no other run of the family beats in both error and time, in the order of time.
std::vector<const ModelRun*> best_of(const FamilyRuns& family);

// All runs, of all families: for models.csv.
Table table_of_runs(const Comparison& comparison);

// The length of straight hair over time: for lengths.csv. Empty: no run reached its end.
Table table_of_lengths(const Comparison& comparison);

Page models_page(const Comparison& comparison, const std::string& machine);

}  // namespace hair::model_study
