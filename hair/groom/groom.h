// Groomed hair: each strand is a list of points.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hair {

// The limit for all points of a groom together: 200,000 strands of 100 points.
inline constexpr long kMostGroomPoints = 20'000'000;

// The look of a groom, as .hair files describe it. Other formats hold less of it.
struct GroomLook {
  // The same for all points; without a value it is not known.
  std::optional<float> thickness = {};  // the diameter, in the groom's unit
  std::optional<float> transparency = {};
  std::optional<std::array<float, 3>> colour = {};
  // One for each point, strand after strand; empty: all points have the values above.
  std::vector<float> thicknesses = {}, transparencies = {};
  std::vector<float> colours = {};  // 3 for each point
  std::array<char, 88> info = {};
  bool own_segments = false;   // a file lists the segments of each strand, even if all have the same number
  std::uint32_t segments = 0;  // the header's number in such a file; it has no meaning
};

// A part of a look: `size` numbers for all points together, or for each point.
struct LookPart {
  const char* name;
  std::size_t size;
  std::span<const float> of_all, of_each;

  std::span<const float> numbers() const { return of_each.empty() ? of_all : of_each; }
  bool is_known() const { return !numbers().empty(); }
};

// Thickness, transparency and colour; they point into `look`.
inline std::array<LookPart, 3> parts_of(const GroomLook& look) {
  const auto one = [](const std::optional<float>& number) {
    return number ? std::span(&*number, 1) : std::span<const float>();
  };
  return {{{"thickness", 1, one(look.thickness), look.thicknesses},
           {"transparency", 1, one(look.transparency), look.transparencies},
           {"colour", 3, look.colour ? std::span<const float>(*look.colour) : std::span<const float>(),
            look.colours}}};
}

// The numbers of each point, in the order of parts_of; they point into `look`.
inline std::array<std::vector<float>*, 3> numbers_of_points(GroomLook& look) {
  return {&look.thicknesses, &look.transparencies, &look.colours};
}

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

// A reader's treatment of a number that is not finite, or too large for 32 bits.
enum class Numbers {
  finite,  // refuses it
  any      // keeps it, for a report of what is wrong with a file
};

}  // namespace hair
