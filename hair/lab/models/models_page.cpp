#include "hair/lab/models/models_record.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/work_precision.h"

namespace hair::model_study {

namespace {

// Errors for which the cheapest run is looked up, m.
constexpr double kErrors[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

std::string note_of(const ModelRun& run) {
  const std::string note = std::to_string(run.elements) + " elements, h = " + step_text(run.step) + " s";
  return run.trouble.empty() ? note : note + ": " + run.trouble;
}

Point point_of(const ModelRun& run) {
  Point point{std::max(run.seconds, 1e-9), run.error, note_of(run)};
  point.failed = !run.trouble.empty();
  return point;
}

std::vector<const ModelRun*> all_of(const FamilyRuns& family) {
  std::vector<const ModelRun*> all;
  for (const ModelRun& run : family.runs) all.push_back(&run);
  return all;
}

// A series for each family that has such runs.
Figure figure_of(const std::vector<FamilyRuns>& families,
                 std::vector<const ModelRun*> (*runs_of)(const FamilyRuns&), const std::string& id,
                 const std::string& title, const std::string& description) {
  Figure figure{id,
                title,
                description,
                {"CPU time for a second of motion, s"},
                {"RMS distance from the fine motion, m"}};
  for (std::size_t i = 0; i < families.size(); ++i) {
    Series series{families[i].family.name, {}};
    series.look = static_cast<int>(i);
    for (const ModelRun* run : runs_of(families[i])) series.points.push_back(point_of(*run));
    if (!series.points.empty()) figure.series.push_back(std::move(series));
  }
  return figure;
}

const ModelRun* run_of(const FamilyRuns& family, int elements) {
  for (const ModelRun& run : family.runs)
    if (run.elements == elements && run.trouble.empty()) return &run;
  return nullptr;
}

Figure length_figure(const HairComparison& one) {
  const int elements = one.hair.elements[one.hair.elements.size() / 2];
  Figure figure{"length-against-time",
                "Length of straight hair at h = 1/60 s, " + std::to_string(elements) + " elements",
                "How much longer the hair is than at rest, step by step.",
                {"time, s", false, 0.0, kComparedTime},
                {"length over that at rest, minus 1", false}};
  for (const FamilyRuns& family : one.stiff) {
    const ModelRun* run = run_of(family, elements);
    if (!run) continue;
    Series series{family.family.name, {{0, 0}}};
    for (std::size_t k = 0; k < run->lengths.size(); ++k)
      series.points.push_back({static_cast<double>(k + 1) * run->step, run->lengths[k] - 1, {}});
    figure.series.push_back(std::move(series));
  }
  return figure;
}

// For each family the time of its cheapest run below an error.
Table cheapest(const HairComparison& one) {
  Table table{"Milliseconds of CPU time for a second of motion, of the cheapest run with at most this error",
              {"error"},
              {}};
  for (const FamilyRuns& family : one.families)
    if (family.left_out.empty()) table.header.emplace_back(family.family.name);
  for (const double error : kErrors) {
    std::vector<std::string> row = {to_text(1e3 * error) + " mm"};
    for (const FamilyRuns& family : one.families) {
      if (!family.left_out.empty()) continue;
      std::string text = "-";
      for (const ModelRun* run : best_of(family))
        if (run->error <= error) {
          text = to_text(1e3 * run->seconds) + " (" + std::to_string(run->elements) + ", " +
                 step_text(run->step) + ")";
          break;
        }
      row.push_back(text);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

// All runs, and what is left out.
void add_runs(const std::vector<FamilyRuns>& families, Section& section) {
  std::string left_out;
  for (const FamilyRuns& family : families) {
    if (!family.left_out.empty())
      left_out +=
          (left_out.empty() ? "Left out: " : "; ") + std::string(family.family.name) + ", " + family.left_out;
    add_table(section.tables, rows_of(family.runs, row_of_run), family.family.name);
  }
  if (!left_out.empty()) section.paragraphs.push_back(left_out + ".");
}

Section section_of(const HairComparison& one) {
  Section section;
  section.heading = one.hair.title;
  section.paragraphs = {"The fine motion comes from chains of " + std::to_string(one.hair.fine) + " and " +
                        std::to_string(2 * one.hair.fine) + " rigid links. It is known to " +
                        to_text(1e3 * one.uncertainty) + " mm, and took " + to_text(one.fine_seconds) +
                        " s of CPU time. In the table, brackets hold the elements and the step."};
  section.first = {cheapest(one)};
  Figure figure = figure_of(
      one.families, best_of, "error-against-time-" + one.hair.id, one.hair.title + ": error against run time",
      "For each model and method its best runs: no other number of elements or step has both a smaller error "
      "and a shorter time. Both axes are logarithmic. The lower and the further left, the better.");
  add_level(figure, "what the fine motion knows", one.uncertainty);
  section.figures = {to_svg(figure)};
  add_runs(one.families, section);
  return section;
}

Section cost_section(const std::vector<HelixCost>& costs) {
  Figure figure{"helix-cost",
                "Super-helices: what a step costs against the number of elements",
                "CPU time of helix_step, and of mass_matrix, which makes a table that grows with the square.",
                {"elements"},
                {"CPU time, s"},
                {{"helix_step", {}}, {"mass_matrix", {}}},
                {{1, "slope 1"}, {2, "slope 2"}, {3, "slope 3"}}};
  for (const HelixCost& one : costs) {
    figure.series[0].points.push_back({static_cast<double>(one.elements), one.step, {}});
    figure.series[1].points.push_back({static_cast<double>(one.elements), one.mass_matrix, {}});
  }
  return {"What a helix costs",
          {"A curl with a turn in each element. A step that goes through the elements from the tip to the "
           "root and back grows "
           "with their number, slope 1. One that makes the matrix grows with its square at least, and one "
           "that factors it with the "
           "third power, once there are many."},
          {to_svg(figure)},
          {table_of(rows_of(costs, row_of_cost), "Microseconds")}};
}

Section stiff_section(const HairComparison& one) {
  Section section;
  section.heading = "K = infinity: stiff springs, or links?";
  section.paragraphs = {
      "Straight hair with one step each sixtieth of a second. With the filtered geometric term springs hold "
      "back a hair that wants "
      "to turn, and the stiffer they are, the more. Without the term it turns freely, and stretches, "
      "whatever their stiffness. "
      "Links keep their lengths with any step."};
  section.figures = {to_svg(figure_of(one.stiff, all_of, "stiff-error-against-time",
                                      "Straight hair at h = 1/60 s: error against run time",
                                      "Springs of hair's own EA, of 100 and of 10,000 times as much, and "
                                      "rigid links, each with several numbers of elements.")),
                     to_svg(length_figure(one))};
  add_runs(one.stiff, section);
  return section;
}

}  // namespace

std::vector<const ModelRun*> best_of(const FamilyRuns& family) {
  std::vector<const ModelRun*> finished, best;
  std::vector<Sample> samples;
  for (const ModelRun& run : family.runs)
    if (run.trouble.empty()) {
      finished.push_back(&run);
      samples.push_back({run.seconds, run.error});
    }
  for (const std::size_t i : best_of(samples)) best.push_back(finished[i]);
  return best;
}

Page models_page(const Comparison& comparison) {
  Page page;
  page.title = "Which strand model, when?";
  page.paragraphs = {
      "The same hair by springs, rigid links and super-helices, with several numbers of elements and several "
      "steps: how far it is from the motion of an inextensible rod, and what it costs.",
      "20 cm of human hair, clamped, fall from their rest shape for " + to_text(kComparedTime) +
          " s. The error is the root mean square distance of points at " + std::to_string(kMoments) +
          " moments."};
  for (const HairComparison& one : comparison.hairs) page.sections.push_back(section_of(one));
  for (const HairComparison& one : comparison.hairs)
    if (!one.stiff.empty()) page.sections.push_back(stiff_section(one));
  if (!comparison.helix_costs.empty()) page.sections.push_back(cost_section(comparison.helix_costs));
  return page;
}

}  // namespace hair::model_study
