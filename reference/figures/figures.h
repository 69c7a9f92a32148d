// STAFF ONLY. The exercises' figures: each reference/<ID>/figure.cpp draws one from computed numbers.
#pragma once

#include <span>
#include <string>

namespace figures {

struct Figure {
  const char* exercise;  // "S1"
  std::string (*draw)();
};

std::span<const Figure> all_figures();

}  // namespace figures
