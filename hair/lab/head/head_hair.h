// The hair of a head that is simulated strand by strand: its style on the bust, and its rest shape.
#pragma once

#include <string>
#include <vector>

#include "hair/head/bust.h"
#include "hair/head/hair_style.h"

namespace hair::head_study {

struct HeadHair {
  std::string id, title;  // "curly", "Curly hair"
  HairStyle style;
  int points;   // per strand
  bool curved;  // its rest shape is the grown one; else it is straight, and falls onto the head
};

// Straight hair; straight hair without random differences between strands (directions, lengths, clumps,
// fly-aways); wavy and curly hair.
const std::vector<HeadHair>& head_hairs();

// Strands of `points` points each, in metres, in the head's axes.
struct GrownHead {
  const HeadHair* hair = nullptr;
  std::vector<RootFrame> roots;          // axis: the scalp's normal
  std::vector<Eigen::VectorXd> strands;  // 3 points each
  double length = 0;                     // m, the mean of the strands'
};

// The same strands each time. Throws std::invalid_argument as grow_groom does.
GrownHead grow_head(const Bust& bust, const HeadHair& hair, int strands);

// The roots of `guides` strands that are well spread: ascending indices. All of them if there are no more.
std::vector<std::size_t> choose_guides(const GrownHead& head, int guides);

}  // namespace hair::head_study
