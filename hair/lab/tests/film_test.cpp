// Films: with ffmpeg, without it, and with one that fails.
#include "hair/lab/run/film.h"

#include <gtest/gtest.h>

#include "hair/io/image/png.h"
#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

class Film : public testing::Test {
 protected:
  Film() : path_(std::getenv("PATH")) {
    for (int k = 0; k < 3; ++k) {
      Image image{17, 19, {}};  // odd, which most video runners can't show
      image.pixels.assign(3 * 17 * 19, static_cast<std::uint8_t>(80 * k));
      write_png(folder_ / ("frame-000" + std::to_string(k) + ".png"), image);
    }
  }
  ~Film() override { setenv("PATH", path_.c_str(), 1); }

  void write_program(const std::string& text) const {
    fs::create_directory(folder_ / "bin");
    fs::permissions(folder_.write("bin/ffmpeg", "#!/bin/sh\n" + text), fs::perms::owner_all);
    setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }

  TestFolder folder_;
  std::string path_;
};

TEST_F(Film, IsAnMp4AndTheSameTwice) {
  if (!find_ffmpeg()) GTEST_SKIP() << "ffmpeg is not on PATH";
  ASSERT_EQ(make_film(folder_.path(), 29.97), std::nullopt);
  const std::string first = bytes_of(folder_ / "film.mp4");
  EXPECT_EQ(first.substr(4, 4), "ftyp");
  EXPECT_FALSE(fs::exists(folder_ / "film.errors"));
  ASSERT_EQ(make_film(folder_.path(), 29.97), std::nullopt);
  EXPECT_EQ(bytes_of(folder_ / "film.mp4"), first);
}

TEST_F(Film, IsLeftOutWithoutFfmpeg) {
  setenv("PATH", folder_.path().c_str(), 1);
  EXPECT_EQ(make_film(folder_.path(), 30), "ffmpeg is not on PATH (package ffmpeg brings it)");
  fs::create_directory(folder_ / "ffmpeg");
  EXPECT_EQ(find_ffmpeg(), std::nullopt) << "a folder is no program";
}

TEST_F(Film, LeavesNothingOfAFilmThatFails) {
  write_program("echo half > film.mp4; echo 'no room for films' >&2; exit 7\n");
  EXPECT_EQ(make_film(folder_.path(), 30),
            "ffmpeg failed (exit code 7: no room for films); the pictures are there");
  EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
  EXPECT_FALSE(fs::exists(folder_ / "film.errors"));
  write_program("kill -9 $$\n");
  EXPECT_EQ(make_film(folder_.path(), 30),
            "ffmpeg failed (it was ended from outside); the pictures are there");
  write_program("exit 0\n");
  EXPECT_NE(make_film(folder_.path(), 30), std::nullopt) << "it has made none";
}

TEST_F(Film, DoesNotStopARun) {
  write_program("exit 7\n");
  const std::string scene =
      folder_.write("scene.json", R"({"shows": "x", "frames": 1, "hair": [{"segments": 2,
    "length": 0.02, "roots": {"list": [{"position": [0, 0, 0]}]}}],
    "render": {"image_width": 32, "image_height": 32}})");
  const ProgramRun run = run_hairlab({"run", scene, "--out", (folder_ / "out").string()});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.errors, "no film: ffmpeg failed (exit code 7); the pictures are there\n");
  EXPECT_TRUE(fs::exists(folder_ / "out/frame-0001.png"));
  EXPECT_TRUE(fs::exists(folder_ / "out/run.json"));
}

}  // namespace
}  // namespace hair
