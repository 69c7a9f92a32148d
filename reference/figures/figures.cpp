// STAFF ONLY. The list of the exercises' figures; HAIR_FIGURES names them as FIGURE(S1) FIGURE(S2) ...
#include "reference/figures/figures.h"

namespace figures {

#define FIGURE(id) std::string draw_##id();
HAIR_FIGURES
#undef FIGURE

std::span<const Figure> all_figures() {
#define FIGURE(id) {#id, draw_##id},
  static constexpr Figure kFigures[] = {HAIR_FIGURES};
#undef FIGURE
  return kFigures;
}

}  // namespace figures
