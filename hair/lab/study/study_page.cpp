#include "hair/lab/study/study_record.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/work_precision.h"
#include "hair/lab/study/observed_order.h"

namespace hair {

namespace {

constexpr double kTick = 1e-9;  // s

constexpr struct {
  const char *id, *title, *words;
} kAxes[] = {{"time", "CPU time, s", "CPU time"},  // as Against
             {"step", "step, s", "the step"},
             {"work", "evaluations of forces and iterations of ConjGrad", "work"}};

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

struct Cost {
  double seconds;
  const Sweep* sweep;
};

// The methods that reach the error, the cheapest first.
std::vector<Cost> costs_for(const Study& study, Norm norm, double error) {
  std::vector<Cost> costs;
  for (const Sweep& sweep : study.sweeps) {
    std::vector<Sample> samples;
    for (const MethodRun& run : sweep.runs)
      if (run.ending == RunEnding::finished) samples.push_back({run.time(), run.errors[norm]});
    if (const auto seconds = time_for(samples, error, study.floors[norm]))
      costs.push_back({*seconds, &sweep});
  }
  std::ranges::sort(costs, [](const Cost& a, const Cost& b) { return a.seconds < b.seconds; });
  return costs;
}

// From the strand's size down in powers of ten, as long as a method reaches the error.
Table cheapest_table(const Study& study) {
  constexpr int kShown = 3;
  Table table{"CPU time, s, for an error at the end, m: the three cheapest methods", {"error, m"}, {}};
  for (const char* place : {"cheapest", "second", "third"}) table.header.emplace_back(place);
  const Norm norm = Norm::final_largest;
  for (double error = std::pow(10, std::floor(std::log10(study.size)) - 1); error >= study.floors[norm];
       error /= 10) {
    const std::vector<Cost> costs = costs_for(study, norm, error * (1 + 1e-9));
    if (costs.empty()) break;
    std::vector<std::string> row = {to_text(error)};
    for (int k = 0; k < kShown; ++k)
      row.push_back(k < static_cast<int>(costs.size())
                        ? costs[k].sweep->method.name + ": " + to_text(costs[k].seconds)
                        : "");
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table order_table(const Study& study) {
  Table table{"Orders, of the L2 error of the way",
              {"method", "theory", "seen", "for steps, s", "that is", "no finer step, because"},
              {}};
  for (const Sweep& sweep : study.sweeps) {
    const ObservedOrder seen = observed_order(sweep, Norm::trajectory, study.floors[Norm::trajectory]);
    std::vector<std::string> row = {
        sweep.method.name, std::to_string(sweep.method.order()), "", "", verdict(sweep, seen),
        name_of(sweep.end)};
    if (seen.order) {
      row[2] = to_text(std::round(*seen.order * 100) / 100);
      row[3] = to_text(seen.coarsest) + " to " + to_text(seen.finest);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table failed_table(const Study& study) {
  Table table{"Runs that did not get to their end", {"method", "step, s", "ended", "where"}, {}};
  for (const Sweep& sweep : study.sweeps)
    for (const MethodRun& run : sweep.runs)
      if (run.ending != RunEnding::finished)
        table.rows.push_back({sweep.method.name, to_text(run.step), name_of(run.ending), run.trouble});
  return table;
}

std::string what(const Study& study) {
  std::string shows = study.shows;
  if (!shows.empty()) shows[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(shows[0])));
  return shows + ". " + to_text(study.duration) + " s of it, " + std::to_string(study.particles) + " points.";
}

std::string reference_text(const AccurateMotion& motion) {
  return "The accurate motion: " + motion.method + ", " + to_text(motion.cpu_seconds) + " s of CPU time" +
         (motion.from_cache ? ", kept from an earlier study" : "") + ". Its two solutions agree to " +
         to_text(motion.agreement) + " m, and no error below " + to_text(motion.least_error()) +
         " m is quoted." +
         (motion.inextensible ? " The strand is so hard to stretch that the accurate motion is that of one "
                                "that does not stretch at all."
                              : "");
}

Section space_section(const SpaceError& space, int own) {
  Section section{.heading = "What more segments would gain"};
  if (!space.left_out.empty()) {
    section.paragraphs.push_back("Not known: " + space.left_out + ".");
    return section;
  }
  section.paragraphs.push_back(
      "All errors above are of time: how far a method is from the same segments moved without error. This is "
      "how far these segments are from a strand of infinitely many, " +
      to_text(space.error_of(own).value_or(0)) +
      " m, and no smaller step takes it away. It falls with the order " +
      to_text(std::round(space.order * 100) / 100) + " (theory: 2).");
  section.tables.push_back(
      table_of(rows_of(space.levels, row_of_level),
               "Space error: the largest distance of a place from the limit, at any moment"));
  return section;
}

constexpr const char* kTimes =
    "A time is the median of up to seven repeats of CPU time (long runs have fewer), without the first of "
    "short ones, and without what measures errors. Runs shorter than a millisecond are played many times in "
    "a row between two looks at the clock; what going back to the start takes is measured by itself and "
    "taken off. Other work on the machine makes times longer, not errors.";

}  // namespace

Figure error_figure(const Study& study, Norm norm, Against against) {
  const NormName& error = name_of(norm);
  const auto& across = kAxes[static_cast<int>(against)];
  Figure figure;
  figure.id = std::string(error.id) + "-against-" + across.id;
  std::ranges::replace(figure.id, '_', '-');
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

Page study_page(const Study& study) {
  Page page;
  page.title = study.scene + ": error against time";
  page.paragraphs = {what(study),
                     "Each line is a method, each point a run of it with one step. The lower and the further "
                     "left, the better. Runs that broke stand at the upper edge, where the whole run would "
                     "have been. Rest the pointer on a point to read it."};
  if (std::ranges::any_of(study.sweeps, [](const Sweep& one) { return one.method.id.ends_with("-written"); }))
    page.paragraphs.emplace_back(
        "\"Written down\" is the same method in a program for one strand alone: what it costs by itself.");
  std::string missing;
  for (const Sweep& sweep : study.sweeps) {
    if (!sweep.left_out.empty())
      page.paragraphs.push_back(sweep.method.name + " is left out: " + sweep.left_out + ".");
    if (sweep.end == SweepEnd::unfinished) missing += (missing.empty() ? "" : ", ") + sweep.method.name;
  }
  if (!missing.empty()) page.paragraphs.push_back("Interrupted: finer steps are missing of " + missing + ".");

  page.sections.push_back(
      {.heading = "What an error costs",
       .paragraphs = {"The largest distance of a particle from where it really is at the end."},
       .figures = {to_svg(error_figure(study, Norm::final_largest, Against::time))},
       .tables = {}});
  page.sections.push_back({.heading = "Which method is the cheapest",
                           .paragraphs = {"Read off the lines above, between points, too."},
                           .tables = {cheapest_table(study)}});
  page.sections.push_back({.heading = "What a smaller step gains",
                           .paragraphs = {"A method of order p has 2^-p of the error with half of the step, "
                                          "once the step is small enough for its asymptotic part."},
                           .figures = {to_svg(error_figure(study, Norm::trajectory, Against::step))},
                           .tables = {}});
  page.sections.push_back({.heading = "Orders", .tables = {order_table(study)}});
  page.sections.push_back(
      {.heading = "The same without a clock",
       .paragraphs = {"Evaluations of forces and iterations of ConjGrad, each a product with a matrix, cost "
                      "about the same; they are the same on every machine. Not in it: H6's length "
                      "corrections, Newton steps of a tridiagonal system each, which study.csv counts."},
       .figures = {to_svg(error_figure(study, Norm::final_largest, Against::work))}});
  Section others{.heading = "Other ways to measure the error"};
  for (const Norm norm : {Norm::trajectory, Norm::length, Norm::energy, Norm::angular_momentum}) {
    if (!has(study, norm)) continue;
    const std::string says = name_of(norm).says;
    others.paragraphs.push_back(std::string(name_of(norm).title) + ": " + says + ".");
    others.figures.push_back(to_svg(error_figure(study, norm, Against::time)));
    if (norm != Norm::energy) continue;
    const MethodRow* said = nullptr;
    for (const Sweep& sweep : study.sweeps)
      if (const MethodRow& row = row_of(sweep.method.method); &row != said) {
        said = &row;
        others.paragraphs.back() += std::string(" On the line, ") + row.name + " " + row.energy + ".";
      }
  }
  if (!others.figures.empty()) page.sections.push_back(std::move(others));
  const Table failed = failed_table(study);
  if (!failed.rows.empty())
    page.sections.push_back(
        {.heading = "What failed, and where",
         .paragraphs = {"A run breaks when a number is not finite, or none that hair has; it is useless, and "
                        "ended, when a particle is further off than all is long."},
         .tables = {failed}});
  page.sections.push_back(
      {.heading = "What it is measured against", .paragraphs = {reference_text(study.reference)}});
  if (study.space_error) page.sections.push_back(space_section(*study.space_error, study.particles - 1));
  page.sections.push_back({.heading = "How times are measured", .paragraphs = {kTimes}});
  page.sections.push_back({.heading = "All runs", .tables = {table_of(run_rows(study), "All runs")}});
  return page;
}

}  // namespace hair
