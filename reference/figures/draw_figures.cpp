// STAFF ONLY. Draws the exercises' figures into FOLDER/<ID>/figure.svg.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "hair/io/files/write_file.h"
#include "reference/figures/figures.h"

int main(int count, char** arguments) try {
  if (count < 2) {
    std::fprintf(stderr, "draw_figures FOLDER [ID ...]\n");
    return 2;
  }
  for (const auto& [exercise, draw] : figures::kFigures) {
    bool asked = count == 2;
    for (int i = 2; i < count; ++i) asked = asked || std::string(arguments[i]) == exercise;
    if (asked) hair::write_file(std::filesystem::path(arguments[1]) / exercise / "figure.svg", draw());
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "draw_figures: %s\n", error.what());
  return 1;
}
