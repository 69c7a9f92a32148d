// Common properties of all of hairlab's studies, as seen from outside: their files, their ends, and their
// refusals.

#include <gtest/gtest.h>

#include <signal.h>
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hair/lab/test_run_hairlab.h"
#include "hair/truth/accurate_motion.h"

namespace hair {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct StudyCase {
  std::string name;                                           // the record's program, after hairlab
  std::vector<std::string> files;                             // those that it writes, in order
  std::vector<std::string> arguments;                         // arguments of a short study
  std::string stub;                                           // the exercise that it needs first
  void (*look)(const Json& record, const std::string& page);  // checks of the record and the page

  std::string record() const { return name.substr(name.rfind(' ') + 1) + ".json"; }
};

void look_at_solver(const Json& record, const std::string& page) {
  EXPECT_TRUE(record["left_out"].is_null());
  EXPECT_EQ(record["digits"].size(), 8);
  // A'A has the square of the condition number.
  const Json& needed = record["iterations"][0];
  EXPECT_LE(needed["normal_equations"], 10 * needed["condition"].get<double>()) << needed;
  for (const char* figure :
       {"error-against-iterations", "squared-residual-against-iterations", "error-against-time",
        "strand-error-against-products", "strand-squared-residual-against-iterations",
        "strand-error-against-time", "iterations-against-condition", "error-against-condition"})
    EXPECT_TRUE(says(page, "id=\"" + std::string(figure) + "\"")) << figure;
}

void look_at_head(const Json& record, const std::string&) {
  EXPECT_EQ(record["no_pictures"], "--no-pictures");
  ASSERT_EQ(record["cases"].size(), 2u);
  EXPECT_EQ(record["cases"][0]["head"], true);
  EXPECT_EQ(record["cases"][1]["head"], false);
  for (const Json& one : record["cases"]) {
    EXPECT_EQ(one["strands"], 60);
    ASSERT_EQ(one["runs"].size(), 1u);
    EXPECT_EQ(one["runs"][0]["guides"], 50);
    EXPECT_GT(one["runs"][0]["modes"]["interpolate"]["end"]["rms"], 0);
  }
}

void look_at_stability(const Json& record, const std::string&) {
  EXPECT_EQ(record["ended"], "finished");
  EXPECT_EQ(record["extremes"].size(), 208u);
  ASSERT_EQ(record["maps"].size(), 14u);
  for (const Json& map : record["maps"]) {
    ASSERT_EQ(map["rows"].size(), map["h"].size());
    for (const Json& row : map["rows"]) EXPECT_EQ(row.get<std::string>().size(), map["x"].size());
  }
}

void look_at_validate(const Json& record, const std::string&) {
  EXPECT_EQ(record["quick"], true);
  ASSERT_EQ(record["validations"].size(), 1u);
  EXPECT_GE(record["validations"][0]["checks"].size(), 1u);
}

void look_at_study(const Json& record, const std::string& page) {
  EXPECT_EQ(record["finished"], true);
  ASSERT_EQ(record["methods"].size(), 2u);
  EXPECT_EQ(record["methods"][1]["id"], "runge-kutta-4");
  for (const Json& method : record["methods"])
    for (const Json& run : method["runs"])
      EXPECT_TRUE(says(page, ">" + std::to_string(run["evaluations"].get<long>()) + "</td>")) << run;
}

void look_at_bowl(const Json& record, const std::string& page) {
  EXPECT_TRUE(record["left_out"].is_null());
  EXPECT_EQ(record["paths"].size(), 18) << "two of nine places";
  for (const char* function : {"b", "A&#39;b"})
    EXPECT_TRUE(says(
        page, std::string("It begins at ") + function + ", as it should. It is at the bottom after 2 steps"));
}

void look_at_phase(const Json& record, const std::string&) {
  ASSERT_EQ(record["methods"].size(), 4);
  for (const Json& method : record["methods"])
    EXPECT_EQ(method["evaluations"], method["should_evaluate"]) << method;
  const auto energy = [&](int k) { return record["methods"][k]["energy"].get<double>(); };
  EXPECT_GT(energy(0), 2) << "forward Euler winds outwards";
  // The swing is larger than small ones, and slower: sin(0.5) / 0.5 = 0.96. So it gains less.
  for (const int kept : {1, 2, 3})
    EXPECT_NEAR(energy(kept), record["methods"][kept]["should_end"], 0.3) << kept;
  EXPECT_GT(energy(2), 1.1) << "midpoint winds outwards, so that one sees it";
  EXPECT_NEAR(energy(3), 1, 0.005);
}

const StudyCase kStudies[] = {
    {"bowl",
     {"bowl.csv", "bowl.json", "index.html"},
     {},
     "S1: student/conj_grad.cpp, ConjGrad is not implemented yet",
     look_at_bowl},
    {"phase",
     {"index.html", "phase.csv", "phase.json"},
     {},
     "P1: student/explicit_integrators.cpp, forward_euler is not implemented yet",
     look_at_phase},
    {"solver",
     {"convergence.csv", "digits.csv", "direct.csv", "index.html", "iterations.csv", "solver.json"},
     {"--quick"},
     "S1: student/conj_grad.cpp, ConjGrad is not implemented yet",
     look_at_solver},
    {"study head",
     {"head.csv", "head.json", "index.html"},
     {"--hair", "straight", "--exercise-strands", "60", "--no-pictures"},
     "hairlab: this needs ",
     look_at_head},
    {"study",
     {"index.html", "study.csv", "study.json"},
     {"pendulum", "--quick", "--duration", "0.05", "--methods", "symplectic-euler,runge-kutta-4",
      "--no-cache"},
     "hairlab: pendulum needs P1: student/explicit_integrators.cpp, ",
     look_at_study},
    {"stability",
     {"boundaries.csv", "curves.csv", "extremes.csv", "index.html", "stability.json"},
     {"strand-swing", "--quick", "--segments", "2"},
     "is left out: it needs H1: student/stretch_springs.cpp",
     look_at_stability},
    {"validate",
     {"index.html", "validate.csv", "validate.json"},
     {"pendulum-rods", "--quick"},
     "hairlab: this needs P1: student/explicit_integrators.cpp, ",
     look_at_validate},
};

class Studies : public testing::TestWithParam<StudyCase> {
 protected:
  void SetUp() override {
    if (GetParam().name == "study" && !have_accurate_motion()) GTEST_SKIP() << "built without SUNDIALS";
  }
  ProgramRun study(const ProgramSettings& settings = {}) const {
    std::vector<std::string> arguments = GetParam().arguments;
    arguments.insert(arguments.end(), {"--out", out_.string()});
    return run(arguments, settings);
  }
  // The command with other arguments.
  ProgramRun run(const std::vector<std::string>& arguments, const ProgramSettings& settings = {}) const {
    std::istringstream words(GetParam().name);
    std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_hairlab(all, settings);
  }

  TestFolder folder_;
  const fs::path out_ = folder_ / "out";
};

TEST_P(Studies, WritePageTablesAndRecordInPlaceOfEarlierOnesAndAreQuietInAPipe) {
  const StudyCase& one = GetParam();
  fs::create_directory(out_);
  folder_.write("out/" + one.record(), "{\n  \"program\": \"hairlab " + one.name + "\", \"of\": \"before\"}");
  const ProgramRun done = study();
  ASSERT_EQ(done.code, 0) << done.errors;
  EXPECT_EQ(done.errors, "") << "progress is for terminals";
  EXPECT_TRUE(says(done.output, (out_ / "index.html").string()));
  EXPECT_EQ(folder_.names("out"), one.files);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"out"});
  const std::string text = bytes_of(out_ / one.record()), page = bytes_of(out_ / "index.html");
  EXPECT_TRUE(text.starts_with("{\n  \"program\": \"hairlab " + one.name + "\"")) << text.substr(0, 100);
  EXPECT_TRUE(one.name == "validate" || says(page, "<svg"));
  const Json record = Json::parse(text);
  const bool quick = std::ranges::count(one.arguments, "--quick") > 0;
  EXPECT_EQ(record["quick"], quick);
  EXPECT_EQ(bool(says(page, " A quick study: ")), quick);
  EXPECT_FALSE(record["machine"].empty());
  one.look(record, page);
}

TEST_P(Studies, RefuseAFolderOfSomethingElseBeforeTheyCompute) {
  fs::create_directory(out_);
  folder_.write("out/letter.txt", "dear");
  expect_refused(study(), 2, "is not empty, and not from hairlab " + GetParam().name);
  EXPECT_EQ(bytes_of(out_ / "letter.txt"), "dear");
  std::vector<std::string> nowhere = GetParam().arguments;
  nowhere.insert(nowhere.end(), {"--out", ""});
  EXPECT_EQ(run(nowhere).code, 2);
}

TEST_P(Studies, NameTheExerciseThatIsNotWrittenAndWriteNothing) {
  const ProgramRun done = study({.program = STUDENT_HAIRLAB});
  EXPECT_EQ(done.code, 3) << done.errors;
  EXPECT_TRUE(says(done.errors, GetParam().stub));
  EXPECT_TRUE(GetParam().name == "validate" || folder_.names().empty());
}

// Its hidden folder exists as soon as it studies.
TEST_P(Studies, InterruptedKeepWhatTheySayOrNothing) {
  if (GetParam().name == "bowl" || GetParam().name == "phase") GTEST_SKIP() << "it is too short";
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    const fs::path hidden = folder_ / (".hairlab-out-" + std::to_string(process));
    EXPECT_TRUE(wait_until([&] { return fs::exists(hidden); }, process));
    kill(process, SIGINT);
  };
  std::vector<std::string> whole = {"--out", out_.string()};
  if (GetParam().name == "stability" || GetParam().name == "study") whole.push_back("strand-swing");
  if (GetParam().name == "study") whole.push_back("--no-cache");
  if (GetParam().name == "study head") whole.push_back("--quick");
  const ProgramRun done = run(whole, settings);
  EXPECT_EQ(done.code, 130) << done.errors;
  if (fs::exists(out_)) {
    EXPECT_TRUE(says(done.errors, "hairlab: interrupted; what is finished is kept"));
    EXPECT_TRUE(GetParam().name == "validate" || GetParam().name == "stability" ||
                GetParam().name == "study");
  } else {
    EXPECT_TRUE(says(done.errors, "hairlab: interrupted; nothing is written\n"));
    EXPECT_TRUE(folder_.names().empty());
  }
}

INSTANTIATE_TEST_SUITE_P(All, Studies, testing::ValuesIn(kStudies), [](const auto& study) {
  std::string name = study.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
});

}  // namespace
}  // namespace hair
