// A run's folder appears whole or not at all, and no other files are lost; a film that fails stops no run.

#include <gtest/gtest.h>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/png.h"
#include "hair/lab/run/film.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/run/run_record.h"
#include "hair/lab/test_run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

void write_run(const fs::path& folder, const std::string& text) {
  OutputFolder out(folder);

  OutputFile record(out.now("run.json"), out.then("run.json"));
  record.write(std::string(kRunRecordBegin) + text);
  record.close();
  out.keep();
}

std::string why_refused(const fs::path& folder) {
  return tests::refusal<BadInput>([&] { OutputFolder out(folder); });
}

TEST(OutputFolderTest, IsThereWholeOrNotAtAll) {
  const TestFolder test;
  {
    const OutputFolder dropped(test / "out");
    EXPECT_EQ(test.names().size(), 1u) << "the hidden one";
  }
  EXPECT_TRUE(test.names().empty());
  write_run(test / "out", "1");
  EXPECT_EQ(test.names(), std::vector<std::string>{"out"});
}

TEST(OutputFolderTest, LeavesNoFoldersAboveItThatItMadeInVain) {
  const TestFolder test;
  { const OutputFolder dropped(test / "q/r/s"); }
  EXPECT_TRUE(test.names().empty());
  {
    const OutputFolder dropped(test / "q/r/s");
    test.write("q/notes.txt", "mine");
  }
  EXPECT_EQ(test.names("q"), std::vector<std::string>{"notes.txt"});
  EXPECT_TRUE(says(why_refused(test / "a/b" / std::string(300, 'x')), "can't be made"));
  EXPECT_EQ(test.names(), std::vector<std::string>{"q"});
  write_run(test / "q/r/s", "1");
  EXPECT_TRUE(fs::exists(test / "q/r/s/run.json"));
}

TEST(OutputFolderTest, ReplacesAnEarlierRunOnlyAtTheEnd) {
  const TestFolder test;
  write_run(test / "out", "1");
  test.write("out/frame-0012.png", "");
  {
    const OutputFolder dropped(test / "out");
    EXPECT_TRUE(fs::exists(test / "out/frame-0012.png"));
  }
  EXPECT_TRUE(fs::exists(test / "out/frame-0012.png"));
  write_run(test / "out", "2");
  EXPECT_EQ(test.names("out"), std::vector<std::string>{"run.json"});
  EXPECT_EQ(bytes_of(test / "out/run.json"), std::string(kRunRecordBegin) + "2");
  EXPECT_EQ(test.names(), std::vector<std::string>{"out"});
}

TEST(OutputFolderTest, ReplacesNothingElse) {
  const TestFolder test;
  test.write("file", "mine");
  EXPECT_TRUE(says(why_refused(test / "file"), "is a file"));
  EXPECT_NE(why_refused(test / "file/out"), "");
  EXPECT_NE(why_refused("/"), "");
  EXPECT_NE(why_refused("."), "");

  fs::create_directory(test / "mine");
  test.write("mine/notes.txt", "mine");
  EXPECT_TRUE(says(why_refused(test / "mine"), "not from hairlab run; "));
  test.write("mine/run.json", "{\"program\": \"another\"}");
  EXPECT_NE(why_refused(test / "mine"), "");

  write_run(test / "out", "1");
  for (const std::string name : {"notes.txt", "frame-.png", "frame-1a.png", "frame-0001.png.txt"}) {
    test.write("out/" + name, "mine");
    EXPECT_TRUE(says(why_refused(test / "out"), "holds " + name + ", which is not from hairlab run; "))
        << name;
    fs::remove(test / ("out/" + name));
  }
  EXPECT_EQ(why_refused(test / "out"), "");
  EXPECT_EQ(test.names(), (std::vector<std::string>{"file", "mine", "out"}));
}

TEST(OutputFolderTest, TakesAnEmptyFolderALinkAndASlashAtTheEnd) {
  const TestFolder test;
  fs::create_directory(test / "empty");
  write_run(test / "empty/", "1");
  EXPECT_TRUE(fs::exists(test / "empty/run.json"));
  fs::create_directory_symlink("empty", test / "link");
  write_run(test / "link", "2");
  EXPECT_TRUE(fs::is_symlink(test / "link"));
  EXPECT_EQ(bytes_of(test / "empty/run.json"), std::string(kRunRecordBegin) + "2");
}

// Remains of a killed run are removed; files of a process that still runs stay.
TEST(OutputFolderTest, RemovesTheRemainsOfWhatWasKilled) {
  const TestFolder test;
  const std::string dead = ".hairlab-out-" + std::to_string(1 << 22 | 1);  // above the largest process number
  fs::create_directory(test / dead);
  test.write(dead + "/states.bin", "");
  fs::create_directory(test / ".hairlab-out-1");
  fs::create_directory(test / ".hairlab-out-x");
  const OutputFolder out(test / "out");
  EXPECT_FALSE(fs::exists(test / dead));
  EXPECT_TRUE(fs::exists(test / ".hairlab-out-1"));
  EXPECT_TRUE(fs::exists(test / ".hairlab-out-x"));
}

TEST(OutputFolderTest, NamesFramesInOrder) {
  EXPECT_EQ(frame_name(0), "frame-0000.png");
  EXPECT_EQ(frame_name(123), "frame-0123.png");
  EXPECT_EQ(frame_name(12345), "frame-12345.png");
}

class Film : public testing::Test {
 protected:
  Film() : path_(std::getenv("PATH")) {
    for (int k = 0; k < 3; ++k) {
      Image image{17, 19, {}};  // odd, which most video runners can't show
      image.pixels.assign(3 * 17 * 19, static_cast<std::uint8_t>(80 * k));
      write_file(folder_ / ("frame-000" + std::to_string(k) + ".png"), encode_png(image));
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
