// STAFF ONLY. Tests hairgrade as a person uses it: options, errors, reruns, interruptions.
#include <signal.h>
#include <unistd.h>

#include "grader/course/course.h"
#include "grader/intake/read_submissions.h"
#include "grader/record/record.h"
#include "grader/report/report.h"
#include "grader/tests/in_a_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

// This is a course of S1 and S2 alone. All tests share its secret and its cache, so that only the first one
// compiles and draws.
class Hairgrade : public InAFolder {
 protected:
  Hairgrade() : InAFolder(nlohmann::json::object()) {}
  static void SetUpTestSuite() {
    static const hair::TemporaryFolder shared("hairgrade-tests");
    course_ = shared.path();
    std::ofstream(course_ / "secret") << "a secret for this test";
    std::ofstream(course_ / "course.json") << course_of({"S1", "S2"});
  }
  string out() const { return path("grades"); }

  static ProgramRun grade(std::vector<string> arguments,
                          const std::function<void(const RunningProgram&)>& meanwhile = {},
                          const string& script = "") {
    arguments.insert(arguments.begin(), "grade");
    const auto add = [&](const string& option, const char* file) {
      if (std::ranges::count(arguments, option) == 0)
        arguments.insert(arguments.end(), {option, (course_ / file).string()});
    };
    add("--secret", "secret");
    add("--cache", "cache");
    add("--course", "course.json");
    return run_hairgrade(arguments, meanwhile, script);
  }

  // Copies `other-order`, graded once for all tests, to out(), like an earlier run of this test.
  void earlier_run() const {
    const fs::path graded = course_ / "graded";
    if (!fs::exists(graded)) {
      EXPECT_EQ(grade({sample("other-order"), "--out", graded.string()}).code, 0);
    }
    fs::copy(graded, out(), fs::copy_options::recursive);
  }

  // Expects exit code 2, one line with these words, and no files.
  void expect_refused(const ProgramRun& run, const std::vector<string>& words) const {
    for (const string& word : words) InAFolder::expect_refused(run, word);
    EXPECT_FALSE(fs::exists(out()));
  }

  void add_to_class(const std::vector<string>& names) const {
    fs::create_directory(root_ / "class");
    for (const string& name : names)
      fs::copy(sample(name), root_ / "class" / fs::path(sample(name)).filename(),
               fs::copy_options::recursive);
  }

  // Returns a sample's code for an exercise.
  string code_of(const string& name, const string& file) const {
    const Course course = read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json");
    return read_submissions({sample(name)}, course, open_here).submissions.at(0).files.at(file).text;
  }

  inline static fs::path course_;
};

TEST_F(Hairgrade, RefusesBadUsageInOneLine) {
  const string gone = path("gone"), one = sample("other-order"), short_secret = write("short", "123");
  const string odd = write("odd.json", R"({"exercises": {"S1": {"role": "homework"}}})"),
               given = write("given.json", R"({"exercises": {"S1": {"role": "given"}}})");
  expect_refused(run_hairgrade({}), {"--help"});
  expect_refused(run_hairgrade({"grade"}), {"SUBMISSION", "--help"});
  expect_refused(run_hairgrade({"degrade"}), {"degrade", "is no command; there are new-course, next, "});
  expect_refused(grade({one}), {"--out"});
  expect_refused(
      grade({sample("stubs"), "--out", "grades"}, {}, "mkdir " + gone + "; cd " + gone + "; rmdir " + gone),
      {"the folder that it was started in is gone"});
  const struct {
    std::vector<string> arguments, words;
  } rows[] = {
      {{one, "--quickly"}, {"--quickly"}},
      {{"/no/such/file.zip"}, {"/no/such/file.zip"}},
      {{one, "--from", "myspace"}, {"--from", "canvas"}},
      {{one, "--course", odd}, {"odd.json", "S1.role", "assigned"}},
      {{one, "-j", "0"}, {"-j"}},
      {{one, "-j", "-1"}, {"-j"}},
      {{one, "-j", "many"}, {"-j"}},
      {{one, "-j", "1e9"}, {"-j"}},
      {{one, "--exercise", "X1"}, {"X1", "asks for S1, S2"}},
      {{one, "--exercise", "S1", "--course", given}, {"S1"}},
      {{one, "--study", "--exercise", "S1"}, {"leave out --exercise S1"}},
      {{one, "--only", "alice"}, {"alice", "other-order"}},
      {{one, "--secret", short_secret}, {"short", "16"}},
      {{one, "--secret", "/no/secret"}, {"/no/secret"}},
  };
  for (auto [arguments, words] : rows) {
    arguments.insert(arguments.end(), {"--out", out()});
    expect_refused(grade(arguments), words);
  }
  EXPECT_EQ(run_hairgrade({"--help"}).code, 0);
}

// Each stray, name that clashes and archive beside exercise files has a line; the exit code is 3, and the
// rest is graded.
TEST_F(Hairgrade, GradesAClassWithStraysAndClashes) {
  const fs::path everybody = root_ / "class";
  for (const char* name : {"x", "alice"})
    write("class/" + string(name) + "/conj_grad.cpp", code_of("perfect", "conj_grad.cpp"));
  for (const char* file : {"x.zip", "bob.rar", "conj_grad.cpp"}) write("class/" + string(file), "Rar!");
  const ProgramRun run = grade({everybody.string(), "--out", out()});
  EXPECT_EQ(run.code, 3) << run.errors;
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 5) << run.errors;
  for (const char* line :
       {"/conj_grad.cpp: was not graded", "/bob.rar: was not graded: bob.rar is a RAR archive",
        "/x.zip are both", "/x are both"})
    EXPECT_TRUE(says(run.errors, line));
  EXPECT_EQ(points(recorded_result(out(), "alice").value()), 32);
  const SubmissionResult bob = recorded_result(out(), "bob").value();
  for (const ExerciseResult& exercise : bob.exercises) EXPECT_EQ(exercise.status, Status::unreadable);
  const auto left_over =
      nlohmann::json::parse(hair::bytes_of(fs::path(out()) / "left-over.json")).at("left_over");
  ASSERT_EQ(left_over.size(), 1U);
  EXPECT_EQ(left_over[0].at("path"), (everybody / "conj_grad.cpp").string());
  EXPECT_TRUE(says(hair::bytes_of(fs::path(out()) / "index.html"),
                   ">" + (everybody / "conj_grad.cpp").string() + "</th><td>nobody&#39;s</td>"));
}

// Another shell, with other limits, signals and environment, gives the same results.
TEST_F(Hairgrade, GivesTheSameBytesAgain) {
  const string other_shell =
      "ulimit -S -v 8000000 -d 4000000 -s 512 -t 900 -n 40; umask 777; trap '' CHLD XCPU PIPE ALRM;\n"
      "export TMPDIR=/nowhere GTEST_FILTER=-* LC_ALL=C.UTF-8 OMP_NUM_THREADS=1 MALLOC_PERTURB_=7;\n"
      "if setarch -R true 2>/dev/null; then exec setarch -R \"$0\" \"$@\"; fi\n"  // most containers forbid it
      "exec \"$0\" \"$@\"";
  const std::vector<string> class_of_four = {sample("other-order"), sample("stubs"), sample("prints-success"),
                                             sample("segfault")};
  auto once = [&](const string& where, const char* jobs, const string& script) {
    std::vector<string> arguments = class_of_four;
    for (const string& word : {string("--out"), path(where), string("-j"), string(jobs)})
      arguments.push_back(word);
    const ProgramRun run = grade(arguments, {}, script);
    EXPECT_EQ(run.code, 0) << run.errors;
    std::map<string, string> all = files_in(root_ / where);
    EXPECT_EQ(all.erase("timing.json") + all.erase("costs.html"), 2U);
    return all;
  };
  const std::map<string, string> first = once("first", "1", ""), second = once("second", "2", other_shell);
  EXPECT_EQ(first.size(), second.size());
  for (const auto& [name, bytes] : first)
    EXPECT_TRUE(second.count(name) > 0 && second.at(name) == bytes) << name;
}

// The clock decides no points: a person reads of it, and grades again. It does not end the reference, which
// takes a second.
TEST_F(Hairgrade, ListsWhatTheClockEnded) {
  nlohmann::json course = course_of({"S1", "S2"});
  course["budget"] = {{"idle_seconds", 10000}, {"wall_seconds", 1}};  // half each
  write("sleeper/conj_grad.cpp",
        "#include \"solver/linearSolver.h\"\n#include <unistd.h>\n"
        "double ConjGrad(int, implicitMatrix*, double*, double*, double, int*) { for (;;) sleep(1); }\n");
  const std::vector<string> words = {
      path("sleeper"), "--out", out(), "--exercise", "S1", "--course", write("course.json", course.dump()),
      "--no-images"};
  const ProgramRun run = grade(words);
  EXPECT_EQ(run.code, 3) << run.errors;
  EXPECT_TRUE(says(run.errors, "not final, since the clock ended them: sleeper;"));
  EXPECT_TRUE(says(run.output, "NOT FINAL, ended by the clock: sleeper: S1"));
  const SubmissionResult result = recorded_result(out(), "sleeper").value();
  EXPECT_EQ(result.ended_by_the_clock, std::vector<string>{"S1"});
  EXPECT_EQ(result.fingerprint, "") << "the next run would keep it";
  EXPECT_TRUE(says(result.exercises.at(0).feedback, "not final"));
}

TEST_F(Hairgrade, ResumesWhatHasNotChanged) {
  earlier_run();
  const auto before = fs::last_write_time(fs::path(out()) / "other-order" / "results.json");
  const ProgramRun again = grade({sample("other-order"), "--out", out(), "--resume", "--junit"});
  EXPECT_TRUE(fs::exists(out() + "/junit.xml"));
  EXPECT_TRUE(says(again.output, "0 graded, 1 kept"));
  EXPECT_EQ(fs::last_write_time(fs::path(out()) / "other-order" / "results.json"), before);
  // This submission has the same name with other bytes.
  write("other-order/conj_grad.cpp", code_of("entry-test-inverted", "conj_grad.cpp"));
  const string changed = path("other-order"), grades = hair::bytes_of(out() + "/grades.csv");
  const ProgramRun refused = grade({changed, "--out", out(), "--resume"});
  EXPECT_EQ(refused.code, 2) << "it is of another origin";
  EXPECT_TRUE(says(refused.errors, "--replace"));
  EXPECT_EQ(hair::bytes_of(out() + "/grades.csv"), grades);
  const ProgramRun other = grade({changed, "--out", out(), "--resume", "--replace"});
  EXPECT_TRUE(says(other.output, "1 graded"));
  EXPECT_FALSE(fs::exists(out() + "/junit.xml")) << "it would be out of date";
}

TEST_F(Hairgrade, GradesOneExerciseAloneAndKeepsTheOthersOfAnEarlierRun) {
  const auto results = [&] {
    return nlohmann::json::parse(hair::bytes_of(fs::path(out()) / "other-order" / "results.json"));
  };
  ASSERT_EQ(grade({sample("other-order"), "--out", out(), "--exercise", "S2"}).code, 0);
  EXPECT_EQ(results().at("score"), 20);
  for (const nlohmann::json& test : results().at("tests")) EXPECT_EQ(test.at("tags").at(0), "S2");
  ASSERT_EQ(grade({sample("other-order"), "--out", out(), "--exercise", "S1"}).code, 0);
  EXPECT_EQ(results().at("score"), 52);
}

TEST_F(Hairgrade, KeepsNoObjectThatWasCompiledWithoutASandbox) {
  // Outside of the sandbox this file can include the staff's files; its object must not be used inside.
  write("thief/conj_grad.cpp", "#include \"" HAIR_PROJECT "/reference/S1/conj_grad.cpp\"\n");
  const string thief = path("thief");
  auto score = [](const string& folder) {
    return nlohmann::json::parse(hair::bytes_of(fs::path(folder) / "thief" / "results.json")).at("score");
  };
  const string outside = path("outside");
  ASSERT_EQ(grade({thief, "--out", outside, "--unsafe-no-sandbox"}).code, 0);
  EXPECT_EQ(score(outside), 32);
  EXPECT_TRUE(says(hair::bytes_of(fs::path(outside) / "index.html"), "without a sandbox"));
  ASSERT_EQ(grade({thief, "--out", out()}).code, 0);
  EXPECT_EQ(score(out()), 0);
}

TEST_F(Hairgrade, KeepsWhatIsFinishedWhenInterrupted) {
  const string everybody = path("class");
  add_to_class({"stubs"});
  ASSERT_EQ(grade({everybody, "--out", out()}).code, 0);
  // Submissions run in turn: `sleeps` would sleep until the watchdog ends it, and `stubs` is not reached.
  add_to_class({"other-order"});
  write("class/sleeps/conj_grad.cpp", "#include <unistd.h>\nstruct Sleep { Sleep() { sleep(100); } } now;\n" +
                                          code_of("perfect", "conj_grad.cpp"));
  const fs::path first = fs::path(out()) / "other-order" / "results.json",
                 page = fs::path(out()) / "index.html";
  EXPECT_FALSE(says(hair::bytes_of(page), "--resume"));
  const ProgramRun run = grade({everybody, "--out", out(), "-j", "1"}, [&](const RunningProgram& grades) {
    EXPECT_TRUE(grades.wait_until([&] { return fs::exists(first); }));
    EXPECT_TRUE(says(hair::bytes_of(page), "(UTC) and has not ended: 0 of 3 hand-ins are done"));
    kill(-grades.process, SIGINT);  // like Ctrl-C, goes to all processes
  });
  EXPECT_EQ(run.code, 130) << run.errors;
  EXPECT_TRUE(says(run.errors, "interrupted after 1 of 3"));
  EXPECT_TRUE(says(run.errors, "--resume"));
  EXPECT_TRUE(says(hair::bytes_of(page), "1 of 3 hand-ins were done when the run was interrupted at 20"));
  EXPECT_EQ(nlohmann::json::parse(hair::bytes_of(first)).at("score"), 52);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "sleeps"));
  const string gradebook = hair::bytes_of(fs::path(out()) / "grades.csv");
  EXPECT_TRUE(says(gradebook, "other-order,52"));
  EXPECT_TRUE(says(gradebook, "stubs,0"));
}

// The same course gives other points to S2.
TEST_F(Hairgrade, RegradesInPlaceAndLeavesTheResultsBeforeWhenKilled) {
  const string everybody = path("class");
  add_to_class({"stubs", "other-order"});
  ASSERT_EQ(grade({everybody, "--out", out(), "--no-images"}).code, 0);
  ASSERT_EQ(run_hairgrade({"set", "stubs", "S2", "15", "--why", "x", "--out", out()}).code, 0);
  ASSERT_EQ(run_hairgrade({"comment", "stubs", "all", "well begun", "--out", out()}).code, 0);
  nlohmann::json course = course_of({"S1", "S2"});
  course["exercises"]["S2"]["points"] = 10;
  const std::vector<string> other{
      everybody, "--no-images", "--resume", "--out", out(), "--course", write("other.json", course.dump())};
  const auto regrade = [&](const std::function<void(const RunningProgram&)>& meanwhile = {}) {
    std::vector<string> words = other;
    words.insert(words.end(), {"--regrade", "-j", "1"});
    return grade(words, meanwhile);
  };
  const auto files = [&] { return files_in(out()); };
  const auto before = files();
  EXPECT_TRUE(says(grade(other).errors, "--regrade to grade all of them again in place"));
  const ProgramRun killed = regrade([&](const RunningProgram& grades) {
    EXPECT_TRUE(grades.wait_until([&] { return Record(out(), kStage).names().size() == 1; }));
    kill(-grades.process, SIGKILL);
  });
  EXPECT_EQ(killed.code, -1);
  EXPECT_EQ(files(), before);
  EXPECT_EQ(Record(out()).find("other-order")->result.exercises[1].max_points, 20);

  const ProgramRun whole = regrade();
  EXPECT_EQ(whole.code, 3) << whole.errors;
  EXPECT_TRUE(says(whole.output, "1 graded, 1 kept from before"));
  EXPECT_TRUE(
      says(whole.errors, "set S2 to 15 where 0 of 20 points had been computed, and now it is worth 10"));
  EXPECT_TRUE(says(whole.output, "1 of 2 have other points: " + out() + "/changes.html\n"));
  EXPECT_TRUE(says(files().at("changes.html"), "S2.1 4 -&gt; 2; S2.2 "));
  EXPECT_TRUE(says(files().at("stubs/report.html"), "well begun"));
  EXPECT_EQ(grade(other).code, 3) << "the record is of the other course now";
  EXPECT_TRUE(says(grade({everybody, "--out", out(), "--regrade", "--exercise", "S1"}).errors, "--exercise"));
}

TEST_F(Hairgrade, WithoutImagesTheWholeRunHasItsPoints) {
  earlier_run();
  const auto points_in = [](const fs::path& folder) {
    std::map<string, double> all;
    const SubmissionResult result = recorded_result(folder, "other-order").value();
    for (const ExerciseResult& exercise : result.exercises)
      for (const CaseResult& one : exercise.cases) all[exercise.id + " " + one.name] = one.points;
    return all;
  };
  const fs::path blind = root_ / "blind";
  const ProgramRun run = grade({sample("other-order"), "--out", blind.string(), "--no-images"});
  EXPECT_TRUE(says(run.output, ", without pictures"));
  EXPECT_EQ(points_in(blind), points_in(out()));
  EXPECT_EQ(points_in(blind).at("S1 The whole run"), 2);
}

}  // namespace
}  // namespace grader
