// For a program without an engine.
#include "hair/lab/head/moving_head.h"

namespace hair::head_study {

bool has_fast_head() {
  return false;
}

std::unique_ptr<MovingHead> fast_head(const GrownHead&, std::span<const std::size_t>,
                                      const MovingHeadSettings&) {
  return nullptr;
}

}  // namespace hair::head_study
