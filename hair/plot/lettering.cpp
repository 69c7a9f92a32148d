#include "hair/plot/lettering.h"

#include <algorithm>

namespace hair::plot {

namespace {

constexpr double kWide =
    0.56;  // of its size is a letter's width, on average: DejaVu Sans, one of the wider fonts

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

}  // namespace

double text_width(std::string_view text, double size) {
  return kWide * size * static_cast<double>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, double width, double size) {
  const auto fits = [&](std::string_view line) { return text_width(line, size) <= width; };
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
      std::size_t cut = word.size();
      while (cut > 1 && (!begins_character(word[cut - 1]) || !fits(word.substr(0, cut - 1)))) --cut;
      cut = std::max<std::size_t>(1, cut - 1);
      while (cut < word.size() && !begins_character(word[cut])) ++cut;
      if (cut == word.size()) break;  // a single letter
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

}  // namespace hair::plot
