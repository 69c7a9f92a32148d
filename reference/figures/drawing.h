// STAFF ONLY. The vocabulary of the exercises' figures: lines, arrows, words and axes, in the colours of
// plots. Coordinates are pixels, y downwards. Words are written with *italic* symbols, _sub and ^superscripts
// of a letter or of {several}.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "hair/io/plot/axes.h"
#include "hair/io/plot/look.h"
#include "hair/io/plot/scale.h"
#include "hair/io/plot/xml.h"

namespace figures {

using Eigen::Vector3d, Eigen::VectorXd;
using hair::Axis;
using hair::plot::Box;
using hair::plot::colour, hair::plot::kText, hair::plot::kQuiet, hair::plot::kMiddle, hair::plot::kFaint,
    hair::plot::kPaper, hair::plot::kSoft;
using Spot = Eigen::Vector2d;
using Spots = std::vector<Spot>;

struct Pen {
  std::string colour = kText;
  double width = 2;
  std::string dash = "none";
  double opacity = 1;
};

struct Lettering {
  std::string colour = kText;
  const char* anchor = "middle";
  double size = 15;
  const char* weight = "normal";
};

// The axes of a plot: a place for each pair of values.
struct Plot {
  Box box;
  hair::plot::Scale x, y;

  Spot operator()(double at_x, double at_y) const { return {x.pixel(at_x), y.pixel(at_y)}; }
  Spot operator()(const Spot& values) const { return (*this)(values[0], values[1]); }
};

// A place for each point in space: an orthographic view.
struct View {
  Spot middle = {0, 0};  // pixels, of the point `at`
  double unit = 1;       // pixels for a metre
  Vector3d at = {0, 0, 0}, right = {1, 0, 0}, up = {0, 1, 0};

  Spot operator()(const Vector3d& point) const {
    return middle + unit * Spot(right.dot(point - at), -up.dot(point - at));
  }
};

class Drawing {
 public:
  static constexpr double kWidth = 720;

  Drawing(const std::string& exercise, double height, const std::string& title,
          const std::string& description);

  void line(const Spots& spots, const Pen& pen = {}) { lines({spots}, pen); }
  void lines(const std::vector<Spots>& all, const Pen& pen);
  void area(const Spots& spots, const std::string& colour, double opacity = 0.2);
  void dot(const Spot& at, const std::string& colour = kText, double radius = 4);
  void ring(const Spot& at, double radius, const Pen& pen = {});
  // With a name in its colour, in the middle of a place beside its tip.
  void arrow(const Spot& from, const Spot& to, const Pen& pen, std::string_view name = {},
             const Spot& beside = {0, 0});
  void words(const Spot& at, std::string_view text, const Lettering& lettering = {});
  void path(const std::string& d, const std::string& fill, double opacity);  // anything else

  // Axes with both limits. The title of y stands above the plot.
  Plot plot(const Box& box, const Axis& x, const Axis& y, int ticks_across = 6, int ticks_up = 6);
  // Joins the values that lie within the axes.
  void curve(const Plot& plot, const Spots& values, const Pen& pen = {});

  std::string svg();

 private:
  hair::plot::XmlWriter xml_;
};

// A number with so many digits behind its point.
std::string fixed(double value, int digits);

// A curve at so many pieces' ends. It returns a Spot: an expression of Eigen may refer to what is gone.
template <class Curve>
Spots sampled(double from, double to, int pieces, const Curve& curve) {
  Spots spots;
  for (int i = 0; i <= pieces; ++i) spots.emplace_back(curve(from + (to - from) * i / pieces));
  return spots;
}

}  // namespace figures
