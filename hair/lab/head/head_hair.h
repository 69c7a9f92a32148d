// The hair of a head that is simulated strand by strand: what grows on the bust, and what it is at rest.
#pragma once

#include <string>
#include <vector>

#include "hair/head/bust.h"
#include "hair/head/hair_style.h"

namespace hair::head_study {

struct HeadHair {
  std::string id, title;  // "curly", "Curly hair"
  HairStyle style;
  int points;   // of each strand
  bool curved;  // at rest it is what it grew to; else straight, and lies as its weight and the head let it
};

// Straight hair; the same without what differs from strand to strand by chance: directions, lengths, clumps,
// strands that fly away; wavy and curly hair.
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

// The roots of some of them that are well spread: rising indices. All of them if there are no more.
std::vector<std::size_t> choose_guides(const GrownHead& head, int guides);

}  // namespace hair::head_study
