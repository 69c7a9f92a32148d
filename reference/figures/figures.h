// STAFF ONLY. The exercises' figures: each reference/<ID>/figure.cpp draws one from computed numbers.
// HAIR_FIGURES names them as FIGURE(S1, s1) FIGURE(S2, s2) ...
#pragma once

#include <string>

namespace figures {

#define FIGURE(id, name) std::string draw_##name();
HAIR_FIGURES
#undef FIGURE

struct Figure {
  const char* exercise;  // "S1"
  std::string (*draw)();
};

#define FIGURE(id, name) {#id, draw_##name},
inline constexpr Figure kFigures[] = {HAIR_FIGURES};
#undef FIGURE

}  // namespace figures
