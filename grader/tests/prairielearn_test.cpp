// STAFF ONLY. Makes PrairieLearn's questions, and grades hand-ins as its container does, by the platform's
// documents.
#include "grader/report/results_json.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using std::string;
using tests::says;

class PrairieLearn : public InAFolder {
 protected:
  PrairieLearn() : InAFolder(course_of({"S1"})) {
    const ProgramRun packed =
        run_hairgrade({"package", "prairielearn", "--out", questions_, "--course", path("course.json"),
                       "--secret", path("secret"), "--image", "one"});
    EXPECT_EQ(packed.code, 0) << packed.errors;
  }

  // Returns results.json of a hand-in with this file.
  Json results_of(const string& name, const string& text) const {
    fs::remove_all(root_ / "grade");
    write("grade/student/" + name, text);
    const Json info = Json::parse(hair::bytes_of(questions_ / "questions/hair-S1/info.json"));
    EXPECT_EQ(info["externalGradingOptions"]["image"], "one");
    std::vector<string> words = info["externalGradingOptions"]["entrypoint"];
    words.erase(words.begin());
    for (string& word : words)
      if (const string place = "/grade/serverFilesCourse"; word.starts_with(place))
        word.replace(0, place.size(), (questions_ / "serverFilesCourse").string());
    words.insert(words.end(), {path("grade"), "--cache", path("cache")});
    const ProgramRun run = run_hairgrade(words);
    EXPECT_EQ(run.code, 0) << run.errors;
    const string bytes = read("grade/results/results.json");
    EXPECT_LE(bytes.size(), kMostResultsBytes);
    return Json::parse(bytes);
  }

  const fs::path questions_ = root_ / "questions-of-s1";
};

TEST_F(PrairieLearn, GivesAScoreBetweenNoneAndAll) {
  const string right = hair::bytes_of(fs::path(HAIR_PROJECT) / "reference/S1/right/plain.cpp");
  const Json all = results_of("conj_grad.cpp", right);
  EXPECT_EQ(all["gradable"], true);
  EXPECT_EQ(all["score"], 1);
  EXPECT_GT(all["images"].size(), 0);
  EXPECT_TRUE(all["images"][0]["url"].get<string>().starts_with("data:image/png;base64,"));

  string wrong = right;
  const string first_guess = "for (int i = 0; i < n; ++i) x[i] = b[i];";
  ASSERT_NE(wrong.find(first_guess), string::npos);
  wrong.erase(wrong.find(first_guess), first_guess.size());
  const Json some = results_of("conj_grad.cpp", wrong);
  double points = 0, most = 0;
  for (const Json& test : some["tests"]) {
    points += test["points"].get<double>();
    most += test["max_points"].get<double>();
  }
  EXPECT_LT(0, points);
  EXPECT_LT(points, most);
  EXPECT_NEAR(some["score"], points / most, 1e-12);
}

// An attempt is not lost by a file that is not there or does not compile.
TEST_F(PrairieLearn, DoesNotGradeWhatDoesNotCompile) {
  for (const auto& [name, text, because] :
       {std::tuple{"conj_grad.cpp", "int ConjGrad(", "conj_grad.cpp"}, {"other.cpp", "", "conj_grad.cpp"}}) {
    const Json none = results_of(name, text);
    EXPECT_EQ(none["gradable"], false) << name;
    EXPECT_FALSE(none.contains("score")) << name;
    EXPECT_TRUE(says(none["format_errors"][0].get<string>(), because)) << none;
  }
}

TEST_F(PrairieLearn, KeepsItsSecretFromOtherUsers) {
  EXPECT_EQ(fs::status(questions_ / "serverFilesCourse/hairgrade").permissions(), fs::perms::owner_all);
  const Json info = Json::parse(hair::bytes_of(questions_ / "questions/hair-S1/info.json"));
  EXPECT_LE(info["externalGradingOptions"]["timeout"], 600);
  EXPECT_EQ(info["uuid"].get<string>().size(), 36U);
}

}  // namespace
}  // namespace grader
