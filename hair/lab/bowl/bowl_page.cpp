#include "hair/lab/bowl/bowl_page.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hair/io/plot/figure.h"

namespace hair::bowl {

namespace {

using namespace solver::study;

constexpr int kCorners = 90;                              // points of a level set
constexpr double kHeights[] = {1, 0.3, 0.1, 0.03, 0.01};  // values on the level sets
constexpr double kLowest = 1e-34;                         // stands for 0 on a logarithmic axis

// The points x with x'Cx = r: with C = LL', L' maps them to a circle.
Series level_set(const BowlPath& path, double height) {
  const double l00 = std::sqrt(path.xx), l10 = path.xy / l00, l11 = std::sqrt(path.yy - l10 * l10);
  const double dx = path.begin[0] - path.bottom[0], dy = path.begin[1] - path.bottom[1];
  const double radius = std::sqrt(height) * std::hypot(l00 * dx + l10 * dy, l11 * dy);
  Series series = {"height " + to_text(height), {}, true, false, true, 6};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    const double y = radius * std::sin(angle) / l11, x = (radius * std::cos(angle) - l10 * y) / l00;
    series.points.push_back({path.bottom[0] + x, path.bottom[1] + y});
  }
  return series;
}

bool near(const BowlPath& path, const Place& place, const Place& to) {
  const double whole = std::hypot(path.begin[0] - path.bottom[0], path.begin[1] - path.bottom[1]);
  return std::hypot(place[0] - to[0], place[1] - to[1]) <= 1e-9 * whole;
}

std::string steps_text(std::size_t steps) {
  return std::to_string(steps) + (steps == 1 ? " step" : " steps");
}

Figure figure_of(const BowlPath& path, const std::string& id) {
  // The picture shows all points within 1.2 times the right first guess's distance from the bottom.
  const double half = 1.2 * std::hypot(path.begin[0] - path.bottom[0], path.begin[1] - path.bottom[1]);
  const auto axis = [&](const char* title, double middle) {
    return Axis{title, false, middle - half, middle + half};
  };
  Figure figure = {
      id, "The path of " + path.solver + " over the bowl",
      "Level sets of a bowl, and where the solver is after 0, 1, 2, ... steps. " + path_verdict(path),
      axis("first unknown", path.bottom[0]), axis("second unknown", path.bottom[1])};
  figure.same_unit = true;
  Series way = {"after 0, 1, 2, ... steps", {}, true, true, false, 0};
  for (std::size_t steps = 0; steps < path.places.size(); ++steps) {
    const Place& place = path.places[steps];
    const bool finite = std::isfinite(place[0]) && std::isfinite(place[1]);
    way.points.push_back({finite ? place[0] : path.bottom[0], finite ? place[1] : path.bottom[1],
                          "after " + steps_text(steps) + (finite ? "" : ": not a number"), !finite});
  }
  figure.series = {way,
                   {"the bottom: the solution", {{path.bottom[0], path.bottom[1]}}, false, true, false, 1},
                   {"where it should begin", {{path.begin[0], path.begin[1]}}, false, true, false, 2}};
  for (const double height : kHeights) figure.series.push_back(level_set(path, height));
  return figure;
}

Figure heights_of(const BowlPath& path, const std::string& id) {
  Figure figure = {id,
                   "Height above the bottom, step by step",
                   "The height should be rounding's after two steps.",
                   {"steps", false, 0, kMostPathSteps},
                   {"height, relative to the first guess"}};
  Series heights = {path.solver, {}};
  for (std::size_t steps = 0; steps < path.places.size(); ++steps)
    if (const double height = path.height(path.places[steps]); std::isfinite(height))
      heights.points.push_back({static_cast<double>(steps), std::max(height, kLowest)});
  figure.series = {heights};
  return figure;
}

std::vector<Row> rows_of_path(const BowlPath& path) {
  std::vector<Row> rows;
  for (std::size_t steps = 0; steps < path.places.size(); ++steps)
    rows.push_back({{"solver", "", path.solver},
                    {"condition", "", path.condition, {"condition number"}},
                    {"steps", "", static_cast<long>(steps)},
                    {"x.first", "", path.places[steps][0], {"first unknown"}},
                    {"x.second", "", path.places[steps][1], {"second unknown"}},
                    {"height", "", path.height(path.places[steps]), {"height, relative"}}});
  return rows;
}

Section section_of(const BowlPath& path) {
  const bool normal = path.solver != "ConjGrad";
  const std::string id = normal ? "normal-path" : "path", root = to_text(std::sqrt(path.condition));
  const std::string what = normal
                               ? "A matrix that is not symmetric, with the same singular values and the same "
                                 "solution as the one above. A has the condition number " +
                                     root + ", A'A its square, " + to_text(path.condition) +
                                     ": a valley whose level sets are " + root + " times as long as wide."
                               : "A symmetric matrix with the condition number " + to_text(path.condition) +
                                     ". The level sets of its bowl, x'Ax / 2 - b'x, are ellipses, " + root +
                                     " times as long as wide. Each place is where your function is when "
                                     "*steps allows so many steps.";
  return {normal ? "The path of the normal equations" : "The path over the bowl",
          {what, path_verdict(path)},
          {to_svg(figure_of(path, id)), to_svg(heights_of(path, id + "-heights"))},
          {table_of(rows_of_path(path), "Where it is after so many steps")}};
}

}  // namespace

std::string path_verdict(const BowlPath& path) {
  const bool normal = path.solver != "ConjGrad";
  const std::string guess = normal ? "A'b" : "b";
  const std::string begins = near(path, path.places.front(), path.begin)
                                 ? "It begins at " + guess + ", as it should. "
                                 : "It does not begin at " + guess + ", as it should. ";
  if (const auto steps = path.steps_to_bottom())
    return begins + "It is at the bottom after " + steps_text(*steps) + "; two unknowns take 2.";
  const Place& last = path.places.back();
  if (!std::isfinite(last[0]) || !std::isfinite(last[1]))
    return begins + "After " + steps_text(path.places.size() - 1) + " its x is not a number.";
  return begins + "After " + steps_text(path.places.size() - 1) + " its height is still " +
         to_text(path.height(last)) + " of the first guess's; two unknowns take 2 steps.";
}

std::vector<Row> bowl_rows(const std::vector<BowlPath>& paths) {
  std::vector<Row> rows;
  for (const BowlPath& path : paths)
    for (Row& row : rows_of_path(path)) rows.push_back(std::move(row));
  return rows;
}

Page bowl_page(const std::vector<BowlPath>& paths, const std::string& left_out) {
  Page page = {"Paths over a bowl",
               {"ConjGrad goes to the bottom of a bowl of two unknowns, the normal equations to that of "
                "another one. Each of your functions is called with *steps of 1, 2, 3, ..."},
               {}};
  if (!left_out.empty()) page.paragraphs.push_back("The normal equations are left out: " + left_out + ".");
  for (const BowlPath& path : paths) page.sections.push_back(section_of(path));
  return page;
}

}  // namespace hair::bowl
