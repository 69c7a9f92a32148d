// STAFF ONLY. Tests hairgrade compare as a TA uses it.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "grader/compare/compare.h"
#include "grader/compare/test_pictures.h"
#include "grader/tests/broken_links.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/image/read_png.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using hair::Image;
using nlohmann::json;
using std::string;

constexpr int kWidth = 96, kHeight = 64;

Image frame(int shift) {
  return strands(kWidth, kHeight, 10, shift);
}

class Comparing : public testing::Test {
 protected:
  string path(const string& name) const { return (folder_ / name).string(); }
  string out() const { return path("out"); }
  string put(const string& name, const Image& image) const {
    hair::write_png(folder_ / name, image);
    return path(name);
  }

  // Makes two folders: one frame is the same, one near, one far, and each folder lacks one of the other's.
  void two_folders() const {
    put("a/frame-0001.png", frame(0));
    put("b/frame-0001.png", frame(0));
    put("a/frame-0002.png", frame(0));
    put("b/frame-0002.png", frame(1));
    put("a/frame-0003.png", frame(0));
    put("b/frame-0003.png", frame(40));
    put("a/frame-0004.png", frame(0));
    put("b/frame-0005.png", frame(0));
  }

  ProgramRun compare(std::vector<string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run_hairgrade(arguments);
  }

  // Expects exit code 2, one line with these words, and no files.
  void expect_refused(const std::vector<string>& arguments, const std::vector<string>& words) const {
    std::vector<string> with_out = arguments;
    if (std::find(arguments.begin(), arguments.end(), "--out") == arguments.end())
      with_out.insert(with_out.end(), {"--out", out()});
    const ProgramRun run = compare(with_out);
    EXPECT_EQ(run.code, 2) << run.errors;
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    for (const string& word : words)
      EXPECT_NE(run.errors.find(word), string::npos) << "no \"" << word << "\" in: " << run.errors;
    EXPECT_FALSE(fs::exists(out()));
  }

  static std::map<string, string> files(const fs::path& folder) {
    std::map<string, string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      all[fs::relative(entry.path(), folder).string()] = hair::bytes_of(entry.path());
    return all;
  }

  hair::TemporaryFolder temporary_{"comparing-test"};
  fs::path folder_ = temporary_.path();
};

TEST_F(Comparing, TwoPicturesGiveTheirDistances) {
  const string a = put("a.png", frame(0)), b = put("b.png", frame(3));
  const PictureDistance expected = compare_pictures(frame(0), frame(3));
  const ProgramRun run = compare({a, b, "--json"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  const json pairs = json::parse(run.output).at("pairs");
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].at("name"), "b.png");
  EXPECT_EQ(pairs[0].at("width"), kWidth);
  EXPECT_EQ(pairs[0].at("height"), kHeight);
  EXPECT_EQ(pairs[0].at("identical"), false);
  EXPECT_EQ(pairs[0].at("blurred_rmse"), expected.blurred_rmse);
  EXPECT_EQ(pairs[0].at("flip_mean"), expected.flip_mean);
  EXPECT_EQ(pairs[0].at("flip_max"), expected.flip_max);

  char line[100];
  snprintf(line, sizeof line, "\nb.png    %12.4f  %6.4f  %8.4f\n", expected.blurred_rmse, expected.flip_mean,
           expected.flip_max);
  const ProgramRun table = compare({a, b});
  EXPECT_NE(table.output.find(line), string::npos) << table.output << line;
  EXPECT_EQ(compare({a, a}).output, "1 of 1 the same, pixel for pixel\n");
}

TEST_F(Comparing, FoldersAreSortedWorstFirstAndWhatIsMissingIsNamed) {
  two_folders();
  const ProgramRun run = compare({path("a"), path("b")});
  EXPECT_EQ(run.code, 3) << run.errors;
  const std::size_t far = run.output.find("\nframe-0003.png"), near = run.output.find("\nframe-0002.png");
  ASSERT_NE(far, string::npos) << run.output;
  ASSERT_NE(near, string::npos);
  EXPECT_LT(far, near);
  for (const string& words :
       {string("1 of 3 the same, pixel for pixel\n"), "only in " + path("a") + ": frame-0004.png\n",
        "only in " + path("b") + ": frame-0005.png\n"})
    EXPECT_NE(run.output.find(words), string::npos) << run.output << words;
  EXPECT_LT(run.output.find("only in"), far);

  const json all = json::parse(compare({path("a"), path("b"), "--json"}).output);
  ASSERT_EQ(all.at("pairs").size(), 3u);
  EXPECT_EQ(all.at("pairs")[0].at("name"), "frame-0003.png");
  EXPECT_EQ(all.at("pairs")[2].at("identical"), true);
  EXPECT_EQ(all.at("only_in_first"), json::array({"frame-0004.png"}));
  EXPECT_EQ(all.at("only_in_second"), json::array({"frame-0005.png"}));
}

TEST_F(Comparing, PicturesAndAPageAreWritten) {
  two_folders();
  const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
  EXPECT_EQ(run.code, 3) << run.errors;
  EXPECT_TRUE(run.output.ends_with(out() + "/index.html\n")) << run.output;
  const std::map<string, string> written = files(out());
  std::vector<string> names;
  for (const auto& [name, bytes] : written) names.push_back(name);
  EXPECT_EQ(names, (std::vector<string>{"frame-0001-side.png", "frame-0002-heat.png", "frame-0002-side.png",
                                        "frame-0003-heat.png", "frame-0003-side.png", "index.html"}));
  const Image heat = hair::read_png(out() + "/frame-0003-heat.png");
  EXPECT_EQ(heat.width, kWidth);
  EXPECT_EQ(heat.height, kHeight);
  EXPECT_EQ(hair::read_png(out() + "/frame-0003-side.png").width, 3 * kWidth + 2 * 8);
  const string page = written.at("index.html");
  EXPECT_LT(page.find("<strong>frame-0003.png"), page.find("<strong>frame-0002.png"));
  for (std::size_t at = page.find("src="); at != string::npos; at = page.find("src=", at + 1)) {
    EXPECT_TRUE(page.substr(at).starts_with("src=\"data:image/png;base64,")) << page.substr(at, 40);
  }
  EXPECT_EQ(page.find("http"), page.find("http-equiv"));
  EXPECT_EQ(broken_links(out()), std::vector<string>());
}

TEST_F(Comparing, AgainItGivesTheSameBytes) {
  two_folders();
  for (const char* folder : {"first", "second", "second"})
    ASSERT_EQ(compare({path("a"), path("b"), "--out", path(folder)}).code, 3);
  EXPECT_EQ(files(path("first")), files(path("second")));
}

TEST_F(Comparing, StrangeNamesAreWrittenAsTheyAreAndShownSafely) {
  const string name = "<b>#1 50%?\x1b[31m.png";
  put("a/" + name, frame(0));
  put("b/" + name, frame(1));
  const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.output.find('\x1b'), string::npos);
  EXPECT_TRUE(fs::exists(out() + "/<b>#1 50%?\x1b[31m-heat.png"));
  const string page = hair::bytes_of(out() + "/index.html");
  EXPECT_EQ(page.find("<b>"), string::npos);
  EXPECT_NE(page.find("href=\"%3Cb%3E%231%2050%25%3F%1B%5B31m-heat.png\""), string::npos);
  EXPECT_EQ(broken_links(out()), std::vector<string>());
}

TEST_F(Comparing, WhatIsNoPairIsRefused) {
  two_folders();
  const string picture = put("picture.png", frame(0));
  fs::create_directory(folder_ / "empty");
  put("c/other.png", frame(0));
  expect_refused({path("a")}, {"B", "--help"});
  expect_refused({path("a"), path("nowhere")}, {path("nowhere"), "No such file"});
  expect_refused({path("nowhere"), path("a")}, {path("nowhere"), "No such file"});
  expect_refused({path("a"), picture}, {path("a") + " is a folder", picture + " is a file"});
  expect_refused({picture, path("a")}, {picture + " is a file", path("a") + " is a folder"});
  expect_refused({path("a"), path("empty")}, {path("empty"), "*.png"});
  expect_refused({path("a"), path("c")}, {path("a"), path("c"), "other.png", "names"});
  expect_refused({path("a"), "/dev/null"}, {"/dev/null", "neither"});
}

TEST_F(Comparing, TwoPicturesThatCanNotBeComparedAreRefused) {
  const string a = put("a.png", frame(0)), b = put("b.png", strands(kWidth, kHeight + 1, 10));
  expect_refused({a, b}, {a, "96 x 64", b, "96 x 65"});
  std::ofstream(b, std::ios::binary) << "no picture";
  expect_refused({a, b}, {b, "is not a PNG picture"});
}

// Each row replaces b's frame 2. The other frames are compared all the same.
TEST_F(Comparing, APictureThatCanNotBeComparedIsNamedAndWorst) {
  two_folders();
  const string bad = path("b/frame-0002.png"), whole = hair::bytes_of(bad);
  const auto write = [&](const string& bytes) { std::ofstream(bad, std::ios::binary) << bytes; };
  const std::vector<std::pair<string, std::function<void()>>> rows = {
      {"96 x 65", [&] { put("b/frame-0002.png", strands(kWidth, kHeight + 1, 10)); }},
      {"is not a PNG picture", [&] { write(""); }},
      {"is not a PNG picture", [&] { write("no picture"); }},
      {"can't be decoded", [&] { write(whole.substr(0, whole.size() / 2)); }},
      {"No such file", [&] { fs::create_symlink("nowhere", bad); }},
      {"Is a directory", [&] { fs::create_directory(bad); }}};
  for (const auto& [why, put_there] : rows) {
    SCOPED_TRACE(why);
    fs::remove(bad);
    put_there();
    const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
    EXPECT_EQ(run.code, 3) << run.errors;
    const std::size_t at = run.output.find("not compared: frame-0002.png: " + path("")),
                      far = run.output.find("\nframe-0003.png");
    EXPECT_LT(at, far) << run.output;
    EXPECT_NE(far, string::npos) << run.output;
    EXPECT_NE(run.output.find(why, at), string::npos) << run.output;
    EXPECT_NE(run.output.find("1 of 2 the same"), string::npos) << run.output;
    EXPECT_NE(hair::bytes_of(out() + "/index.html").find("not compared: " + path("")), string::npos);
    EXPECT_EQ(broken_links(out()), std::vector<string>());
    const json pairs = json::parse(compare({path("a"), path("b"), "--json"}).output).at("pairs");
    EXPECT_EQ(pairs.at(0).at("name"), "frame-0002.png");
    EXPECT_NE(pairs.at(0).at("not_compared").get<string>().find(why), string::npos);
    EXPECT_EQ(pairs.at(1).at("name"), "frame-0003.png");
  }
}

TEST_F(Comparing, TheCaseOfTheEndingDoesNotMatter) {
  put("a/upper.PNG", frame(0));
  put("b/upper.PNG", frame(1));
  put("a/mixed.png", frame(0));
  put("b/mixed.Png", frame(2));
  put("a/both.png", frame(0));
  put("b/both.png", frame(0));
  put("a/both.PNG", frame(0));
  put("b/both.PNG", frame(40));
  const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
  EXPECT_EQ(run.code, 0) << run.output << run.errors;
  for (const char* const line : {"\nupper.PNG  ", "\nmixed.Png  ", "\nboth.PNG  ", "\n1 of 4 the same"})
    EXPECT_NE(run.output.find(line), string::npos) << line << run.output;
  EXPECT_EQ(hair::read_png(out() + "/both.PNG-side.png").height, kHeight);
  EXPECT_TRUE(fs::exists(out() + "/both-side.png"));
  EXPECT_EQ(broken_links(out()), std::vector<string>());
}

TEST_F(Comparing, AFolderThatCanNotBeWrittenIsNamedAndWhatWasThereStays) {
  two_folders();
  std::ofstream(path("file")) << "kept";
  expect_refused({path("a"), path("b"), "--out", path("file")}, {path("file"), "Not a directory"});
  expect_refused({path("a"), path("b"), "--out", path("file/in")}, {path("file/in"), "Not a directory"});
  EXPECT_EQ(hair::bytes_of(path("file")), "kept");
  const std::map<string, string> before = files(path("a"));
  expect_refused({path("a"), path("b"), "--out", path("a")}, {"--out " + path("a"), "another folder"});
  EXPECT_EQ(files(path("a")), before);
}

// A limit on files' sizes acts like a full disk.
TEST_F(Comparing, AFullDiskIsNamedAndEarlierFilesStay) {
  two_folders();
  fs::create_directory(out());
  std::ofstream(out() + "/index.html") << "earlier";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);  // the program inherits both
  rlimit small = before;
  small.rlim_cur = 500;
  setrlimit(RLIMIT_FSIZE, &small);
  const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
  setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.errors.find("can't be written (File too large)"), string::npos) << run.errors;
  EXPECT_EQ(files(out()), (std::map<string, string>{{"index.html", "earlier"}}));
}

TEST_F(Comparing, ResultsThatAreLostAreNotASuccess) {
  const string a = put("a.png", frame(0)), b = put("b.png", frame(3));
  for (const std::vector<string>& arguments : std::vector<std::vector<string>>{
           {"compare", a, b}, {"compare", a, b, "--json"}, {"samples", "--table"}, {"--help"}}) {
    std::vector<string> words = {HAIRGRADE};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const pid_t process =
        hair::start_program({.words = words, .output = "/dev/full", .errors = path("errors")});
    EXPECT_EQ(hair::exit_code_of(process), 2);
    EXPECT_EQ(hair::bytes_of(path("errors")),
              "hairgrade: the standard output can't be written (No space left on device), so that results "
              "are lost; "
              "send it to a place with room in it\n");
  }
}

TEST_F(Comparing, AClosedStandardOutputIsNotASuccess) {
  const ProgramRun run =
      run_hairgrade({"compare", put("a.png", frame(0)), put("b.png", frame(3))}, {}, "exec 0<&- >&-");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.errors.starts_with(
      "hairgrade: the standard output can't be written (Bad file descriptor), so that results are lost"))
      << run.errors;
}

TEST_F(Comparing, InterruptedItLeavesNothing) {
  for (int i = 0; i < 200; ++i) {
    const string name = "frame-" + std::to_string(i) + ".png";
    put("a/" + name, frame(0));
    put("b/" + name, frame(i));
  }
  const auto interrupt = [&](const RunningProgram& compares) {
    EXPECT_TRUE(compares.wait_until([&] { return fs::exists(out()); }));
    kill(compares.process, SIGINT);
  };
  const ProgramRun run = run_hairgrade({"compare", path("a"), path("b"), "--out", out()}, interrupt);
  EXPECT_EQ(run.code, 130);
  EXPECT_EQ(run.errors, "hairgrade: interrupted; nothing was written\n");
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(Comparing, NeedsNoHome) {
  const char* home = getenv("HOME");
  const string kept = home == nullptr ? "" : home;
  unsetenv("HOME");
  const ProgramRun run = compare({put("a.png", frame(0)), put("b.png", frame(1))});
  if (home != nullptr) setenv("HOME", kept.c_str(), 1);
  EXPECT_EQ(run.code, 0) << run.errors;
}

}  // namespace
}  // namespace grader
