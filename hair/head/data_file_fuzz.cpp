// Hostile bytes as a .data file. What is accepted is written as it was, byte for byte.
#include "hair/head/data_file.h"
#include "hair/head/groom_bytes.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"

void fuzz::try_input(std::string_view bytes) {
  hair::Groom groom;
  try {
    groom = hair::parse_data_file(bytes, "a.data");
  } catch (const hair::BadInput& error) {
    expect_readable(error.what());
    expect(std::string_view(error.what()).starts_with("a.data: "), "a message begins with the file's name");
    return;
  }
  for (const Eigen::VectorXd& x : groom.strands) {
    expect(x.size() >= 3 && x.size() % 3 == 0, "a strand has a point or more");
    expect(x.allFinite(), "points are finite");
  }
  expect(hair::data_file_of(groom) == bytes, "a file that is read and written is the same");
}

// A bald root is 16 bytes, and 40 in memory; what is written grows to twice its size.
std::size_t fuzz::most_memory(std::size_t input) {
  return 10'000 + 10 * input;
}

std::vector<std::string> fuzz::seeds() {
  const auto file = [](std::initializer_list<std::uint32_t> counts) {
    std::string bytes;
    hair::put_number(bytes, static_cast<std::uint32_t>(counts.size()));
    for (const std::uint32_t count : counts) {
      hair::put_number(bytes, count);
      for (std::uint32_t k = 0; k < 3 * count; ++k) hair::put_real(bytes, static_cast<float>(k));
    }
    return bytes;
  };
  return {file({1}), file({2, 3}), file({1, 4, 1, 2})};
}
