// STAFF ONLY. The committed figures are those that the program draws today, and can be read in any browser.
#include "reference/figures/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "hair/io/files/read_file.h"
#include "hair/io/plot/test_parsed.h"

namespace figures {
namespace {

// The first place at which two drawings differ: a number within a tag by more than half a pixel, or anything
// else at all. Empty if they don't.
std::string difference(const std::string& drawn, const std::string& committed) {
  constexpr double kApart = 0.5;
  const auto around = [](const char* a, const char* b) {
    return std::string(a).substr(0, 60) + " ... instead of ... " + std::string(b).substr(0, 60);
  };
  bool tag = false;
  const char *a = drawn.c_str(), *b = committed.c_str();
  while (*a != 0 || *b != 0) {
    const auto is_number = [&](const char* at) {
      return tag && (std::isdigit(static_cast<unsigned char>(*at)) ||
                     (*at == '-' && std::isdigit(static_cast<unsigned char>(at[1]))));
    };
    if (is_number(a) && is_number(b)) {
      char *after_a = nullptr, *after_b = nullptr;
      const double apart = std::abs(std::strtod(a, &after_a) - std::strtod(b, &after_b));
      const bool is_share = std::string_view(drawn.c_str(), a).ends_with("opacity=\"");  // 0 to 1
      if (apart > (is_share ? 0.01 : kApart)) return around(a, b);
      a = after_a;
      b = after_b;
      continue;
    }
    if (*a != *b) return around(a, b);
    if (*a == '<' || *a == '>') tag = *a == '<';
    ++a;
    ++b;
  }
  return "";
}

TEST(Figures, AreThoseThatTheProgramDraws) {
  for (const auto& [exercise, draw] : kFigures) {
    const std::filesystem::path file = std::filesystem::path(HAIR_FIGURES_DIR) / exercise / "figure.svg";
    const std::string committed = hair::bytes_of(file), drawn = draw();
    EXPECT_EQ(difference(drawn, committed), "")
        << exercise << ": " << file << " is not what is drawn today; the target `figures` draws it anew";
    EXPECT_LE(drawn.size(), 60000U) << exercise;
    const hair::plot::Element svg = hair::plot::parse(drawn);
    EXPECT_EQ(svg.named("title").size(), 1U) << exercise;
    EXPECT_EQ(svg.named("desc").size(), 1U) << exercise;
    for (const char* tag : {"script", "image", "a", "use"}) EXPECT_TRUE(svg.named(tag).empty()) << exercise;
  }
}

TEST(Figures, DifferByHalfAPixelOrAWord) {
  EXPECT_EQ(difference("<a d=\"M1 2\">0.66</a>", "<a d=\"M1.4 1.8\">0.66</a>"), "");
  EXPECT_NE(difference("<a d=\"M1 2\">0.66</a>", "<a d=\"M1 2.6\">0.66</a>"), "");
  EXPECT_NE(difference("<a d=\"M1 2\">0.66</a>", "<a d=\"M1 2\">0.67</a>"), "");
  EXPECT_NE(difference("<a opacity=\"0.2\"/>", "<a opacity=\"0.6\"/>"), "");
  EXPECT_NE(difference("<a/>", "<a/><b/>"), "");
}

}  // namespace
}  // namespace figures
