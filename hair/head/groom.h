// Groomed hair: each strand is a list of points.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace hair {

// The limit for all points of a groom together: 200,000 strands of 100 points.
inline constexpr long kMostGroomPoints = 20'000'000;

// How a groom looks, as .hair files say it. Other formats have less of it.
struct GroomLook {
  float thickness = 1;  // the diameter, in the groom's unit
  float transparency = 0;
  std::array<float, 3> colour = {1, 1, 1};
  // Of each point, strand after strand; empty: all points have the values above.
  std::vector<float> thicknesses = {}, transparencies = {};
  std::vector<float> colours = {};  // 3 for each point
  std::array<char, 88> info = {};
  bool own_segments = false;   // a file lists the segments of each strand, even where all have the same
  std::uint32_t segments = 0;  // what its header says then; it has no meaning
};

struct Groom {
  std::vector<Eigen::VectorXd> strands;  // 3n numbers each, n >= 1, from the root to the tip; in the file's
                                         // unit. n = 1: a bald root, where no hair grows
  GroomLook look = {};
};

inline Eigen::Index points_of(const Eigen::VectorXd& strand) {
  return strand.size() / 3;
}

inline long points_of(const Groom& groom) {
  long points = 0;
  for (const Eigen::VectorXd& x : groom.strands) points += points_of(x);
  return points;
}

// What a reader does with a number that is not finite, or too large for 32 bits.
enum class Numbers {
  finite,  // refuses it
  any      // keeps it, for a report of what is wrong with a file
};

}  // namespace hair
