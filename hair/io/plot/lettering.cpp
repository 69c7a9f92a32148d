#include "hair/io/plot/lettering.h"

#include <algorithm>

namespace hair::plot {

namespace {

constexpr double kWide =
    0.56;  // average width of a letter over its size: DejaVu Sans, one of the wider fonts

// Pixels in legends.
constexpr double kWidestName = 200, kLine = 16, kBetween = 7, kAfterSample = 8;

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

// The byte at which the character after the first `characters` begins.
std::size_t begin_of_character(std::string_view text, std::size_t characters) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (begins_character(text[at]) && characters-- == 0) break;
  return at;
}

}  // namespace

double text_width(std::string_view text, double size) {
  return kWide * size * static_cast<double>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, double width, double size) {
  const auto fits = [&](std::string_view line) { return text_width(line, size) <= width; };
  const auto letters_in_a_line = std::max<std::size_t>(1, static_cast<std::size_t>(width / (kWide * size)));
  std::vector<std::string> lines;
  std::string line;
  const auto end_line = [&] {
    if (!line.empty()) lines.push_back(std::move(line));
    line.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    if (!line.empty() && !fits(line + " " + std::string(word))) end_line();
    while (!fits(word)) {
      const std::size_t cut = begin_of_character(word, letters_in_a_line);
      if (cut == word.size()) break;  // the line is narrower than a letter
      lines.emplace_back(word.substr(0, cut));
      word.remove_prefix(cut);
    }
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  end_line();
  return lines;
}

void write(XmlWriter& xml, double x, double y, std::string_view text, const Lettering& lettering) {
  xml.leaf("text",
           {{"x", x},
            {"y", y},
            {"font-size", lettering.size},
            {"text-anchor", lettering.anchor},
            {"font-weight", lettering.weight}},
           text);
}

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
