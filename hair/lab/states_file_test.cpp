// states.bin and states.csv have the numbers of the run.
#include <gtest/gtest.h>

#include <charconv>
#include <limits>
#include <sstream>

#include "hair/lab/run/states_file.h"
#include "hair/lab/test_read_states.h"
#include "hair/lab/test_run_hairlab.h"

namespace hair {
namespace {

// Numbers that need all of their digits.
particles::State state_of(int particles, double seed) {
  particles::State state{Eigen::VectorXd(3 * particles), Eigen::VectorXd(3 * particles)};
  for (int i = 0; i < 3 * particles; ++i) {
    state.x[i] = std::sin(seed + i) / 3;
    state.v[i] = std::exp(seed - i) / 7;
  }
  state.x[0] = -0.0;
  state.v[0] = std::numeric_limits<double>::denorm_min();
  return state;
}

TEST(StatesFileTest, StrandsAndToysReadBackAsTheyWere) {
  const TestFolder folder;
  for (const std::vector<int>& strands : {std::vector<int>{}, {1}, {4, 2}, {3, 1, 5}}) {
    int particles = 2;  // a toy's
    for (const int size : strands) particles += size;
    StatesWriter writer(folder / "states.bin", "states.bin", strands, particles);
    for (int k = 0; k < 3; ++k) writer.add(0.1 * k, state_of(particles, k));
    writer.close();

    const StatesFile read = read_states(folder / "states.bin");
    EXPECT_EQ(read.strands, std::vector<std::uint32_t>(strands.begin(), strands.end()));
    EXPECT_EQ(read.particles, static_cast<std::uint32_t>(particles));
    ASSERT_EQ(read.frames.size(), 3u);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(read.frames[k].time, 0.1 * k);
      EXPECT_EQ(read.frames[k].state.x, state_of(particles, k).x);
      EXPECT_EQ(read.frames[k].state.v, state_of(particles, k).v);
    }
  }
}

TEST(StatesFileTest, KeepsWhichLinksBrokeWhen) {
  const TestFolder folder;
  for (const bool broken : {true, false}) {
    LinksFile links{{{0, 2}, {1, 2}, {3, 0}}, {{4, 1}, {4, 2}, {9, 0}}};
    if (!broken) links.broken.clear();
    StatesWriter writer(folder / "states.bin", "states.bin", {3, 1}, 4);
    writer.add(0, state_of(4, 0));
    writer.add(links);
    writer.close();
    const StatesFile read = read_states(folder / "states.bin");
    EXPECT_EQ(read.frames.size(), 1U);
    ASSERT_TRUE(read.links);
    EXPECT_EQ(read.links->particles, links.particles);
    EXPECT_EQ(read.links->broken, links.broken);
  }
}

TEST(StatesCsvTest, HoldsTheSameNumbersWithAStrandForHairAndNoneForToys) {
  const TestFolder folder;
  const particles::State state = state_of(4, 0.5);
  CsvWriter writer(folder / "states.csv", "states.csv", {2, 1});
  writer.add(0, state);
  writer.add(1.0 / 3, state);
  writer.close();

  std::istringstream lines(bytes_of(folder / "states.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line + "\n", kCsvHead);
  const std::vector<std::string> places = {"0,0", "0,1", "1,0", ",0"};
  for (int frame = 0; frame < 2; ++frame)
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(std::getline(lines, line));
      const std::string begin =
          std::to_string(frame) + (frame == 0 ? ",0," : ",0.3333333333333333,") + places[i] + ",";
      ASSERT_TRUE(line.starts_with(begin)) << line;
      std::istringstream fields(line.substr(begin.size()));
      for (int k = 0; k < 6; ++k) {
        std::string field;
        std::getline(fields, field, ',');
        double number = 0;
        std::from_chars(field.data(), field.data() + field.size(), number);
        EXPECT_EQ(number, k < 3 ? state.x[3 * i + k] : state.v[3 * i + k - 3]) << line;
      }
    }
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace hair
