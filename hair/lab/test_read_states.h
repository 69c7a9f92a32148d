// Reads states.bin (hair/lab/run/states_file.h), of runs that the tests make.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hair/lab/run/states_file.h"

namespace hair {

struct StateFrame {
  double time;  // s
  particles::State state;
};

struct StatesFile {
  std::vector<std::uint32_t> strands;  // the threes of coordinates of each strand
  std::uint32_t particles, coordinates;
  std::vector<StateFrame> frames;
  std::optional<LinksFile> links;  // none without a control mesh
};

// Throws for a file that is cut off, or longer than it says.
inline StatesFile read_states(const std::filesystem::path& file) {
  std::ifstream in;
  in.exceptions(std::ios::failbit | std::ios::badbit);
  in.open(file, std::ios::binary);
  const auto fill = [&](auto&& to) {
    in.read(reinterpret_cast<char*>(to.data()),
            static_cast<std::streamsize>(sizeof to[0]) * static_cast<std::streamsize>(to.size()));
    return to;
  };
  const auto expect = [&](bool right) {
    if (!right) throw std::runtime_error(file.string() + " is no file of states");
  };
  expect(fill(std::string(8, ' ')) == "HAIRRUN1");
  const auto header = fill(std::vector<std::uint32_t>(4));
  StatesFile states{fill(std::vector<std::uint32_t>(header[0])), header[1], header[3], {}, {}};
  expect(fill(std::string(header[0] % 2 * 4, ' ')).find_first_not_of('\0') == std::string::npos);
  const Eigen::Index numbers = 3 * Eigen::Index{states.particles};
  for (std::uint32_t k = 0; k < header[2]; ++k) {
    const double time = fill(std::vector<double>(1))[0];
    const Eigen::VectorXd x = fill(Eigen::VectorXd(numbers)), v = fill(Eigen::VectorXd(numbers));
    states.frames.push_back({time, {x, v}});
  }
  if (in.peek() == std::ifstream::traits_type::eof()) return states;
  expect(fill(std::string(8, ' ')) == "BROKEN 1");
  const auto counts = fill(std::vector<std::uint32_t>(2)),
             ends = fill(std::vector<std::uint32_t>(2 * counts[0]));
  const auto broken = fill(std::vector<std::uint64_t>(2 * counts[1]));
  expect(in.peek() == std::ifstream::traits_type::eof());
  states.links.emplace();
  for (std::size_t i = 0; i < ends.size(); i += 2)
    states.links->particles.push_back({static_cast<int>(ends[i]), static_cast<int>(ends[i + 1])});
  for (std::size_t i = 0; i < broken.size(); i += 2)
    states.links->broken.push_back({static_cast<long>(broken[i]), static_cast<int>(broken[i + 1])});
  return states;
}

}  // namespace hair
