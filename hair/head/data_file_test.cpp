#include "hair/head/data_file.h"

#include <gtest/gtest.h>

#include "hair/head/groom_bytes.h"
#include "hair/head/refusal.h"

namespace hair {
namespace {

// Two strands: a bald root, and one of two points.
std::string small_file() {
  std::string bytes;
  put_number(bytes, 2);
  put_number(bytes, 1);
  for (const float number : {7.0F, 8.0F, 9.0F}) put_real(bytes, number);
  put_number(bytes, 2);
  for (const float number : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}) put_real(bytes, number);
  return bytes;
}

std::string with_number(std::size_t at, std::uint32_t number) {
  std::string bytes = small_file(), four;
  put_number(four, number);
  return bytes.replace(at, 4, four);
}

std::string data_complaint(const std::string& bytes) {
  return refusal([&] { parse_data_file(bytes, "a.data"); });
}

TEST(DataFile, HasStrandsAndBaldRoots) {
  const Groom groom = parse_data_file(small_file(), "a.data");
  ASSERT_EQ(groom.strands.size(), 2U);
  EXPECT_EQ(groom.strands[0], (Eigen::VectorXd(3) << 7, 8, 9).finished());
  EXPECT_EQ(groom.strands[1], (Eigen::VectorXd(6) << 1, 2, 3, 4, 5, 6).finished());
  EXPECT_EQ(data_file_of(groom), small_file());
}

TEST(DataFile, ACutOrALongerFileSaysWhere) {
  const std::string whole = small_file();
  EXPECT_EQ(data_complaint(whole.substr(0, 3)),
            "a.data: is not a .data file, which begins with the number of its strands, 4 bytes");
  EXPECT_EQ(
      data_complaint(whole.substr(0, 47)),
      "a.data: byte 20: strand 1 says that it has 2 points; the bytes after it hold 1, and a strand has "
      "one at least");
  EXPECT_EQ(data_complaint(whole + "xy"),
            "a.data: byte 48: has 2 bytes after its last strand; a .data file ends there");
}

TEST(DataFile, CountsThatLieAreRefusedBeforeThereIsMemoryForThem) {
  EXPECT_EQ(data_complaint(with_number(0, 0xffffffff)),
            "a.data: byte 0: says that there are -1 strands; a file of 48 bytes has 1 to 2");
  EXPECT_EQ(data_complaint(with_number(0, 2000000000)),
            "a.data: byte 0: says that there are 2000000000 strands; a file of 48 bytes has 1 to 2");
  EXPECT_EQ(data_complaint(with_number(0, 0)),
            "a.data: byte 0: says that there are 0 strands; a file of 48 bytes has 1 to 2");
  EXPECT_EQ(data_complaint(with_number(0, 2).substr(0, 19)),
            "a.data: byte 0: says that there are 2 strands; a file of 19 bytes has none");
  EXPECT_EQ(data_complaint(with_number(4, 0x7fffffff)),
            "a.data: byte 4: strand 0 says that it has 2147483647 points; the bytes after it hold 3, and a "
            "strand has one at least");
  EXPECT_NE(data_complaint(with_number(4, 0)), "");
}

}  // namespace
}  // namespace hair
