// hairlab info, convert and groom, from outside.
#include <gtest/gtest.h>

#include "hair/groom/groom_file.h"
#include "hair/lab/test_run_hairlab.h"

namespace hair {
namespace {

class GroomCommands : public testing::Test {
 protected:
  // A bald root and three strands, in .ply.
  GroomCommands() {
    const auto line = [](int points, double x) {
      Eigen::VectorXd strand = Eigen::VectorXd::Zero(3 * points);
      for (int i = 0; i < points; ++i) strand.segment<3>(3 * i) = Eigen::Vector3d(x, 0, -i);
      return strand;
    };
    write_groom({{line(1, 0), line(2, 1), line(3, 2), line(5, 3)}}, groom_);
  }

  TestFolder folder_;
  const std::string groom_ = folder_ / "a.ply", out_ = folder_ / "out.hair";
};

TEST_F(GroomCommands, InfoSaysWhatAGroomIsLike) {
  const ProgramRun run = run_hairlab({"info", groom_});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(run.output.starts_with(groom_ + ": 4 strands, 11 points\n")) << run.output;
  EXPECT_TRUE(says(run.output,
                   "\n  length                         1           2       2.333           2           4\n"));
  EXPECT_TRUE(says(run.output, "\n  box of the roots    x 0 to 3, y 0 to 0, z 0 to 0\n"));
  EXPECT_TRUE(
      says(run.output, "\n  unit                about 6.667 cm, if the roots span a scalp of 20 cm\n"));
  EXPECT_TRUE(
      run.output.ends_with("\n  odd                 1 bald root: a strand of a single point (strand 0)\n"))
      << run.output;
}

TEST_F(GroomCommands, ConvertKeepsThePointsAndTheLook) {
  const std::string ply = folder_ / "b.ply";
  EXPECT_EQ(run_hairlab({"convert", groom_, out_}).output, out_ + ": 4 strands, 11 points\n");
  EXPECT_EQ(read_groom(out_).strands, read_groom(groom_).strands);
  run_hairlab({"convert", groom_, ply});
  EXPECT_EQ(bytes_of(ply), bytes_of(groom_));

  Groom groom = read_groom(groom_);
  groom.look = {.thickness = 0.5F, .transparencies = std::vector<float>(11, 0.5F)};
  write_groom(groom, out_);
  EXPECT_EQ(run_hairlab({"convert", out_, ply}).code, 0);
  EXPECT_EQ(run_hairlab({"convert", ply, out_}).code, 0);
  EXPECT_EQ(read_groom(out_).look.thicknesses, std::vector<float>(11, 0.5F));
  EXPECT_EQ(read_groom(out_).look.transparencies, std::vector<float>(11, 0.5F));
}

TEST_F(GroomCommands, ConvertScalesThinsAndTakesPoints) {
  const std::string ply = folder_ / "b.ply";
  const ProgramRun run =
      run_hairlab({"convert", groom_, ply, "--scale", "0.5", "--every", "2", "--points", "5"});
  EXPECT_EQ(run.code, 0) << run.errors;
  Eigen::VectorXd x(15);
  x << 1, 0, 0, 1, 0, -0.25, 1, 0, -0.5, 1, 0, -0.75, 1, 0, -1;
  EXPECT_EQ(read_groom(ply).strands, (std::vector<Eigen::VectorXd>{Eigen::VectorXd::Zero(3), x}));
}

TEST_F(GroomCommands, AGroomGrowsInAStyleTheSameEachTime) {
  const std::vector<std::string> arguments = {"groom",    "wavy", "--strands", "200",
                                              "--points", "60",   "--seed",    "7"};
  const auto grown = [&](const std::string& name) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--out", folder_ / name});
    const ProgramRun run = run_hairlab(all);
    EXPECT_EQ(run.output, (folder_ / name).string() + ": 200 strands, 12,000 points, in metres\n")
        << run.errors;
    return bytes_of(folder_ / name);
  };
  const std::string bytes = grown("b.hair");
  EXPECT_EQ(grown("c.hair"), bytes);
  EXPECT_TRUE(says(run_hairlab({"info", folder_ / "b.hair"}).output, "\"hairlab groom wavy --seed 7\"\n"));
}

TEST_F(GroomCommands, BadInputIsOneLineAndWritesNothing) {
  const std::string whole = bytes_of(groom_);
  const std::size_t at = whole.find("end_header\n") + 11;
  const std::string cut = folder_.write("cut.ply", whole.substr(0, at + 100)),
                    nan = folder_.write("nan.ply", std::string(whole).replace(at, 4, "\xff\xff\xff\x7f"));
  const struct {
    std::vector<std::string> words;
    std::string says;
  } refused[] = {
      {{"info", cut}, "cut.ply: its header says that there are 11 of "},
      {{"info", folder_ / "none.hair"}, "none.hair: can't be read (No such file or directory)"},
      {{"convert", groom_, folder_ / "a.abc"}, "a.abc: has the ending of no groom's format"},
      {{"convert", groom_, out_, "--scale", "nan"}, "--scale"},
      {{"convert", groom_, out_, "--points", "1"}, "--points"},
      {{"convert", groom_, folder_ / "none/a.hair"}, "can't be written (No such file or directory); give a "},
      {{"convert", nan, out_}, ": vertex 0 has a number that is not finite"},
      {{"groom", "bob", "--out", out_},
       "there is no style \"bob\"; there are long-smooth, short-curly, wavy, "},
      {{"groom", "wavy", "--points", "10", "--out", out_}, "strands of 10 points; wavy has "},
      {{"groom", "wavy", "--seed", "-1", "--out", out_}, "--seed"},
      {{"groom", "wavy", "--seed", "9007199254740993", "--out", out_}, "--seed"}};
  for (const auto& [words, says] : refused) expect_refused(run_hairlab(words), 2, says);
  EXPECT_TRUE(says(run_hairlab({"info", nan}).output, "1 strand with a number that is not finite"));
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.ply", "cut.ply", "nan.ply"}));
}

}  // namespace
}  // namespace hair
