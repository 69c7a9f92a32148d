// STAFF ONLY. Tests that the picture in the repository is the drawn one, and that its folders exist.
#include "grader/tests/architecture.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "hair/io/files/read_file.h"

namespace grader {
namespace {

const std::filesystem::path kProject = HAIR_PROJECT;

TEST(Architecture, ShowsRoomsThatAreThere) {
  for (const Room& room : rooms())
    EXPECT_TRUE(std::filesystem::is_directory(kProject / room.folder)) << room.folder;
}

TEST(Architecture, EveryRoomHasAWay) {
  for (const Room& room : rooms()) {
    bool has = false;
    for (const Arrow& arrow : arrows()) has = has || arrow.from == room.folder || arrow.to == room.folder;
    EXPECT_TRUE(has) << room.folder;
  }
}

TEST(Architecture, ThePictureIsAsItIsDrawn) {
  EXPECT_EQ(hair::bytes_of(kProject / "grader/architecture.svg"), architecture())
      << "draw it anew: build/release/grader/tests/draw_architecture grader/architecture.svg";
}

}  // namespace
}  // namespace grader
