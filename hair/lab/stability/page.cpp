#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/lab/stability/report.h"

namespace hair {

namespace {

// "the boundary lies +0.10 cells from it (median), at most -0.43"
std::string distance_in_words(const Distance& distance) {
  std::string text;
  if (distance.columns > 0)
    text = "the boundary lies " + cells(distance.median_cells) + " cells from it (median), at most " +
           cells(distance.worst_cells);
  if (distance.columns_beyond > 0)
    text += (text.empty() ? "" : "; ") + std::string("in ") + std::to_string(distance.columns_beyond) +
            " columns where one of them is not on the map they are apart, by " +
            cells(distance.beyond_cells) + " cells at least where it is most";
  return text.empty() ? "both are beyond the map" : text;
}

std::string describe(const StabilityMap& map) {
  std::string text = "Of " + std::to_string(map.grid.cells.size()) + " cells";
  for (int i = 0; i < kFates; ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(std::ranges::count(map.grid.cells, i)) + " " +
            fate_name(static_cast<Fate>(i));
  text += "; " + std::to_string(map.grid.asked) + " of them were run, each for " + std::to_string(map.steps) +
          " steps, in " + printed("%.1f", map.cpu_seconds) + " s of CPU time.";
  for (const Limit& limit : map.limits) {
    const std::string words = verdict(map, limit);
    text += " " + limit.name + ": " + (words.empty() ? distance_in_words(limit.distance) : words) + ".";
  }
  return text;
}

CellMap figure_of(const StabilityMap& map) {
  CellMap figure;
  figure.id = map.method.id + "-" + name_of(map.sweep);
  figure.title = map.method.name + ": step size against " + name_of(map.sweep);
  figure.description = describe(map);
  figure.x.title =
      map.sweep == Swept::stiffness ? "stiffness, times the scene's" : "drag, N s/m for each metre of hair";
  figure.y.title = "step size h, s";
  figure.xs = map.xs;
  figure.ys = map.hs;
  for (int i = 0; i < kFates; ++i) figure.classes.emplace_back(fate_name(static_cast<Fate>(i)));
  figure.cells = map.grid.cells;
  const double cell = std::sqrt(map.hs[1] / map.hs[0]);
  for (const Limit& limit : map.limits) {
    Series series{limit.name, {}, true, false, limit.of_run};
    for (std::size_t i = 0; i < limit.h.size(); ++i)
      if (limit.h[i] >= map.hs.front() / cell && limit.h[i] <= map.hs.back() * cell)
        series.points.push_back({map.xs[i], limit.h[i]});
    if (!series.points.empty()) figure.limits.push_back(std::move(series));
  }
  return figure;
}

// The different names of the runs, in the order of their first ones.
std::vector<std::string> names_in(const std::vector<ExtremeRun>& runs,
                                  const std::function<std::string(const ExtremeRun&)>& name_of) {
  std::vector<std::string> names;
  for (const ExtremeRun& run : runs)
    if (std::ranges::find(names, name_of(run)) == names.end()) names.push_back(name_of(run));
  return names;
}

// A column for each method, with its outcome for a step.
Table summary_of(const std::vector<ExtremeRun>& all, const std::string& caption,
                 const std::function<bool(const ExtremeRun&)>& wanted) {
  std::vector<ExtremeRun> runs;
  std::ranges::copy_if(all, std::back_inserter(runs), wanted);
  const auto methods = names_in(runs, [](const ExtremeRun& run) { return run.method.name; });
  Table table{caption, {"case"}, {}};
  table.header.insert(table.header.end(), methods.begin(), methods.end());
  for (const std::string& name : names_in(runs, [](const ExtremeRun& run) { return run.extreme; })) {
    std::vector<std::string>& row = table.rows.emplace_back(1, name);
    for (const std::string& method : methods) {
      const auto run = std::ranges::find_if(
          runs, [&](const ExtremeRun& one) { return one.extreme == name && one.method.name == method; });
      row.push_back(run == runs.end() ? "" : fate_name(run->fate));
    }
  }
  return table;
}

Section section_of_hair(const StabilityReport& report) {
  const Frequencies& f = report.frequencies;
  Section section{"The hair and its frequencies"};
  section.paragraphs.push_back(
      "A strand of " + std::to_string(report.segments) + " segments, " + to_text(report.length) +
      " m long, " + (report.EA > 0 ? "EA = " + to_text(report.EA) + " N, " : "") +
      "EI = " + to_text(report.EI) + " N m^2, " + to_text(report.mass) + " kg" +
      (report.segments == report.scene_segments
           ? std::string(".")
           : ", which the scene has in " + std::to_string(report.scene_segments) + " segments.") +
      " The fastest motion along it goes with n / length, so that limits of explicit methods do, too, "
      "inversely.");
  if (report.was_curved)
    section.paragraphs.emplace_back(
        "The scene's hair is curved at rest; here it is straight, and its bending springs are, too.");
  Table table{
      "The fastest oscillations of the strand as it hangs, 1/s", {"motion", "omega", "2/omega, s"}, {}};
  const auto add = [&](const char* motion, double omega) {
    if (omega > 0) table.rows.push_back({motion, to_text(omega), to_text(2 / omega)});
  };
  add("along the hair", f.along);
  add("across it", f.across);
  add("across it, by tension alone (omega_t)", f.tension);
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace

std::string names_of(const StabilityMap& map) {
  std::string names = map.method.name;
  for (const StudyMethod& other : map.alike) names += "; " + other.name;
  return names;
}

std::string verdict(const StabilityMap& map, const Limit& limit) {
  const bool never = std::ranges::all_of(limit.h, [](double h) { return std::isinf(h); });
  const bool always = std::ranges::all_of(limit.h, [](double h) { return h == 0; });
  const auto all_are = [&](double h) {
    return std::ranges::all_of(map.boundary, [h](double one) { return one == h; });
  };
  if (always)
    return all_are(0) ? "no step is stable, and no cell is"
                      : "no step is stable, but so few steps don't show it everywhere";
  if (never)
    return all_are(std::numeric_limits<double>::infinity()) ? "none, and none was found"
                                                            : "none, but a boundary was found";
  return "";
}

Page page_of(const StabilityReport& report) {
  Page page{report.scene + ": where each method breaks"};
  page.paragraphs = {
      "The scene's first strand hangs straight down at rest, and every oscillation that it can make, along "
      "it and across it, is given the same little energy: so little that no segment comes out of tension. "
      "Each cell of a map is a run from there, with its step size and its stiffness (EA and EI together) or "
      "drag. The start is the study's own: what else is in the scene does not matter.",
      "Blown up: the simulation says so, or the hair moves with more energy than it would take to throw it "
      "over its root (2 m g L). Wrong: all numbers are finite, but at some moment an oscillation has 100 "
      "times the energy that it was given. Damped out: less than a tenth is left of the energy that the true "
      "motion has then. Stable: the rest; it may be inaccurate all the same.",
      "Few cells are run: in a column every " + std::to_string(kCoarse) +
          "th, and boundaries are found by halving. A column between two that are alike is not run. An "
          "island that is one column wide, or lower than " +
          std::to_string(kCoarse) + " cells, can be missed."};
  if (report.interrupted)
    page.paragraphs.push_back("Interrupted: " + std::to_string(report.maps.size()) + " of " +
                              std::to_string(report.maps_asked) +
                              " maps are here, those that were finished.");
  for (const LeftOut& one : report.left_out)
    page.paragraphs.push_back(one.method.name + " is left out: " + one.why + ".");
  page.sections.push_back(section_of_hair(report));
  if (!report.maps.empty())
    page.sections.push_back(
        {"The measured boundaries, and theory",
         {"The grid's cells are " + percent(report.maps[0].hs[1] / report.maps[0].hs[0] - 1) +
          " high (explicit methods). A run of finitely many steps can't tell slow growth from none; the "
          "dashed curve is where theory says that errors grow a hundredfold in the steps of a run."},
         {},
         {table_of(limit_rows(report),
                   "Where the first wrong or blown-up cell is, from theory's limit: > 0 is stable beyond it"),
          table_of(rows_of(report.maps, row_of_map), "What the maps took")}});
  for (std::size_t i = 0; i < report.maps.size(); ++i) {
    const StabilityMap& map = report.maps[i];
    if (page.sections.empty() || page.sections.back().heading != names_of(map)) {
      page.sections.push_back({names_of(map)});
      if (!map.alike.empty())
        page.sections.back().paragraphs.emplace_back(
            "These make the same matrix of hair that hangs, and so the same runs; the extreme cases tell "
            "them apart.");
    }
    page.sections.back().paragraphs.push_back(describe(map));
    page.sections.back().figures.push_back(to_svg(figure_of(map)));
  }
  if (!report.extremes.empty()) {
    Section section{"Extreme cases"};
    section.paragraphs = {"Half a second without air (" + std::to_string(kMostExtremeSteps) +
                          " steps at most). Energy counts from that of hair that hangs at rest, relative to "
                          "the root's motion; the true motion keeps it. Blown up: the simulation says so, or "
                          "at the end it has a thousand times the energy of the start. Wrong: at some moment "
                          "more than twice that. Damped out: less than a tenth is left at the end."};
    section.tables = {summary_of(report.extremes, "h = 1/60 s",
                                 [](const ExtremeRun& run) { return run.step_from.empty() && run.h > 0.01; }),
                      summary_of(report.extremes, "h = 1/240 s",
                                 [](const ExtremeRun& run) { return run.step_from.empty() && run.h < 0.01; }),
                      summary_of(report.extremes,
                                 "Explicit methods with half their limit for hair that hangs (those that "
                                 "have none: half of RK4's)",
                                 [](const ExtremeRun& run) { return !run.step_from.empty(); }),
                      table_of(rows_of(report.extremes, row_of_extreme),
                               "Every run of the extreme cases; energies over that of the start")};
    std::erase_if(section.tables, [](const Table& table) { return table.rows.empty(); });
    page.sections.push_back(std::move(section));
  }
  return page;
}

}  // namespace hair
