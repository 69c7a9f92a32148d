#include "hair/lab/models/models_page.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/figure.h"

namespace hair::model_study {

namespace {

// Errors for which the cheapest run is looked up, m.
constexpr double kErrors[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4};

std::string step_text(double step) {
  const double inverse = std::round(1 / step);
  return std::abs(step * inverse - 1) < 1e-9 ? "1/" + to_text(inverse) : to_text(step);
}

std::string note_of(const ModelRun& run) {
  const std::string note = std::to_string(run.elements) + " elements, h = " + step_text(run.step) + " s";
  return run.trouble.empty() ? note : note + ": " + run.trouble;
}

Point point_of(const ModelRun& run) {
  Point point{std::max(run.seconds, 1e-9), run.error, note_of(run)};
  point.failed = !run.trouble.empty();
  return point;
}

Figure error_figure(const HairComparison& one) {
  Figure figure;
  figure.id = "error-against-time-" + one.hair.id;
  figure.title = one.hair.title + ": error against run time";
  figure.description =
      "For each model and method its best runs: no other number of elements or step has both a smaller error "
      "and a shorter time. Both axes are logarithmic. The lower and the further left, the better.";
  figure.x.title = "CPU time for a second of motion, s";
  figure.y.title = "RMS distance from the fine motion, m";
  double low = 0, high = 0;
  for (std::size_t i = 0; i < one.families.size(); ++i) {
    Series series;
    series.name = one.families[i].family.name;
    series.look = static_cast<int>(i);
    for (const ModelRun* run : best_of(one.families[i])) series.points.push_back(point_of(*run));
    if (series.points.empty()) continue;
    low = low == 0 ? series.points.front().x : std::min(low, series.points.front().x);
    high = std::max(high, series.points.back().x);
    figure.series.push_back(std::move(series));
  }
  if (high > 0)
    figure.series.push_back({"what the fine motion knows",
                             {{low, one.uncertainty, {}}, {high, one.uncertainty, {}}},
                             true,
                             false,
                             true,
                             {}});
  return figure;
}

Figure stiff_figure(const HairComparison& one) {
  Figure figure;
  figure.id = "stiff-error-against-time";
  figure.title = "Straight hair at h = 1/60 s: error against run time";
  figure.description =
      "Springs of hair's own EA, of 100 and of 10,000 times as much, and rigid links, each with several "
      "numbers of elements.";
  figure.x.title = "CPU time for a second of motion, s";
  figure.y.title = "RMS distance from the fine motion, m";
  for (const FamilyRuns& family : one.stiff) {
    Series series;
    series.name = family.family.name;
    for (const ModelRun& run : family.runs) series.points.push_back(point_of(run));
    if (!series.points.empty()) figure.series.push_back(std::move(series));
  }
  return figure;
}

const ModelRun* run_of(const FamilyRuns& family, int elements) {
  for (const ModelRun& run : family.runs)
    if (run.elements == elements && run.trouble.empty()) return &run;
  return nullptr;
}

int elements_for_lengths(const HairComparison& one) {
  return one.hair.elements[one.hair.elements.size() / 2];
}

Figure length_figure(const HairComparison& one) {
  Figure figure;
  const int elements = elements_for_lengths(one);
  figure.id = "length-against-time";
  figure.title = "Length of straight hair at h = 1/60 s, " + std::to_string(elements) + " elements";
  figure.description = "How much longer the hair is than at rest, step by step.";
  figure.x = {"time, s", false, 0.0, kComparedTime};
  figure.y = {"length over that at rest, minus 1", false};
  for (const FamilyRuns& family : one.stiff) {
    const ModelRun* run = run_of(family, elements);
    if (!run) continue;
    Series series;
    series.name = family.family.name;
    series.points.push_back({0, 0, {}});
    for (std::size_t k = 0; k < run->lengths.size(); ++k)
      series.points.push_back({static_cast<double>(k + 1) * run->step, run->lengths[k] - 1, {}});
    figure.series.push_back(std::move(series));
  }
  return figure;
}

Table table_of(const FamilyRuns& family) {
  Table table{family.family.name, {"elements", "h, s", "error, mm", "ms for a second", ""}, {}};
  for (const ModelRun& run : family.runs)
    table.rows.push_back({std::to_string(run.elements), step_text(run.step),
                          run.trouble.empty() ? to_text(1e3 * run.error) : "", to_text(1e3 * run.seconds),
                          run.trouble});
  return table;
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

std::string left_out_of(const std::vector<FamilyRuns>& families) {
  std::string text;
  for (const FamilyRuns& family : families)
    if (!family.left_out.empty())
      text += (text.empty() ? "Left out: " : "; ") + std::string(family.family.name) + ", " + family.left_out;
  return text;
}

Section section_of(const HairComparison& one) {
  Section section;
  section.heading = one.hair.title;
  section.paragraphs = {"The fine motion comes from chains of " + std::to_string(one.hair.fine) + " and " +
                        std::to_string(2 * one.hair.fine) + " rigid links. It is known to " +
                        to_text(1e3 * one.uncertainty) + " mm, and took " + to_text(one.fine_seconds) +
                        " s of CPU time. In the table, brackets hold the elements and the step."};
  if (const std::string text = left_out_of(one.families); !text.empty())
    section.paragraphs.push_back(text + ".");
  section.first = {cheapest(one)};
  section.figures = {to_svg(error_figure(one))};
  for (const FamilyRuns& family : one.families)
    if (!family.runs.empty()) section.tables.push_back(table_of(family));
  return section;
}

Section cost_section(const std::vector<HelixCost>& costs) {
  Figure figure;
  figure.id = "helix-cost";
  figure.title = "Super-helices: what a step costs against the number of elements";
  figure.description =
      "CPU time of helix_step, and of mass_matrix, which makes a table that grows with the square.";
  figure.x.title = "elements";
  figure.y.title = "CPU time, s";
  figure.series = {{"helix_step", {}}, {"mass_matrix", {}}};
  figure.guides = {{1, "slope 1"}, {2, "slope 2"}, {3, "slope 3"}};
  Table table{"Microseconds", {"elements", "helix_step", "mass_matrix"}, {}};
  for (const HelixCost& one : costs) {
    figure.series[0].points.push_back({static_cast<double>(one.elements), one.step, {}});
    figure.series[1].points.push_back({static_cast<double>(one.elements), one.mass_matrix, {}});
    table.rows.push_back(
        {std::to_string(one.elements), to_text(1e6 * one.step), to_text(1e6 * one.mass_matrix)});
  }
  return {"What a helix costs",
          {"A curl with a turn in each element. A step that goes through the elements from the tip to the "
           "root and back grows "
           "with their number, slope 1. One that makes the matrix grows with its square at least, and one "
           "that factors it with the "
           "third power, once there are many."},
          {to_svg(figure)},
          {table}};
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
  if (const std::string text = left_out_of(one.stiff); !text.empty())
    section.paragraphs.push_back(text + ".");
  section.figures = {to_svg(stiff_figure(one)), to_svg(length_figure(one))};
  for (const FamilyRuns& family : one.stiff)
    if (!family.runs.empty()) section.tables.push_back(table_of(family));
  return section;
}

}  // namespace

std::vector<const ModelRun*> best_of(const FamilyRuns& family) {
  std::vector<const ModelRun*> finished;
  for (const ModelRun& run : family.runs)
    if (run.trouble.empty()) finished.push_back(&run);
  std::sort(finished.begin(), finished.end(),
            [](const ModelRun* a, const ModelRun* b) { return a->seconds < b->seconds; });
  std::vector<const ModelRun*> best;
  for (const ModelRun* run : finished)
    if (best.empty() || run->error < best.back()->error) best.push_back(run);
  return best;
}

Table table_of_runs(const Comparison& comparison) {
  Table table{"", {"hair", "family", "elements", "step_s", "error_m", "cpu_s_per_s", "trouble"}, {}};
  for (const HairComparison& one : comparison.hairs)
    for (const std::vector<FamilyRuns>* families : {&one.families, &one.stiff})
      for (const FamilyRuns& family : *families)
        for (const ModelRun& run : family.runs)
          table.rows.push_back({one.hair.id, family.family.id, std::to_string(run.elements),
                                to_exact_text(run.step), run.trouble.empty() ? to_exact_text(run.error) : "",
                                to_exact_text(run.seconds), run.trouble});
  return table;
}

Table table_of_lengths(const Comparison& comparison) {
  Table table{"", {"family", "elements", "time_s", "length_over_rest"}, {}};
  for (const HairComparison& one : comparison.hairs)
    for (const FamilyRuns& family : one.stiff)
      for (const ModelRun& run : family.runs)
        for (std::size_t k = 0; k < run.lengths.size(); ++k)
          table.rows.push_back({family.family.id, std::to_string(run.elements),
                                to_exact_text(static_cast<double>(k + 1) * run.step),
                                to_exact_text(run.lengths[k])});
  return table;
}

Page models_page(const Comparison& comparison, const std::string& machine) {
  Page page;
  page.title = "Which strand model, when?";
  page.paragraphs = {
      "The same hair by springs, rigid links and super-helices, with several numbers of elements and several "
      "steps: how "
      "far it is from the "
      "motion of an inextensible rod, and what it costs. " +
          machine,
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
