// STAFF ONLY. Writes figures as SVG.
#include "reference/figures/drawing.h"

#include <cmath>

#include "hair/io/plot/page.h"

namespace figures {

using hair::plot::pixels, hair::plot::Tick, hair::plot::with_minus;

namespace {

std::string path_of(const Spots& spots) {
  std::string d;
  const auto tenth = [](double value) { return pixels(std::round(10 * value) / 10); };
  for (const Spot& spot : spots) d += (d.empty() ? "M" : "L") + tenth(spot[0]) + " " + tenth(spot[1]);
  return d;
}

}  // namespace

Drawing::Drawing(const std::string& exercise, double height, const std::string& title,
                 const std::string& description) {
  open_svg(xml_, "figure-" + exercise, title, description, kWidth, height);
}

void Drawing::lines(const std::vector<Spots>& all, const Pen& pen) {
  std::string d;
  for (const Spots& spots : all) d += path_of(spots);
  xml_.empty("path", {{"d", d},
                      {"fill", "none"},
                      {"stroke", pen.colour},
                      {"stroke-width", pen.width},
                      {"stroke-dasharray", pen.dash},
                      {"stroke-linejoin", "round"},
                      {"stroke-opacity", pen.opacity}});
}

void Drawing::path(const std::string& d, const std::string& fill, double opacity) {
  xml_.empty("path", {{"d", d}, {"fill", fill}, {"fill-opacity", opacity}});
}

void Drawing::area(const Spots& spots, const std::string& colour, double opacity) {
  path(path_of(spots) + "Z", colour, opacity);
}

void Drawing::dot(const Spot& at, const std::string& colour, double radius) {
  xml_.empty("circle", {{"cx", at[0]}, {"cy", at[1]}, {"r", radius}, {"fill", colour}});
}

void Drawing::ring(const Spot& at, double radius, const Pen& pen) {
  xml_.empty("circle", {{"cx", at[0]},
                        {"cy", at[1]},
                        {"r", radius},
                        {"fill", "none"},
                        {"stroke", pen.colour},
                        {"stroke-width", pen.width},
                        {"stroke-dasharray", pen.dash}});
}

void Drawing::arrow(const Spot& from, const Spot& to, const Pen& pen, std::string_view name,
                    const Spot& beside) {
  const double length = (to - from).norm(), head = std::min(5 + 2.5 * pen.width, length);
  if (length == 0) return;
  const Spot along = (to - from) / length, across(-along[1], along[0]), neck = to - head * along;
  line({from, neck + 1 * along}, pen);
  area({to, neck + 0.42 * head * across, neck - 0.42 * head * across}, pen.colour, pen.opacity);
  if (!name.empty()) words(to + beside, name, {pen.colour, "middle", 17});
}

void Drawing::words(const Spot& at, std::string_view text, const Lettering& lettering) {
  xml_.open("text", {{"x", at[0]},
                     {"y", at[1]},
                     {"font-size", lettering.size},
                     {"text-anchor", lettering.anchor},
                     {"font-weight", lettering.weight},
                     {"fill", lettering.colour},
                     {"stroke", kPaper},
                     {"stroke-width", "4"},
                     {"paint-order", "stroke"}});
  double raised = 0;  // by the next piece, after an index
  bool italic = false;
  const auto piece = [&](std::string_view part, double lift) {
    if (part.empty()) return;
    const double down = raised - lift;
    xml_.open("tspan", {{"dy", down},
                        {"font-size", lettering.size * (lift == 0 ? 1 : 0.75)},
                        {"font-style", italic ? "italic" : "normal"},
                        {"font-family", italic ? "serif" : "system-ui, sans-serif"}});
    xml_.text(part).close();
    raised = lift;
  };
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c != '*' && c != '_' && c != '^') continue;
    piece(text.substr(begin, i - begin), 0);
    if (c == '*') {
      italic = !italic;
    } else {
      const bool several = text[i + 1] == '{';
      const std::size_t first = i + 1 + several, end = several ? text.find('}', first) : first + 1;
      piece(text.substr(first, end - first), (c == '_' ? -0.3 : 0.4) * lettering.size);
      i = end - !several;
    }
    begin = i + 1;
  }
  piece(text.substr(begin), 0);
  xml_.close();
}

Plot Drawing::plot(const Box& box, const Axis& x, const Axis& y, int ticks_across, int ticks_up) {
  const Plot plot = {box, hair::plot::Scale(x, {}, 0, box.left, box.right(), x.title),
                     hair::plot::Scale(y, {}, 0, box.bottom(), box.top, y.title)};
  const auto label = [](const Tick& tick) {
    return with_minus(tick.label + (tick.exponent.empty() ? "" : "^{" + tick.exponent + "}"));
  };
  const Pen faint = {kFaint, 1};
  for (const Tick& tick : plot.x.ticks(ticks_across))
    if (const double at = plot.x.pixel(tick.value); !tick.is_minor()) {
      line({{at, box.top}, {at, box.bottom()}}, faint);
      words({at, box.bottom() + 18}, label(tick), {kQuiet, "middle", 13});
    }
  for (const Tick& tick : plot.y.ticks(ticks_up))
    if (const double at = plot.y.pixel(tick.value); !tick.is_minor()) {
      line({{box.left, at}, {box.right(), at}}, faint);
      words({box.left - 7, at + 5}, label(tick), {kQuiet, "end", 13});
    }
  line({{box.left, box.top}, {box.left, box.bottom()}, {box.right(), box.bottom()}}, {kMiddle, 1.5});
  words({box.right(), box.bottom() + 38}, x.title, {kText, "end"});
  words({box.left - 20, box.top - 12}, y.title, {kText, "start"});
  return plot;
}

void Drawing::curve(const Plot& plot, const Spots& values, const Pen& pen) {
  Spots piece;
  const auto draw = [&] {
    if (piece.size() > 1) line(piece, pen);
    piece.clear();
  };
  for (const Spot& value : values)
    if (plot.x.contains(value[0]) && plot.y.contains(value[1]))
      piece.push_back(plot(value));
    else
      draw();
  draw();
}

std::string Drawing::svg() {
  return xml_.close().take();
}

std::string fixed(double value, int digits) {
  return with_minus(hair::printed(("%." + std::to_string(digits) + "f").c_str(), value));
}

}  // namespace figures
