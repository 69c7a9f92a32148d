// STAFF ONLY. Tests that memory errors are found and named in our words, with the called function, and other
// ends of workers that look for them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "grader/compile/compiler.h"
#include "grader/grading/ask_conj_grad.h"
#include "grader/grading/exercise_grading.h"
#include "grader/grading/grading.h"
#include "grader/grading/settings_for_tests.h"
#include "grader/grading/suite_jobs.h"
#include "grader/judge/memory_points.h"
#include "grader/report/facts/student_view.h"
#include "grader/sandbox/processes/control_group.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/wire/memory_error.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;

GradingSettings settings_without_images() {
  GradingSettings settings = settings_for_tests();
  settings.cache = HAIR_TEST_CACHE;
  settings.secret = "a secret for tests alone";
  settings.images = false;
  return settings;
}

class MemoryErrorsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!memory_can_be_bounded()) GTEST_SKIP() << "no control group can bound memory here";
  }

  // Makes a ConjGrad that solves nothing.
  static std::string function(const std::string& body) {
    return "#include \"solver/linearSolver.h\"\n#include <climits>\n#include <cstdlib>\n"
           "double ConjGrad(int n, implicitMatrix*, double x[], double b[], double, int* steps) {\n" +
           body + "\n}\n";
  }

  Compiled sanitised(const std::string& source, const std::string& name, double seconds = 200) const {
    return compiler_.compile(s1_, source, kit_.new_job(name), seconds, Build::sanitised);
  }

  // Returns the answer of a worker with this object to a request with n = 4.
  Answer ask(const fs::path& object) const {
    WorkerSetup setup;
    setup.isolation = settings_.isolation;
    setup.log = kit_.folder().parent_path() / "log";
    setup.sanitised = true;
    setup.cpu_seconds = 1000;  // a slow machine needs long to touch all memory
    setup.allowance->limit.worker_cpu_seconds = 1000;
    return ask_conj_grad(setup, kit_, object, 4);
  }

  struct Found {
    Outcome outcome;
    std::string shown;
  };

  Found look(const std::string& source, const std::string& name) const {
    const Compiled compiled = sanitised(source, name);
    if (compiled.object.empty()) return {Outcome::cannot_load, compiled.log};
    Answer answer = ask(compiled.object);
    if (answer.outcome != Outcome::memory_error) return {answer.outcome, answer.note};
    return {answer.outcome, read_memory_error(answer.reply).shown};
  }

  // Grades a whole S1, with and without the search for memory errors.
  struct GradedExercise {
    ExerciseResult result;
    ExerciseTiming timing;
  };
  GradedExercise grade_timed(const std::string& source, bool memory_errors, const std::string& name) {
    settings_.memory_errors = memory_errors;
    const SuiteJobs jobs(settings_, kit_);
    Submission submission;
    submission.name = "somebody";
    submission.files[s1_.file].text = source;
    GradedExercise graded{describe(s1_), {}};
    grade_exercise(jobs, compiler_, s1_, submission, kit_.new_job(name), 30, graded.result, graded.timing);
    return graded;
  }
  ExerciseResult grade(const std::string& source, bool memory_errors, const std::string& name) {
    return grade_timed(source, memory_errors, name).result;
  }

  static const CaseResult* memory_case(const ExerciseResult& result) {
    for (const CaseResult& one : result.cases)
      if (one.name == kMemoryTitle) return &one;
    return nullptr;
  }

  GradingSettings settings_ = settings_without_images();
  const Exercise& s1_ = *settings_.course.find("S1");
  const StagedKit kit_{settings_.kit, settings_.course};
  const Compiler compiler_{kit_, settings_.cache, settings_.isolation};
};

struct Mistake {
  const char* name;
  const char* body;
  const char* shown;
};

TEST_F(MemoryErrorsTest, AreNamed) {
  const Mistake mistakes[] = {
      {"heap", "double* volatile a = new double[n];\na[0] = 1;\nx[1] = a[n];\ndelete[] a;\nreturn 0;",
       "reaches outside of memory that it got from new or malloc"},
      {"freed", "double* volatile a = new double[n];\na[1] = x[0];\ndelete[] a;\nreturn a[1];",
       "uses memory that is freed already"},
      {"twice", "double* volatile a = new double[n];\na[1] = x[0];\ndelete[] a;\ndelete[] a;\nreturn 0;",
       "uses memory that is freed already|frees the same memory twice"},
      {"stack", "volatile double a[4] = {};\nvolatile double* p = a;\np[n] = x[0];\nreturn a[1];",
       "reaches outside of an array or a variable on the stack"},
      {"index", "volatile double a[4] = {};\na[n] = x[0];\nreturn a[1];",
       "has an index outside of its array"},
      {"static", "static double a[4];\ndouble* volatile p = a;\np[n + 1] = x[0];\nreturn a[1];",
       "reaches outside of a static or global array"},
      {"before", "double sum = 0;\nfor (int i = -1; i < n; ++i) sum += x[i];\nreturn sum;",
       "reaches outside of an array that it was given"},
      {"behind", "double sum = 0;\nfor (int i = 0; i <= n; ++i) sum += x[i];\nreturn sum;",
       "reaches outside of an array that it was given"},
      {"wild", "volatile double* volatile p = b + (1L << 40);\n*p = 1;\nreturn 0;",
       "reaches to an address where there is nothing"},
      {"null",
       "double* volatile p = nullptr;\nif (n == 4) *static_cast<volatile double*>(p) = b[0];\nreturn 0;",
       "follows a null pointer"},
      {"overflow", "volatile int most = INT_MAX;\nmost = most + n;\nreturn 0;",
       "computes an integer that is too large for its type"},
      {"zero", "volatile int zero = 0;\n*steps = n / zero;\nreturn 0;", "divides an integer by zero"},
      {"other-free", "double* volatile a = new double[n];\na[1] = x[0];\ndelete a;\nreturn 0;",
       "frees memory in another way than it was allocated: delete for new[], or free for new"},
      {"no-return", "if (n < 4) return x[0];", "comes to the end of a function without a return"},
  };
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.name);
    const Found found = look(function(mistake.body), mistake.name);
    EXPECT_EQ(found.outcome, Outcome::memory_error);
    EXPECT_NE(("|" + std::string(mistake.shown) + "|").find("|" + found.shown + "|"), std::string::npos)
        << found.shown;
  }
}

TEST_F(MemoryErrorsTest, AreNotWhatIsMerelyUnusual) {
  const char* right[] = {
      "double* a = new double[n];\na[0] = 1;\nreturn a[0];",                          // leaks
      "try { throw 1; } catch (int) {}\nvolatile double a[400] = {};\nreturn a[n];",  // its own exceptions
      "double a[n * 1000];\nfor (int i = 0; i < n; ++i) a[i] = x[i];\nreturn a[n - 1];",  // variable length
      "#ifdef __SANITIZE_ADDRESS__\n#error it looks different\n#endif\nreturn 0;",
      "unsigned most = UINT_MAX;\nmost += n;\nreturn most;",
  };
  for (const char* body : right) {
    SCOPED_TRACE(body);
    const Found found = look(function(body), "right-" + std::to_string(&body - right));
    EXPECT_EQ(found.outcome, Outcome::done) << found.shown;
  }
}

TEST_F(MemoryErrorsTest, AreFoundBehindAnExceptionOfOurs) {
  // Frames that an exception leaves are forgotten; code after it is watched as before.
  const std::string body =
      "struct Deep {\n  static double go(int k) {\n    volatile double a[64] = {};\n    if (k == 0) throw "
      "1;\n"
      "    return go(k - 1) + a[k];\n  }\n};\nfor (int k = 0; k < 50; ++k) {\n  try { Deep::go(k); } catch "
      "(int) {}\n"
      "  volatile double other[512] = {};\n  x[0] = other[k];\n}\nreturn 0;";
  const Found found = look(function(body), "deep");
  EXPECT_EQ(found.outcome, Outcome::done) << found.shown;
}

// This sample has a memory error that no case finds.
TEST_F(MemoryErrorsTest, CostAPointThatNothingElseCosts) {
  std::string source = hair::bytes_of(kProject / "reference/S1/right/plain.cpp");
  const std::string vectors = "  vector<double> r(n), d(n), q(n), x_new(n);\n";
  ASSERT_NE(source.find(vectors), std::string::npos);
  const std::string right = source;
  // Compilers put the later one first.
  source.replace(source.find(vectors), 0,
                 "  static volatile double behind[16384];\n  static double table[1000];\n"
                 "  behind[12000 + *steps % 9] = 1;\n  double* volatile p = table;\n"
                 "  for (int i = 0; i < n; ++i) p[i] = 1;\n");

  const ExerciseResult seen = grade(source, true, "seen"), unseen = grade(source, false, "unseen");
  EXPECT_EQ(unseen.status, Status::passed) << "the sanitizers alone see it";
  EXPECT_DOUBLE_EQ(unseen.points, s1_.points);
  EXPECT_EQ(memory_case(unseen), nullptr);
  EXPECT_NE(unseen.feedback.find("Memory errors were not looked for"), std::string::npos) << unseen.feedback;

  EXPECT_EQ(seen.status, Status::partly);
  EXPECT_DOUBLE_EQ(seen.points, s1_.points - 1);
  ASSERT_NE(memory_case(seen), nullptr);
  SubmissionResult submission;
  submission.exercises = {seen};
  const SubmissionResult view = for_student(submission);
  EXPECT_EQ(memory_case(view.exercises[0])->feedback,
            "The code reaches outside of a static or global array, in a call of ConjGrad.");
  EXPECT_EQ(seen.feedback.find("not looked for"), std::string::npos);

  const ExerciseResult honest = grade(right, true, "right");
  EXPECT_DOUBLE_EQ(honest.points, s1_.points);
  double most = 0, most_unseen = 0;
  for (const CaseResult& one : seen.cases) most += one.max_points;
  for (const CaseResult& one : unseen.cases) most_unseen += one.max_points;
  EXPECT_DOUBLE_EQ(most, most_unseen);
}

TEST_F(MemoryErrorsTest, AreNotThreads) {
  const std::string right = hair::bytes_of(kProject / "reference/S1/right/plain.cpp");
  const ExerciseResult result = grade(
      "#define ConjGrad solve\n" + right +
          "#undef ConjGrad\n#include <thread>\n"
          "double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {\n"
          "  double value = 0;\n"
          "  std::thread([&] { value = solve(n, A, x, b, epsilon, steps); }).join();\n"
          "  return value;\n}\n",
      true, "thread");
  EXPECT_DOUBLE_EQ(result.points, s1_.points);
  ASSERT_NE(memory_case(result), nullptr);
  EXPECT_EQ(memory_case(result)->feedback + memory_case(result)->detail, "");
}

// A file that switches the sanitizers off loses the point, and its student reads why.
TEST_F(MemoryErrorsTest, GiveNoPointWhereNobodyCanLook) {
  const std::string right = hair::bytes_of(kProject / "reference/S1/right/plain.cpp");
  const double without = s1_.points - 1;
  const ExerciseResult off =
      grade(right + "[[gnu::no_sanitize_address]] void unused() {}\n", true, "switched-off");
  EXPECT_DOUBLE_EQ(off.points, without);
  const auto lines = std::count(right.begin(), right.end(), '\n') + 1;
  EXPECT_EQ(memory_case(off)->feedback,
            "Line " + std::to_string(lines) +
                " of conj_grad.cpp keeps parts of the code from the look for memory errors, by "
                "\"no_sanitize_address\", so there is no point for it.");

  const ExerciseResult refused = grade(right + "extern \"C\" void __asan_load8(void*) {}\n", true, "defines");
  EXPECT_EQ(refused.status, Status::does_not_compile);
  EXPECT_NE(refused.compiler_messages.find("defines __asan_load8"), std::string::npos)
      << refused.compiler_messages;

  // Without an object the build with sanitizers seems to have met a limit.
  const fs::path job = kit_.new_job("no-object");
  const SuiteJobs jobs(settings_, kit_);
  ExerciseResult limited = describe(s1_);
  ExerciseTiming timing;
  run_cases(jobs, s1_, "somebody", compiler_.compile(s1_, right, job, 200).object, job, Compiled{}, limited,
            timing);
  EXPECT_DOUBLE_EQ(limited.points, without);
}

// The search comes last, and has the rest of the exercise's share.
TEST_F(MemoryErrorsTest, AreLookedForAtNoOthersCost) {
  std::string source = hair::bytes_of(kProject / "reference/S1/right/plain.cpp");
  const std::string vectors = "  vector<double> r(n), d(n), q(n), x_new(n);\n";
  ASSERT_NE(source.find(vectors), std::string::npos);
  source.replace(source.find(vectors), 0,
                 "  if (&__asan_init != nullptr)\n    for (volatile int i = 0;; i = 1 - i) {\n    }\n");
  source = "extern \"C\" __attribute__((weak)) void __asan_init();\n" + source;
  // A worker may then use up an exercise's share.
  settings_.course.budget.worker_cpu_seconds = 2.5 * static_cast<double>(settings_.course.exercises.size());
  const auto [result, timing] = grade_timed(source, true, "slow");
  EXPECT_DOUBLE_EQ(result.points, s1_.points) << "slow code keeps the point";
  const double share = SuiteJobs(settings_, kit_).allowance("S1").worker_cpu_seconds;
  const double others = timing.spent.worker_cpu_seconds - timing.sanitised_cpu_seconds;
  EXPECT_GT(timing.sanitised_cpu_seconds, std::min(1.0, share - others) - 0.1) << "it has what is left";
  EXPECT_LT(timing.spent.worker_cpu_seconds, share + 1);
}

// A worker that does not run on this machine must cost no student a point: no submission is graded.
TEST_F(MemoryErrorsTest, AreLookedForInTheReferenceFirst) {
  const hair::TemporaryFolder folder("kit");
  settings_.kit = folder.path() / "kit";
  fs::copy(HAIR_KIT_DIR, settings_.kit, fs::copy_options::recursive);
  std::ofstream(settings_.kit / "sanitised/worker") << "#!/bin/no/such/shell\n";
  settings_.exercise = "S1";
  try {
    const Grading grading(settings_);
    FAIL() << "the reference is not asked";
  } catch (const std::runtime_error& why) {
    const std::string said = why.what();
    EXPECT_TRUE(said.starts_with("the reference fails its own suite for S1, in \"No memory errors\""))
        << said;
    const bool bwrap = settings_.isolation == Isolation::namespaces;
    EXPECT_NE(
        said.find(bwrap ? "the worker says: bwrap: execvp /worker" : "the worker says: /worker can't be"),
        std::string::npos)
        << said;
  }
}

// A user that owns no control group can't bound memory, and starts no worker with sanitizers.
TEST_F(MemoryErrorsTest, AreNotLookedForWithoutAControlGroup) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
  const pid_t child = fork();
  if (child == 0) {
    if (!become(sandbox_identity())) _exit(3);
    const std::optional<ControlGroup> group = ControlGroup::create(std::size_t{1} << 30, 8);
    if (group && group->bounds_memory()) _exit(4);
    Sandbox sandbox;
    sandbox.isolation = Isolation::none;
    sandbox.limits.memory_of_group = true;
    try {
      SandboxedProcess process(sandbox, {"/bin/true"}, -1, -1, -1);
      _exit(5);
    } catch (const std::runtime_error&) {
      _exit(0);
    }
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(MemoryErrorsTest, DoNotIncludeMemoryThatIsUsedUp) {
  const Found found = look(function("for (;;) {\n  volatile char* a = new char[1 << 26];\n"
                                    "  for (int i = 0; i < 1 << 26; i += 4096) a[i] = 1;\n}"),
                           "greedy");
  EXPECT_EQ(found.outcome, Outcome::out_of_memory) << found.shown;
}

}  // namespace
}  // namespace grader::grading
