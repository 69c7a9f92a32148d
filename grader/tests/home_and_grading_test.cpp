// STAFF ONLY. Builds the same file as a student does in an unpacked handout, and as grading does: both
// succeed or both fail, for the same reason.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "grader/compile/compiler.h"
#include "grader/package/handout.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using tests::says;

const fs::path kProject = HAIR_PROJECT;

struct Ran {
  bool well;
  std::string output;
};

// Runs a command with the environment of a new shell.
Ran run(const std::string& command, const fs::path& folder = "/") {
  const hair::TemporaryFolder said("hair-said");
  const auto code = hair::exit_code_of(
      hair::start_program({.words = {"/bin/sh", "-c", "exec env -i PATH=\"$PATH\" " + command + " 2>&1"},
                           .output = said.path() / "output",
                           .folder = folder}));
  return {code == 0, hair::bytes_of(said.path() / "output")};
}

class HomeAndGrading : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    both_ = new Both;
    ASSERT_TRUE(run("cmake -E tar xf handout.tar.gz", both_->temporary.path()).well);
    const Ran configured = run("cmake --preset release", both_->handout);
    ASSERT_TRUE(configured.well) << configured.output;
  }
  static void TearDownTestSuite() { delete both_; }

  static const Exercise& exercise(const std::string& id) { return *both_->course.find(id); }
  static std::string reference(const std::string& id) {
    return hair::bytes_of(kProject / solution_of(exercise(id)));
  }

  // This is a folder of the build, without the handout's path.
  static fs::path handout() { return both_->handout; }

  // Links the library of `target`, "student" or "checked", which has sanitizers.
  static Ran at_home(const std::string& id, const std::string& source,
                     const std::string& target = "student") {
    std::ofstream(both_->handout / "student" / exercise(id).file) << source;
    return run("cmake --build '" + (both_->handout / "build").string() + "' --target " + target + "_" + id);
  }

  static Compiled in_grading(const std::string& id, const std::string& source) {
    return both_->compiler.compile(exercise(id), source, both_->kit.new_job(std::to_string(both_->jobs += 1)),
                                   200);
  }

  static void builds_in_both(const std::string& id, const std::string& source) {
    const Ran home = at_home(id, source);
    EXPECT_TRUE(home.well) << home.output;
    const Compiled graded = in_grading(id, source);
    EXPECT_FALSE(graded.object.empty()) << graded.messages << graded.log;
  }

  // Expects that both fail with `reason`.
  static void builds_in_neither(const std::string& id, const std::string& source, const std::string& reason,
                                const std::string& target = "student") {
    const Ran home = at_home(id, source, target);
    EXPECT_FALSE(home.well) << "at home";
    EXPECT_TRUE(says(home.output, reason));
    const Compiled graded = in_grading(id, source);
    EXPECT_TRUE(graded.object.empty()) << "in grading";
    EXPECT_TRUE(says(graded.messages, reason)) << graded.log;
  }

 private:
  struct Both {
    Both() { make_handout({kProject, HAIR_GOLDEN_DIR}, course, temporary.path() / "handout.tar.gz"); }
    const Course course = read_course(kProject / "handout/exercises.json");
    const hair::TemporaryFolder temporary{"hair-both"};
    const fs::path handout = temporary.path() / "hair-assignment";
    const StagedKit kit{HAIR_KIT_DIR, course};
    const Compiler compiler{kit, temporary.path() / "cache", isolation_for_tests()};
    int jobs = 0;
  };
  static inline Both* both_ = nullptr;
};

TEST_F(HomeAndGrading, AHeaderIsFoundHoweverItsPathIsWritten) {
  std::string lines;
  for (const char* path :
       {"\"solver/linearSolver.h\"", "<solver/linearSolver.h>", "\"../solver/linearSolver.h\"",
        "\"./../solver/linearSolver.h\"", "\".././solver/./linearSolver.h\"", "<../solver/linearSolver.h>",
        "\"linearSolver.h\"", "<linearSolver.h>", "\"solver/matrices.h\"", "\"../solver/matrices.h\"",
        "<../solver/matrices.h>", "\"given/solver/matrices.h\"", "\"../given/solver/matrices.h\"",
        "\"../given/../solver/lecture/linearSolver.h\"", "\"hair/../solver/timing.h\"", "<bits/stdc++.h>",
        "<sys/time.h>", "<vector>"})
    lines += "#include " + std::string(path) + "\n";
  builds_in_both("S1", lines + reference("S1"));
}

// Neither finds files of a student's folder that are not handed in, or the machine's other libraries.
TEST_F(HomeAndGrading, AnotherFileIsFoundInNeither) {
  const fs::path student = handout() / "student";
  for (const fs::path& file :
       {student / "helper.h", student / "unread.h", student / "my helper.hpp", handout() / "above.h",
        student / "below/helper.h", handout().parent_path() / "beside/helper.h"}) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "#pragma once\n";
  }
  // These stand behind code that is skipped, so that nothing depends on a first line.
  const std::string skipped =
      "#ifdef ANOTHER_SYSTEM\n#include \"unread.h\"\n#include <gtest/gtest.h>\n#endif\n";
  const std::string source = skipped + reference("S1");
  // Asks grading's compiler for all of them at once, and for two that are there.
  std::string asks = source +
                     "#if !__has_include(\"solver/linearSolver.h\") || !__has_include(<vector>)\n"
                     "#error nothing is found\n#endif\n";
  for (const char* path :
       {"\"helper.h\"", "\"./helper.h\"", "\"my helper.hpp\"", "\"below/helper.h\"", "\"student/helper.h\"",
        "<student/helper.h>", "\"../student/helper.h\"", "\"hair/../student/helper.h\"", "\"../above.h\"",
        "<above.h>", "\"../../beside/helper.h\"", "\"normal_equations.cpp\"",
        "\"student/normal_equations.cpp\"", "\"checks/check.h\"", "\"../checks/check.h\"",
        "\"gtest/gtest.h\"", "<gtest/gtest.h>", "<eigen3/Eigen/Core>", "<nlohmann/json.hpp>"}) {
    const std::string name = std::string(path + 1).substr(0, std::strlen(path) - 2);
    const Ran home = at_home("S1", source + "#include " + path + "\n");
    EXPECT_FALSE(home.well) << path;
    EXPECT_TRUE(says(home.output, name + ": No such file or directory")) << path;
    asks += "#if __has_include(" + std::string(path) + ")\n#error found: " + path + "\n#endif\n";
  }
  const Compiled graded = in_grading("S1", asks);
  EXPECT_FALSE(graded.object.empty()) << graded.messages << graded.log;
  builds_in_neither("S1", source + "#include \"helper.h\"\n", "helper.h: No such file or directory");
  // A line that the compiler skips costs nothing.
  builds_in_both("S1", source);
  fs::remove_all(handout().parent_path() / "beside");
}

// Lists the functions that a library defines for others, by the linker's names.
std::set<std::string> functions_of(const fs::path& archive) {
  std::set<std::string> names;
  const Ran listed = run("nm --defined-only --extern-only --format=posix '" + archive.string() + "'");
  EXPECT_TRUE(listed.well) << listed.output;
  std::istringstream lines(listed.output);
  std::string line, name, kind;
  while (std::getline(lines, line))
    if (std::istringstream(line) >> name >> kind && kind == "T") names.insert(name);
  return names;
}

// Writes a table of their addresses.
std::string naming(const std::set<std::string>& functions) {
  std::string text = "asm(\".pushsection .data\\n\"\n";
  for (const std::string& name : functions) text += "\".quad " + name + "\\n\"\n";
  return text + "\".popsection\");\n";
}

// Each declared function of the given headers that is defined elsewhere belongs to a library.
TEST_F(HomeAndGrading, EveryFunctionOfTheGivenLibrariesIsLinked) {
  const fs::path given = handout() / "build/given";
  ASSERT_TRUE(at_home("P1", reference("P1")).well);
  const std::set<std::string> standard = functions_of(given / "solver/libhair_solver.a");
  EXPECT_GT(standard.size(), 10u);
  builds_in_both("S1", reference("S1") + naming(standard));

  std::set<std::string> eigen = standard;
  for (const char* archive : {"particles/libhair_particles.a", "solver/libhair_block_bands.a"}) {
    const std::size_t before = eigen.size();
    eigen.merge(functions_of(given / archive));
    EXPECT_GT(eigen.size(), before + 1) << archive;
  }
  builds_in_both("P1", reference("P1") + naming(eigen));
}

TEST_F(HomeAndGrading, WhatNoLibraryHasIsNamed) {
  const std::string nowhere = "\nint nowhere(double);\nint asks_nowhere() { return nowhere(1); }\n";
  builds_in_neither("S1", reference("S1") + nowhere, "nowhere(double)");
  // check-S1 links so.
  builds_in_neither("S1", reference("S1") + nowhere, "nowhere(double)", "checked");
  // These are given code of hairlab, and an exercise that this one does not need.
  builds_in_neither("P1",
                    "#include \"solver/dense_algebra.h\"\n" + reference("P1") +
                        "auto asks() { return &solver::symmetric_eigenvalues; }\n",
                    "solver::symmetric_eigenvalues");
  builds_in_neither(
      "P1", "#include \"solver/linearSolver.h\"\n" + reference("P1") + "auto asks() { return &ConjGrad; }\n",
      "ConjGrad(int, implicitMatrix*, double*, double*, double, int*)");
}

// Among them are constants by which solutions size their memory.
TEST_F(HomeAndGrading, EachHeaderHasTheSameBytesInBoth) {
  const auto headers_of = [](const fs::path& top) {
    std::map<std::string, std::string> headers;
    for (const char* folder : {"solver", "particles", "hair", "given"})
      for (const auto& entry : fs::recursive_directory_iterator(top / folder))
        if (entry.path().extension() == ".h")
          headers[fs::relative(entry.path(), top).string()] = hair::bytes_of(entry.path());
    return headers;
  };
  const auto home = headers_of(handout()), graded = headers_of(fs::path(HAIR_KIT_DIR) / "handout");
  EXPECT_GT(home.size(), 100u);
  for (const auto& [name, bytes] : home)
    EXPECT_TRUE(graded.contains(name) && graded.at(name) == bytes) << name;
  EXPECT_EQ(graded.size(), home.size());
}

// Code may ask for the compiler's options. An assert holds in both or in neither.
TEST_F(HomeAndGrading, TheCompilerIsAskedForTheSame) {
  const std::string source =
      "#if defined NDEBUG || !defined __OPTIMIZE__ || !defined __PIC__ || !defined __STRICT_ANSI__ || "
      "__cplusplus != 202002L || defined _GLIBCXX_ASSERTIONS || defined __FAST_MATH__ || defined __FMA__ || "
      "defined _FORTIFY_SOURCE || defined __SANITIZE_ADDRESS__\n#error \"built otherwise\"\n#endif\n" +
      reference("S1");
  builds_in_both("S1", source);
  const Ran checked = at_home("S1", source, "checked");
  EXPECT_TRUE(checked.well) << checked.output;
}

// An S1 that forgets to set its result returns the same value in both, with the same warning.
TEST_F(HomeAndGrading, AVariableThatNobodySetsHoldsTheSameInBoth) {
  const std::string source =
      "#include \"solver/linearSolver.h\"\n"
      "double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {\n"
      "  double sum;\n  return sum;\n}\n";
  const Ran home = at_home("S1", source);
  ASSERT_TRUE(home.well) << home.output;
  const Compiled graded = in_grading("S1", source);
  ASSERT_FALSE(graded.object.empty()) << graded.log;
  const std::string warning =
      "conj_grad.cpp:4:10: warning: 'sum' is used uninitialized [-Wuninitialized]\n"
      "conj_grad.cpp:2:";
  EXPECT_TRUE(graded.messages.starts_with(warning)) << graded.messages;
  EXPECT_TRUE(says(graded.messages, "unused parameter 'epsilon'"));
  EXPECT_EQ(in_grading("S1", source).messages, graded.messages) << "from the cache";

  for (const fs::path& object : {handout() / "build/libstudent_S1.so", graded.object}) {
    void* const loaded = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(loaded, nullptr) << dlerror();
    using Function = double (*)(int, void*, double*, double*, double, int*);
    const auto solve = reinterpret_cast<Function>(dlsym(loaded, "_Z8ConjGradiP14implicitMatrixPdS1_dPi"));
    ASSERT_NE(solve, nullptr) << dlerror();
    const double found = solve(0, nullptr, nullptr, nullptr, 0, nullptr);
    unsigned char bytes[sizeof found];
    std::memcpy(bytes, &found, sizeof found);
    for (const unsigned char byte : bytes) EXPECT_EQ(byte, 0xfe) << object;
    dlclose(loaded);
  }
}

// The lecture's first program prints x and the steps. filled_blocks_test tests a worker's memory.
TEST_F(HomeAndGrading, AProgramAtHomeFillsMemoryAsTheWorkerDoes) {
  const std::string source =
      "#include \"solver/linearSolver.h\"\n#include <vector>\n"

      "double ConjGrad(int, implicitMatrix*, double x[], double[], double, int* steps) {\n"
      "  int* fresh = new int[10];\n  *steps = fresh[5];\n  delete[] fresh;\n"
      "  for (int i = 0; i < 100; ++i) std::vector<double>(20, 1.5);\n"
      "  double* again = new double[20];\n  x[0] = again[0];\n  x[1] = again[19];\n  delete[] again;\n"
      "  return 0;\n}\n";
  ASSERT_TRUE(at_home("S1", source).well);
  const Ran built = run("cmake --build '" + (handout() / "build").string() + "' --target student_example1");
  ASSERT_TRUE(built.well) << built.output;
  double number;
  int steps;
  std::memset(&number, 0xfe, sizeof number);
  std::memset(&steps, 0xfe, sizeof steps);
  char expected[1000];
  snprintf(expected, sizeof expected, "Solved in %i steps with error 0.000000.\nA1 * [%f %f]^T", steps,
           number, number);
  const Ran ran = run((handout() / "build/student_example1").string());
  EXPECT_TRUE(ran.output.starts_with(expected)) << ran.output << "\nexpected:\n" << expected;
}

}  // namespace
}  // namespace grader
