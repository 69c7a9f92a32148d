// STAFF ONLY. Tests hairgrade compare as a TA uses it.
#include "grader/compare/compare.h"
#include "grader/compare/test_pictures.h"
#include "grader/result/fields.h"
#include "grader/tests/broken_links.h"
#include "grader/tests/in_a_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/read_png.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using hair::Image;
using nlohmann::json;
using std::string;
using tests::says;

constexpr int kWidth = 96, kHeight = 64;

Image frame(int shift) {
  return strands(kWidth, kHeight, 10, shift);
}

class Comparing : public InAFolder {
 protected:
  Comparing() : InAFolder(json::object()) {}
  string out() const { return path("out"); }
  string put(const string& name, const Image& image) const {
    hair::write_file(root_ / name, hair::encode_png(image));
    return path(name);
  }

  // Makes two folders: one frame is the same, one near, one far, and each folder lacks one of the other's.
  void two_folders() const {
    for (int i = 1; i <= 4; ++i) put("a/frame-000" + std::to_string(i) + ".png", frame(0));
    for (const auto& [name, shift] : {std::pair{"1", 0}, {"2", 1}, {"3", 40}, {"5", 0}})
      put(string("b/frame-000") + name + ".png", frame(shift));
  }

  ProgramRun compare(std::vector<string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run_hairgrade(arguments, {}, "unset HOME");
  }
};

TEST_F(Comparing, TwoPicturesGiveTheirDistances) {
  const string a = put("a.png", frame(0)), b = put("b.png", frame(3));
  const PictureDistance expected = compare_pictures(frame(0), frame(3));
  const ProgramRun run = compare({a, b, "--json"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  EXPECT_EQ(json::parse(run.output).at("pairs"), json::array({{{"name", "b.png"},
                                                               {"width", kWidth},
                                                               {"height", kHeight},
                                                               {"identical", false},
                                                               {"blurred_rmse", expected.blurred_rmse},
                                                               {"flip_mean", expected.flip_mean},
                                                               {"flip_max", expected.flip_max}}}));
  char line[100];
  snprintf(line, sizeof line, "\nb.png    %12.4f  %6.4f  %8.4f\n", expected.blurred_rmse, expected.flip_mean,
           expected.flip_max);
  const ProgramRun table = compare({a, b});
  EXPECT_TRUE(says(table.output, line));
  EXPECT_EQ(compare({a, a}).output, "1 of 1 the same, pixel for pixel\n");
  const string black = path("black.png"), clear = path("clear.png");
  put("black.png", Image{1, 1, {0, 0, 0}});
  // A PNG file of one pixel: grey 0 with alpha 0.
  hair::write_file(
      clear,
      pictures_in_base64().read(
          "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR4nGNgYAAAAAMAAbitOmMAAAAASUVORK5CYII="));
  EXPECT_TRUE(says(compare({black, clear, "--json"}).output, "\"flip_mean\": 0.967")) << "as black and white";
  EXPECT_EQ(compare({clear, clear}).output, "1 of 1 the same, pixel for pixel\n");
}

TEST_F(Comparing, FoldersGiveAPageWorstFirstWhereWhatIsMissingIsNamed) {
  two_folders();
  const string odd = "<b>#1 50%?\x1b[31m";
  for (const string& name : {odd + ".png", string("frame-0001.PNG")}) {  // the ending's case does not matter
    put("a/" + name, frame(0));
    put("b/" + name, frame(1));
  }
  const ProgramRun run = compare({path("a"), path("b"), "--out", out()});
  EXPECT_EQ(run.code, 3) << run.errors;
  const std::size_t far = run.output.find("\nframe-0003.png"), near = run.output.find("\nframe-0002.png");
  EXPECT_LT(far, near) << run.output;
  ASSERT_NE(near, string::npos);
  for (const string& words :
       {"only in " + path("a") + ": frame-0004.png\n", "only in " + path("b") + ": frame-0005.png\n"})
    EXPECT_LT(run.output.find(words), far) << run.output << words;
  EXPECT_TRUE(says(run.output, "\n1 of 5 the same, pixel for pixel\n"));
  EXPECT_FALSE(says(run.output, "\x1b"));

  std::vector<string> names;
  for (const auto& entry : fs::directory_iterator(out())) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<string>{odd + "-heat.png", odd + "-side.png", "frame-0001-side.png",
                                        "frame-0001.PNG-heat.png", "frame-0001.PNG-side.png",
                                        "frame-0002-heat.png", "frame-0002-side.png", "frame-0003-heat.png",
                                        "frame-0003-side.png", "index.html"}));
  EXPECT_EQ(hair::read_png(out() + "/frame-0003-heat.png").height, kHeight);
  EXPECT_EQ(hair::read_png(out() + "/frame-0003-side.png").width, 3 * kWidth + 2 * 8);
  const string page = hair::bytes_of(out() + "/index.html");
  EXPECT_LT(page.find("<strong>frame-0003.png"), page.find("<strong>frame-0002.png"));
  for (std::size_t at = page.find("src="); at != string::npos; at = page.find("src=", at + 1))
    EXPECT_TRUE(page.substr(at).starts_with("src=\"data:image/png;base64,")) << page.substr(at, 40);
  EXPECT_EQ(page.find("http"), page.find("http-equiv"));
  EXPECT_FALSE(says(page, "<b>"));
  EXPECT_EQ(broken_links(out()), std::vector<string>());
  ASSERT_EQ(compare({path("a"), path("b"), "--out", out()}).code, 3);
  EXPECT_EQ(hair::bytes_of(out() + "/index.html"), page) << "again";

  const json all = json::parse(compare({path("a"), path("b"), "--json"}).output);
  ASSERT_EQ(all.at("pairs").size(), 5u);
  EXPECT_EQ(all.at("pairs")[0].at("name"), "frame-0003.png");
  EXPECT_EQ(all.at("pairs")[4].at("identical"), true);
  EXPECT_EQ(all.at("only_in_first"), json::array({"frame-0004.png"}));
  EXPECT_EQ(all.at("only_in_second"), json::array({"frame-0005.png"}));
}

// Bad input: exit code 2, one line that holds these words, and nothing written.
TEST_F(Comparing, BadInputIsALineAndNothingIsWritten) {
  two_folders();
  const string a = path("a"), picture = put("picture.png", frame(0)), nowhere = path("nowhere");
  const string taller = put("taller.png", strands(kWidth, kHeight + 1, 10)), text = path("text.png");
  fs::create_directory(root_ / "empty");
  put("c/other.png", frame(0));
  std::ofstream(text) << "no picture";
  const struct {
    std::vector<string> arguments, words;
  } rows[] = {
      {{a}, {"B", "--help"}},
      {{a, nowhere}, {nowhere, "No such file"}},
      {{a, picture}, {a + " is a folder", picture + " is a file"}},
      {{a, path("empty")}, {path("empty"), "*.png"}},
      {{a, path("c")}, {a, path("c"), "other.png", "names"}},
      {{a, "/dev/null"}, {"/dev/null", "neither"}},
      {{picture, taller}, {picture, "96 x 64", taller, "96 x 65"}},
      {{picture, text}, {text, "is not a PNG picture"}},
      {{a, path("b"), "--out", text}, {text, "Not a directory"}},
      {{a, path("b"), "--out", a}, {"--out " + a, "another folder"}},
  };
  for (const auto& [arguments, words] : rows) {
    std::vector<string> with_out = arguments;
    if (std::ranges::count(arguments, "--out") == 0) with_out.insert(with_out.end(), {"--out", out()});
    const ProgramRun run = compare(with_out);
    EXPECT_EQ(run.output, "");
    for (const string& word : words) expect_refused(run, word);
    EXPECT_FALSE(fs::exists(out()));
  }
  EXPECT_EQ(hair::bytes_of(text), "no picture");
  EXPECT_EQ(std::distance(fs::directory_iterator(a), {}), 4);
}

// Each row replaces b's frame 2. The other frames are compared all the same.
TEST_F(Comparing, APictureThatCanNotBeComparedIsNamedAndWorst) {
  two_folders();
  const string bad = path("b/frame-0002.png"), whole = hair::bytes_of(bad);
  const auto write = [&](const string& bytes) { std::ofstream(bad, std::ios::binary) << bytes; };
  const std::vector<std::pair<string, std::function<void()>>> rows = {
      {"96 x 65", [&] { put("b/frame-0002.png", strands(kWidth, kHeight + 1, 10)); }},
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
    EXPECT_TRUE(says(run.output, "1 of 2 the same"));
    EXPECT_TRUE(says(hair::bytes_of(out() + "/index.html"), "not compared: " + path("")));
    const json pairs = json::parse(compare({path("a"), path("b"), "--json"}).output).at("pairs");
    EXPECT_EQ(pairs.at(0).at("name"), "frame-0002.png");
    EXPECT_TRUE(says(pairs.at(0).at("not_compared").get<string>(), why));
  }
}

TEST_F(Comparing, ResultsThatAreLostAreNotASuccess) {
  const string a = put("a.png", frame(0)), b = put("b.png", frame(3));
  for (const std::vector<string>& arguments : std::vector<std::vector<string>>{
           {"compare", a, b}, {"compare", a, b, "--json"}, {"samples", "--table"}, {"--help"}})
    for (const auto& [script, why] : {std::pair{"exec >/dev/full", "No space left on device"},
                                      {"exec 0<&- >&-", "Bad file descriptor"}}) {
      const ProgramRun run = run_hairgrade(arguments, {}, script);
      EXPECT_EQ(run.code, 2) << script;
      EXPECT_EQ(run.errors, string("hairgrade: the standard output can't be written (") + why +
                                "), so that results are lost; send it to a place with room in it\n");
    }
}

}  // namespace
}  // namespace grader
