// states.bin and states.csv as they are written and read.
#include "hair/lab/run/states_file.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cstring>
#include <limits>
#include <sstream>

#include "hair/io/files/bad_input.h"
#include "hair/lab/run/states_csv.h"
#include "hair/lab/tests/run_hairlab.h"

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

class StatesOf : public testing::TestWithParam<std::vector<int>> {};

INSTANTIATE_TEST_SUITE_P(All, StatesOf,
                         testing::Values(std::vector<int>{}, std::vector<int>{1}, std::vector<int>{4, 2},
                                         std::vector<int>{3, 1, 5}));

TEST_P(StatesOf, StrandsAndToysReadBackAsTheyWere) {
  const TestFolder folder;
  int particles = 2;  // a toy's
  for (const int size : GetParam()) particles += size;
  StatesWriter writer(folder / "states.bin", "states.bin", GetParam(), particles);
  for (int k = 0; k < 3; ++k) writer.add(0.1 * k, state_of(particles, k));
  writer.close();

  const StatesFile read = read_states(folder / "states.bin");
  EXPECT_EQ(read.strands, GetParam());
  EXPECT_EQ(read.particles, particles);
  ASSERT_EQ(read.frames.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(read.frames[k].time, 0.1 * k);
    EXPECT_EQ(read.frames[k].state.x, state_of(particles, k).x);
    EXPECT_EQ(read.frames[k].state.v, state_of(particles, k).v);
  }
}

// A change of any of the header's numbers, and of the length, is found before memory is taken for it.
TEST(StatesFileTest, RefusesWhatIsNotWhole) {
  const TestFolder folder;
  StatesWriter writer(folder / "states.bin", "states.bin", {2, 1}, 4);
  for (int k = 0; k < 2; ++k) writer.add(k, state_of(4, k));
  writer.close();
  const std::string good = bytes_of(folder / "states.bin");
  ASSERT_EQ(good.size(), 24 + 8 + 2 * (1 + 24) * 8u);

  const auto refuses = [&](const std::string& bytes) {
    try {
      read_states(folder.write("bad.bin", bytes));
      return false;
    } catch (const BadInput& error) {
      return std::string(error.what()).starts_with((folder / "bad.bin").string() + ": ");
    }
  };
  EXPECT_THROW(read_states(folder / "none.bin"), BadInput);
  for (const std::size_t size : {std::size_t{0}, std::size_t{23}, good.size() - 1, good.size() / 2})
    EXPECT_TRUE(refuses(good.substr(0, size))) << size;
  EXPECT_TRUE(refuses(good + '\0'));
  EXPECT_TRUE(refuses("h" + good.substr(1)));
  for (const int at : {8, 12, 16})
    for (const std::uint32_t value : {0U, 1U, 3U, 5U, 0x7fffffffU, 0xffffffffU}) {
      std::string bad = good;
      std::memcpy(bad.data() + at, &value, sizeof value);
      EXPECT_TRUE(refuses(bad)) << "byte " << at << ", " << value;
    }
  for (const std::uint32_t unknown : {3U, 7U, 0xffffffffU}) {
    std::string bad = good;
    std::memcpy(bad.data() + 20, &unknown, sizeof unknown);
    EXPECT_TRUE(refuses(bad)) << "coordinates of the kind " << unknown;
  }
  for (const int at : {24, 28})
    for (const std::uint32_t value : {0U, 5U, 0xfffffffeU}) {
      std::string bad = good;
      std::memcpy(bad.data() + at, &value, sizeof value);
      EXPECT_TRUE(refuses(bad)) << "byte " << at << ", " << value;
    }
}

LinksFile three_links() {
  return {{{0, 2}, {1, 2}, {3, 0}}, {{4, 1}, {4, 2}, {9, 0}}};
}

TEST(StatesFileTest, KeepsWhichLinksBrokeWhen) {
  const TestFolder folder;
  for (const bool broken : {true, false}) {
    LinksFile links = three_links();
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

TEST(StatesFileTest, RefusesLinksThatCantBe) {
  const TestFolder folder;
  StatesWriter writer(folder / "states.bin", "states.bin", {3, 1}, 4);
  writer.add(three_links());
  writer.close();
  const std::string good = bytes_of(folder / "states.bin");
  const std::size_t links = 24 + 8, ends = links + 16, broken = ends + 8 * 3;
  ASSERT_EQ(good.size(), broken + 16 * 3);
  const auto refuses = [&](std::size_t at, std::uint32_t value) {
    std::string bad = good;
    std::memcpy(bad.data() + at, &value, sizeof value);
    try {
      read_states(folder.write("bad.bin", bad));
      return false;
    } catch (const BadInput& error) {
      return true;
    }
  };
  EXPECT_TRUE(refuses(links, 0)) << "other letters";
  for (const std::uint32_t count : {0U, 2U, 4U, 0xffffffffU}) {
    EXPECT_TRUE(refuses(links + 8, count)) << count << " links";
    EXPECT_TRUE(refuses(links + 12, count)) << count << " that broke";
  }
  for (const std::uint32_t particle : {4U, 0xffffffffU}) EXPECT_TRUE(refuses(ends + 4, particle)) << particle;
  EXPECT_TRUE(refuses(broken, 0)) << "steps count from 1";
  EXPECT_TRUE(refuses(broken + 16, 3)) << "a step before the last";
  EXPECT_TRUE(refuses(broken + 16 + 8, 1)) << "a link twice in a step";
  EXPECT_TRUE(refuses(broken + 32 + 8, 3)) << "a link that is not there";
  EXPECT_TRUE(refuses(broken + 4, 1U << 31)) << "a step beyond all";
  for (const std::size_t size : {links + 1, links + 15, broken - 1, good.size() - 1})
    EXPECT_THROW(read_states(folder.write("bad.bin", good.substr(0, size))), BadInput) << size;
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
