#include "hair/groom/groom_edit.h"

#include <utility>

namespace hair {

void scale(Groom& groom, double factor) {
  for (Eigen::VectorXd& x : groom.strands) x *= factor;
  const auto to_unit = [&](float& thickness) {
    thickness = static_cast<float>(factor * static_cast<double>(thickness));
  };
  if (groom.look.thickness) to_unit(*groom.look.thickness);
  for (float& thickness : groom.look.thicknesses) to_unit(thickness);
}

void keep_every(Groom& groom, long every) {
  GroomLook& look = groom.look;
  std::vector<Eigen::VectorXd> strands;
  std::vector<float> thicknesses, transparencies, colours;
  std::size_t first = 0;
  for (std::size_t i = 0; i < groom.strands.size(); ++i) {
    const auto points = static_cast<std::size_t>(points_of(groom.strands[i]));
    if (i % static_cast<std::size_t>(every) == 0) {
      strands.push_back(std::move(groom.strands[i]));
      const auto copy = [&](std::vector<float>& to, const std::vector<float>& from, std::size_t size) {
        if (from.empty()) return;
        const auto begin = from.begin() + static_cast<std::ptrdiff_t>(size * first);
        to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(size * points));
      };
      copy(thicknesses, look.thicknesses, 1);
      copy(transparencies, look.transparencies, 1);
      copy(colours, look.colours, 3);
    }
    first += points;
  }
  groom.strands = std::move(strands);
  look.thicknesses = std::move(thicknesses);
  look.transparencies = std::move(transparencies);
  look.colours = std::move(colours);
}

}  // namespace hair
