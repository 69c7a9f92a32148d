#include "hair/io/plot/figure.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "hair/io/plot/look.h"
#include "hair/io/plot/test_parsed.h"
#include "hair/io/plot/test_samples.h"

namespace hair::plot {
namespace {

struct Labelled {
  double pixel, value;
};

// The value of a label to a reader: "0.1", "10" with -6 above, "2*10" with -6 above.
double value_of(const Element& label) {
  const auto ascii = [](std::string text) {
    for (const auto& [sign, plain] : {std::pair{"\u2212", "-"}, std::pair{"\u00B7", "*"}})
      for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign))
        text.replace(at, std::string(sign).size(), plain);
    return text;
  };
  std::string text = ascii(label.text);
  if (label.elements.empty()) return std::stod(text);
  const std::string exponent = ascii(label.elements[0].text);
  text.resize(text.size() - exponent.size());
  const std::size_t times = text.find('*');
  return (times == std::string::npos ? 1 : std::stod(text.substr(0, times))) *
         std::pow(10.0, std::stoi(exponent));
}

std::vector<Labelled> labels(const Element& svg, const std::string& axis) {
  std::vector<Labelled> all;
  for (const Element& label : svg.of_class(axis + "-labels").at(0).named("text"))
    all.push_back({std::stod(label[axis]), value_of(label)});
  return all;
}

// The pixel of a value according to the outer two labels, and the largest error of rounding to 0.01 pixels.
struct Expected {
  double pixel, bound;
};
Expected by_labels(const std::vector<Labelled>& labels, double value, bool logarithmic) {
  const auto place = [&](double v) { return logarithmic ? std::log10(v) : v; };
  const Labelled &a = labels.front(), &b = labels.back();
  const double t = (place(value) - place(a.value)) / (place(b.value) - place(a.value));
  return {a.pixel + t * (b.pixel - a.pixel), 0.0051 * (1 + std::abs(t) + std::abs(1 - t))};
}

std::vector<Labelled> positions(const Element& svg) {
  std::vector<Labelled> all;
  for (const Element& point : svg.of_class("point")) {
    std::istringstream transform(point["transform"].substr(std::string("translate(").size()));
    double x = 0, y = 0;
    transform >> x >> y;
    all.push_back({x, y});
  }
  return all;
}

// y labels are 4 pixels below their ticks, so that their centres are at the ticks.
constexpr double kLabelBelow = 4;

void expect_points_where_labels_say(bool x_log, bool y_log, double scale, double spread) {
  Figure figure;
  figure.id = "points";
  figure.x = {"x", x_log};
  figure.y = {"y", y_log};
  Series series = {"points", {}, false};
  for (int i = 0; i < 9; ++i)
    series.points.push_back({scale * std::pow(spread, i / 8.0), scale * std::pow(spread, (i * 5 % 9) / 8.0)});
  figure.series = {series};
  const Element svg = parse(to_svg(figure));
  const std::vector<Labelled> xs = labels(svg, "x"), ys = labels(svg, "y");
  ASSERT_GE(xs.size(), 2);
  ASSERT_GE(ys.size(), 2);
  const std::vector<Labelled> found = positions(svg);
  ASSERT_EQ(found.size(), series.points.size() + 1) << "each point once, and the legend's sample";
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const Expected x = by_labels(xs, series.points[i].x, x_log), y = by_labels(ys, series.points[i].y, y_log);
    EXPECT_NEAR(found[i].pixel, x.pixel, x.bound) << "x of point " << i << ", " << series.points[i].x;
    EXPECT_NEAR(found[i].value, y.pixel - kLabelBelow, y.bound)
        << "y of point " << i << ", " << series.points[i].y;
  }
  for (std::size_t i = 1; i < xs.size(); ++i)
    EXPECT_GE(xs[i].pixel - xs[i - 1].pixel, 40) << "labels of the x axis run into each other";
  for (std::size_t i = 1; i < ys.size(); ++i)
    EXPECT_GE(ys[i - 1].pixel - ys[i].pixel, 16) << "labels of the y axis run into each other";
}

TEST(FigureTest, APointLandsWhereTheLabelsSay) {
  for (const bool x_log : {false, true})
    for (const bool y_log : {false, true})
      for (const double scale : {1e-9, 0.003, 1.0, 7e6})
        for (const double spread : {1.001, 1.7, 30.0, 1e6, 1e14}) {
          SCOPED_TRACE(testing::Message()
                       << (x_log ? "logarithmic x, " : "linear x, ")
                       << (y_log ? "logarithmic y, " : "linear y, ") << scale << " to " << scale * spread);
          expect_points_where_labels_say(x_log, y_log, scale, spread);
        }
}

TEST(FigureTest, APointBeyondGivenLimitsStandsAtTheEdgeAndSaysItsValue) {
  Figure figure = sample_figure();
  figure.y.low = 1e-4;
  figure.y.high = 1;
  figure.series = {{"one", {{1, 1e-2}, {2, 1e-30}}}};
  figure.guides.clear();
  const Element svg = parse(to_svg(figure));
  const Element point = svg.of_class("point").at(1);
  EXPECT_NE(point.text.find("1e-30"), std::string::npos) << point.text;
  EXPECT_NE(point.text.find("beyond"), std::string::npos) << point.text;
  const Expected edge = by_labels(labels(svg, "y"), 1e-4, true);
  EXPECT_NEAR(positions(svg).at(1).value, edge.pixel - kLabelBelow, edge.bound);
}

TEST(FigureTest, AUnitIsAsLongOnBothAxesWhereTheFigureSaysSo) {
  Figure figure = {"map", "Map", "Two places.", {"east, m", false}, {"north, m", false}};
  figure.same_unit = true;
  for (const double high : {0.1, 1.0, 30.0}) {
    figure.series = {{"places", {{0, 0}, {1, high}}}};
    const Element svg = parse(to_svg(figure));
    const auto unit = [&](const char* axis) {
      const std::vector<Labelled> all = labels(svg, axis);
      return std::abs((all.back().pixel - all.front().pixel) / (all.back().value - all.front().value));
    };
    EXPECT_NEAR(unit("x") / unit("y"), 1, 1e-3) << high;
  }
  figure.x.logarithmic = true;
  figure.series = {{"places", {{1, 1}, {2, 2}}}};
  EXPECT_THROW(to_svg(figure), std::invalid_argument);
}

TEST(FigureTest, ARunThatFailedStandsAboveThePlotAndItsNoteCanBeRead) {
  const Figure figure = sample_figure();
  const Element svg = parse(to_svg(figure));
  const double top = labels(svg, "y").back().pixel;
  int failed = 0;
  const std::vector<Element> points = svg.of_class("point");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].text.find("failed") != std::string::npos) {
      ++failed;
      EXPECT_LT(positions(svg)[i].value, top);
    }
  EXPECT_EQ(failed, 6) << "of the sample";
  std::string texts;
  for (const Element& text : svg.named("text")) texts += text.text + "\n";
  EXPECT_NE(texts.find("method 2: h = 1/100 s; h = 1/200 s"), std::string::npos) << texts;
}

TEST(FigureTest, WhoRestsOnAPointReadsSeriesValuesAndNote) {
  const Element svg = parse(to_svg(sample_figure()));
  std::set<std::string> hovers;
  for (const Element& point : svg.of_class("point")) hovers.insert(point.named("title").at(0).text);
  EXPECT_TRUE(hovers.count("method 3\nCPU time, s: 4e-4\nerror, m: 0.01\nh = 1/100 s"))
      << testing::PrintToString(hovers);
}

TEST(FigureTest, ItNamesAndDescribesItselfToThoseWhoDoNotSeeIt) {
  for (const std::string& text : {to_svg(sample_figure()), to_svg(sample_map())}) {
    const Element svg = parse(text);
    EXPECT_EQ(svg["role"], "img");
    std::istringstream labels(svg["aria-labelledby"]);
    for (std::string id; labels >> id;) {
      const auto of_id = svg.all([&](const Element& element) { return element.has("id", id); });
      ASSERT_EQ(of_id.size(), 1) << id;
      EXPECT_FALSE(of_id[0].text.empty());
    }
    EXPECT_EQ(svg.elements.at(0).name, "title");
    EXPECT_EQ(svg.elements.at(1).name, "desc");
  }
}

TEST(FigureTest, NothingIsLoadedFromElsewhereAndNothingRuns) {
  for (const std::string& text : {to_svg(sample_figure()), to_svg(sample_map())}) {
    const Element svg = parse(text);
    EXPECT_TRUE(svg.named("script").empty());
    const auto refers = svg.all([](const Element& element) {
      for (const auto& [name, value] : element.attributes)
        if (name == "href" || name.starts_with("on") || value.find("://") != std::string::npos) return true;
      return false;
    });
    EXPECT_TRUE(refers.empty()) << refers[0].name;
  }
}

TEST(FigureTest, HostileTextsStayTexts) {
  for (const std::string& text : hostile_texts()) {
    Figure figure = sample_figure();
    figure.title = figure.description = figure.x.title = figure.y.title = text;
    for (SlopeGuide& guide : figure.guides) guide.name = text;
    for (Series& series : figure.series) {
      series.name = text;
      for (Point& point : series.points) point.note = text;
    }
    Element svg;
    ASSERT_NO_THROW(svg = parse(to_svg(figure))) << text;
    for (const char* evil : {"script", "a", "image", "foreignObject"}) EXPECT_TRUE(svg.named(evil).empty());

    CellMap map = sample_map();
    map.title = map.description = map.x.title = map.y.title = map.classes[0] = map.limits[0].name = text;
    ASSERT_NO_THROW(parse(to_svg(map))) << text;
  }
}

TEST(FigureTest, ASeriesLooksAsItAsks) {
  Figure figure = sample_figure();
  figure.series = {{"one", {{1, 1}, {2, 2}}}, {"two", {{1, 2}, {2, 3}}}};
  figure.guides.clear();
  figure.series[0].look = 7;
  const std::vector<Element> points = parse(to_svg(figure)).of_class("point");
  EXPECT_EQ(points.at(0)["fill"], colour(7));
  EXPECT_EQ(points.at(0)["d"], marker_path(7, 4.5));
  EXPECT_EQ(points.at(2)["fill"], colour(1));
  figure.series[0].look = -1;
  EXPECT_THROW(to_svg(figure), std::invalid_argument);
}

TEST(FigureTest, GuidesHaveTheirSlopeAndStayInsideThePlot) {
  Figure figure = sample_figure();
  figure.guides = {{-1, "order 1"}, {-2, "order 2"}, {-4, "order 4"}, {0.5, "rising"}, {0, "level"}};
  const Element svg = parse(to_svg(figure));
  const std::vector<Labelled> xs = labels(svg, "x"), ys = labels(svg, "y");
  const auto per_pixel = [](const std::vector<Labelled>& axis) {
    return std::log10(axis.back().value / axis.front().value) / (axis.back().pixel - axis.front().pixel);
  };
  const std::vector<Element> lines = svg.of_class("guides").at(0).named("line");
  ASSERT_EQ(lines.size(), figure.guides.size());
  const Element clip = svg.named("clipPath").at(0).named("rect").at(0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double x1 = std::stod(lines[i]["x1"]), x2 = std::stod(lines[i]["x2"]);
    const double y1 = std::stod(lines[i]["y1"]), y2 = std::stod(lines[i]["y2"]);
    const double slope = (y2 - y1) * per_pixel(ys) / ((x2 - x1) * per_pixel(xs));
    // Rounded to 0.01 pixels over lengths of at least 20 of them.
    EXPECT_NEAR(slope, figure.guides[i].slope, 0.002 * (1 + std::abs(figure.guides[i].slope)));
    for (const double x : {x1, x2}) {
      EXPECT_GE(x, std::stod(clip["x"]));
      EXPECT_LE(x, std::stod(clip["x"]) + std::stod(clip["width"]));
    }
    for (const double y : {y1, y2}) {
      EXPECT_GE(y, std::stod(clip["y"]));
      EXPECT_LE(y, std::stod(clip["y"]) + std::stod(clip["height"]));
    }
  }
  figure.x.logarithmic = false;
  EXPECT_THROW(to_svg(figure), std::invalid_argument) << "a guide on a linear axis";
}

TEST(FigureTest, ValuesThatNoAxisHasAreRefusedByName) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {0.0, -1.0, inf, nan}) {
    Figure figure = sample_figure();
    figure.series[4].points[0].y = bad;
    EXPECT_THROW(to_svg(figure), std::invalid_argument) << "y = " << bad;
    figure.series[4].points[0].failed = true;
    EXPECT_NO_THROW(to_svg(figure)) << "y of a run that failed does not matter";
    figure.series[4].points[0].x = bad;
    EXPECT_THROW(to_svg(figure), std::invalid_argument) << "x = " << bad;
  }
  Figure figure = sample_figure();
  figure.x.low = 1;
  figure.x.high = 1;
  EXPECT_THROW(to_svg(figure), std::invalid_argument) << "an axis without length";
  for (const char* id : {"", "1a", "a b", "a\"b", "a_b", "\xC3\xA4"}) {
    figure = sample_figure();
    figure.id = id;
    EXPECT_THROW(to_svg(figure), std::invalid_argument) << "id " << id;
  }
}

TEST(FigureTest, WithoutPointsOrWithOneItIsStillAFigure) {
  Figure figure = sample_figure();
  figure.series = {{"nothing", {}}};
  EXPECT_NO_THROW(parse(to_svg(figure)));
  figure.series = {};
  EXPECT_NO_THROW(parse(to_svg(figure)));
  for (const bool logarithmic : {true, false}) {
    figure.guides.clear();
    figure.x.logarithmic = figure.y.logarithmic = logarithmic;
    figure.series = {{"one", {{3, 5e-7}}}};
    EXPECT_GE(labels(parse(to_svg(figure)), "x").size(), 2);
    EXPECT_GE(labels(parse(to_svg(figure)), "y").size(), 2);
  }
}

TEST(FigureTest, TheSameFigureIsTheSameTextInAnyLocale) {
  const std::string before = to_svg(sample_figure());
  EXPECT_EQ(to_svg(sample_figure()), before);
  const std::string old = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "C.UTF-8"})
    if (std::setlocale(LC_ALL, locale)) {
      EXPECT_EQ(to_svg(sample_figure()), before) << locale;
    }
  std::setlocale(LC_ALL, old.c_str());
}

}  // namespace
}  // namespace hair::plot
