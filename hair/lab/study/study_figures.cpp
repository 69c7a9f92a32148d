#include "hair/lab/study/study_figures.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/page.h"
#include "hair/io/plot/work_precision.h"

namespace hair {

namespace {

constexpr double kTick = 1e-9;  // s

struct AxisName {
  const char *id, *title, *words;
};

AxisName name_of(Against against) {
  switch (against) {
    case Against::step:
      return {"step", "step, s", "the step"};
    case Against::work:
      return {"work", "evaluations of forces and iterations of ConjGrad", "work"};
    default:
      return {"time", "CPU time, s", "CPU time"};
  }
}

// A run that ended early counts with the cost of its whole length. Even a run that broke in its first step
// evaluated forces, and took some measurable time.
double place(const MethodRun& run, Against against) {
  if (against == Against::step) return run.step;
  const double whole = static_cast<double>(run.steps_per_moment) * kMoments;
  const double share = whole / static_cast<double>(std::max(1L, run.counts.steps));
  return share * (against == Against::time ? std::max(run.time(), kTick)
                                           : static_cast<double>(std::max(1L, run.counts.work())));
}

std::string note_of(const MethodRun& run) {
  std::string note = "h = " + to_text(run.step) + " s";
  // There is one strand, or one toy.
  const std::string& trouble = run.trouble;
  if (!trouble.empty())
    note += ": " + (trouble.starts_with("strand 0, ") || trouble.starts_with("toy 0, ")
                        ? trouble.substr(trouble.find(", ") + 2)
                        : trouble);
  return note;
}

std::vector<Point> points_of(const Sweep& sweep, Norm norm, Against against, double floor) {
  std::vector<Point> points;
  for (const MethodRun& run : sweep.runs) {
    Point point{place(run, against), run.errors[norm], note_of(run)};
    point.failed = run.ending != RunEnding::finished;
    if (!point.failed && point.y < floor) {
      point.y = floor;
      point.note += ": below the accuracy of the reference";
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace

Figure error_figure(const Study& study, Norm norm, Against against) {
  const NormName& error = name_of(norm);
  const AxisName across = name_of(against);
  Figure figure;
  figure.id = std::string(error.id) + "-against-" + across.id;
  std::replace(figure.id.begin(), figure.id.end(), '_', '-');
  std::string title = error.title;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  figure.title = title + " against " + across.words;
  figure.description = std::string("For each method a line, and on it a point for each step size: ") +
                       error.says + ", against " + across.words + ". Both axes are logarithmic. " +
                       (against == Against::step ? "A method of order p falls along a line of slope p."
                                                 : "The lower and the further left, the better.");
  figure.x.title = across.title;
  figure.y.title = with_unit(error);

  const double floor = study.floors[norm];
  for (std::size_t i = 0; i < study.sweeps.size(); ++i) {
    Series series{study.sweeps[i].method.name, points_of(study.sweeps[i], norm, against, floor)};
    series.look = static_cast<int>(i);
    if (!series.points.empty()) figure.series.push_back(std::move(series));
  }
  add_level(figure, "accuracy of the reference", floor);
  if (against == Against::step) figure.guides = {{1, "order 1"}, {2, "order 2"}, {4, "order 4"}};
  return figure;
}

}  // namespace hair
