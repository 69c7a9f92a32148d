#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "hair/io/plot/figure.h"
#include "hair/io/plot/test_parsed.h"
#include "hair/io/plot/test_samples.h"

namespace hair::plot {
namespace {

double number(const Element& element, const char* attribute) {
  return std::stod(element[attribute]);
}

TEST(CellMapTest, TheCellAtEachMiddleHasItsClass) {
  const CellMap map = sample_map();
  const Element svg = parse(to_svg(map));
  const Element box = svg.named("clipPath").at(0).named("rect").at(0);
  const std::vector<Element> cells = svg.of_class("cells");
  // The sample's cells are equal in the logarithm, and fill the box.
  const double width = number(box, "width") / static_cast<double>(map.xs.size());
  const double height = number(box, "height") / static_cast<double>(map.ys.size());
  for (std::size_t row = 0; row < map.ys.size(); ++row)
    for (std::size_t column = 0; column < map.xs.size(); ++column) {
      const double x = number(box, "x") + (static_cast<double>(column) + 0.5) * width;
      const double y = number(box, "y") + number(box, "height") - (static_cast<double>(row) + 0.5) * height;
      std::vector<const Element*> here;
      for (const Element& cell : cells)
        if (x > number(cell, "x") && x < number(cell, "x") + number(cell, "width") && y > number(cell, "y") &&
            y < number(cell, "y") + number(cell, "height"))
          here.push_back(&cell);
      ASSERT_EQ(here.size(), 1) << "row " << row << ", column " << column;
      const int cell = map.cells[row * map.xs.size() + column];
      const std::string name = cell < 0 ? "not known" : map.classes[cell];
      EXPECT_EQ(here[0]->text.substr(0, here[0]->text.find('\n')), name)
          << "row " << row << ", column " << column;
      EXPECT_EQ((*here[0])["fill"],
                "url(#sample-map-" + (cell < 0 ? "not-known" : "class-" + std::to_string(cell)) + ")");
    }
}

TEST(CellMapTest, EachClassHasAColourAndAHatchingOfItsOwnAndTheLegendNamesIt) {
  const Element svg = parse(to_svg(sample_map()));
  std::map<std::string, std::string> hatchings;
  std::set<std::string> colours;
  for (const Element& pattern : svg.named("pattern")) {
    hatchings[pattern.named("path").at(0)["d"]] += pattern["id"];
    colours.insert(pattern.named("rect").at(0)["fill"]);
  }
  EXPECT_EQ(hatchings.size(), 5) << "four classes, and not known";
  EXPECT_EQ(colours.size(), 5);
  std::set<std::string> texts;
  for (const Element& text : svg.named("text")) texts.insert(text.text);
  for (const char* name : {"stable", "damped out", "wrong", "blown up", "not known", "theory", "measured"})
    EXPECT_TRUE(texts.count(name)) << name;
}

TEST(CellMapTest, SizesThatDoNotMatchAreRefused) {
  const auto refuses = [](auto change, const char* what) {
    CellMap map = sample_map();
    change(map);
    EXPECT_THROW(to_svg(map), std::invalid_argument) << what;
  };
  refuses([](CellMap& map) { map.cells.pop_back(); }, "a cell is missing");
  refuses([](CellMap& map) { map.cells.push_back(0); }, "a cell too many");
  refuses([](CellMap& map) { map.cells[3] = 4; }, "a class that is not there");
  refuses([](CellMap& map) { map.cells[3] = -2; }, "a class below -1");
  refuses([](CellMap& map) { map.xs.clear(); }, "no columns");
  refuses([](CellMap& map) { std::swap(map.ys[0], map.ys[1]); }, "rows that don't increase");
  refuses([](CellMap& map) { map.ys[1] = map.ys[0]; }, "two rows at one place");
  refuses([](CellMap& map) { map.xs[0] = 0; }, "zero on a logarithmic axis");
  refuses([](CellMap& map) { map.id = "a b"; }, "an id with a space");
}

TEST(CellMapTest, OneCellIsAMap) {
  CellMap map = sample_map();
  map.xs = {1};
  map.ys = {1};
  map.cells = {0};
  map.limits.clear();
  EXPECT_EQ(parse(to_svg(map)).of_class("cells").size(), 1);
}

}  // namespace
}  // namespace hair::plot
