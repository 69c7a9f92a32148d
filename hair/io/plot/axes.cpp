#include "hair/io/plot/axes.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "hair/io/plot/lettering.h"
#include "hair/io/plot/look.h"

namespace hair::plot {

namespace {

constexpr int kTicksAcross = 8, kTicksUp = 10;
constexpr double kTickLength = 6, kMinorTickLength = 3;

void line(XmlWriter& xml, double x1, double y1, double x2, double y2) {
  xml.empty("line", {{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}});
}

void write_label(XmlWriter& xml, double x, double y, const char* anchor, const Tick& tick) {
  xml.open("text", {{"x", x}, {"y", y}, {"text-anchor", anchor}}).text(with_minus(tick.label));
  if (!tick.exponent.empty())
    xml.leaf("tspan", {{"dy", "-5"}, {"font-size", "10"}}, with_minus(tick.exponent));
  xml.close();
}

}  // namespace

void check_id(const std::string& id) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!id.empty() && is_letter(id[0]) && std::all_of(id.begin(), id.end(), [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '-';
      }))
    return;
  throw std::invalid_argument("\"" + id +
                              "\" is no id of a figure; it must be letters, digits and hyphens, " +
                              "and begin with a letter");
}

std::string with_minus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "\u2212");
  return text;
}

void open_svg(XmlWriter& xml, const std::string& id, const std::string& title, const std::string& description,
              double width, double height) {
  const std::string size = pixels(width) + " " + pixels(height);
  xml.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"id", id},
                   {"role", "img"},
                   {"aria-labelledby", id + "-title " + id + "-description"},
                   {"viewBox", "0 0 " + size},
                   {"width", width},
                   {"height", height},
                   {"font-family", "system-ui, sans-serif"},
                   {"font-size", kSmall},
                   {"fill", kText}});
  xml.leaf("title", {{"id", id + "-title"}}, title);
  xml.leaf("desc", {{"id", id + "-description"}}, description);
  xml.open("style").as_it_is(dark_style()).close();
  xml.empty("rect", {{"width", width}, {"height", height}, {"fill", kPaper}});
}

void open_svg(XmlWriter& xml, const std::string& id, const std::string& title, const std::string& description,
              double height) {
  open_svg(xml, id, title, description, kFigureWidth, height);
  write(xml, kLeftMargin, 20, title, {.size = kTitle, .weight = "bold"});
}

void define_clip(XmlWriter& xml, const std::string& id, const Box& box) {
  xml.open("clipPath", {{"id", id}});
  xml.empty("rect", {{"x", box.left}, {"y", box.top}, {"width", box.width}, {"height", box.height}});
  xml.close();
}

void draw_grid(XmlWriter& xml, const Box& box, const Scale& x, const Scale& y) {
  xml.open("g", {{"stroke", kFaint}, {"stroke-width", "1"}});
  for (const Tick& tick : x.ticks(kTicksAcross))
    if (!tick.is_minor()) line(xml, x.pixel(tick.value), box.top, x.pixel(tick.value), box.bottom());
  for (const Tick& tick : y.ticks(kTicksUp))
    if (!tick.is_minor()) line(xml, box.left, y.pixel(tick.value), box.right(), y.pixel(tick.value));
  xml.close();
}

void draw_axes(XmlWriter& xml, const Box& box, const Scale& x, const Scale& y, const std::string& x_title,
               const std::string& y_title) {
  xml.open("g", {{"stroke", kText}, {"stroke-width", "1"}});
  xml.empty(
      "rect",
      {{"x", box.left}, {"y", box.top}, {"width", box.width}, {"height", box.height}, {"fill", "none"}});
  const auto length = [](const Tick& tick) { return tick.is_minor() ? kMinorTickLength : kTickLength; };
  for (const Tick& tick : x.ticks(kTicksAcross))
    line(xml, x.pixel(tick.value), box.bottom(), x.pixel(tick.value), box.bottom() + length(tick));
  for (const Tick& tick : y.ticks(kTicksUp))
    line(xml, box.left - length(tick), y.pixel(tick.value), box.left, y.pixel(tick.value));
  xml.close();

  xml.open("g", {{"class", "x-labels"}});
  for (const Tick& tick : x.ticks(kTicksAcross))
    if (!tick.is_minor()) write_label(xml, x.pixel(tick.value), box.bottom() + 20, "middle", tick);
  xml.close();
  xml.open("g", {{"class", "y-labels"}});
  for (const Tick& tick : y.ticks(kTicksUp))
    if (!tick.is_minor()) write_label(xml, box.left - 9, y.pixel(tick.value) + 4, "end", tick);
  xml.close();

  write(xml, box.left + box.width / 2, box.bottom() + 44, x_title, {.anchor = "middle"});
  const double middle = box.top + box.height / 2, left = 20;
  xml.leaf("text",
           {{"transform", "translate(" + pixels(left) + " " + pixels(middle) + ") rotate(-90)"},
            {"font-size", kSize},
            {"text-anchor", "middle"}},
           y_title);
}

}  // namespace hair::plot
