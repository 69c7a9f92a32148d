// The hairs on which strand models are compared: straight, wavy and curly, 20 cm of human hair, clamped. Each starts in its
// rest shape, level or hanging, and falls for kComparedTime.
#pragma once

#include <string>
#include <vector>

#include "hair/strand/strand_spec.h"

namespace hair::model_study {

inline constexpr double kComparedTime = 0.2;  // s
inline constexpr int kMoments = 4;            // at which lines are compared, the last one at the end

struct ComparedHair {
  std::string id, title;  // "curly", "Curly hair"
  StrandSpec spec;        // but for its elements
  std::vector<int>
      elements;  // of springs and links: multiples of the first one, whose points all of them have
  std::vector<int> helices;  // elements of super-helices: any numbers
  int fine;                  // elements of the reference's coarser chain, a multiple, too
};

// `quick`: fewer and coarser.
std::vector<ComparedHair> compared_hairs(bool quick);

}  // namespace hair::model_study
