#include "hair/io/plot/legend.h"

#include <algorithm>

#include "hair/io/plot/lettering.h"

namespace hair::plot {

namespace {

constexpr double kWidestName = 200, kLine = 16, kBetween = 7, kAfterSample = 8;

}  // namespace

Legend::Legend(std::vector<LegendEntry> entries) : entries_(std::move(entries)) {
  double widest = 0;
  for (const LegendEntry& entry : entries_) {
    names_.push_back(wrapped(entry.name, kWidestName, kSize));
    for (const std::string& line : names_.back()) widest = std::max(widest, text_width(line, kSize));
  }
  if (!entries_.empty()) width_ = kSampleWide + kAfterSample + widest;
}

double Legend::height() const {
  double height = 0;
  for (const std::vector<std::string>& name : names_)
    height += kLine * std::max<double>(1, static_cast<double>(name.size())) + kBetween;
  return height;
}

void Legend::draw(XmlWriter& xml, double left, double top) const {
  double y = top;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].draw_sample(xml, left + kSampleWide / 2, y + kLine / 2);
    for (const std::string& line : names_[i]) {
      write(xml, left + kSampleWide + kAfterSample, y + kLine / 2 + 4.5, line);
      y += kLine;
    }
    if (names_[i].empty()) y += kLine;
    y += kBetween;
  }
}

}  // namespace hair::plot
