// STAFF ONLY. Tests that student files become objects, with a precompiled header and without.
#include "grader/compile/compiler.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "grader/compile/cache.h"
#include "grader/course/course.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline compile {
namespace {
namespace fs = std::filesystem;

using tests::says;

const fs::path kCache = HAIR_TEST_CACHE;

class CompilerTest : public testing::Test {
 protected:
  // The precompiled header may be of an earlier run; objects may not.
  CompilerTest() { forget_objects(); }

  static void forget_objects() {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(kCache, none))
      if (entry.path().extension() == ".object") fs::remove(entry.path());
  }

  std::string reference(const Exercise& exercise) const {
    return hair::bytes_of(HAIR_PROJECT / solution_of(exercise));
  }

  Compiled compile(const Exercise& exercise, const std::string& source, const fs::path& job) const {
    return compiler_.compile(exercise, source, job, kSeconds);
  }
  Compiled compile(const Exercise& exercise, const std::string& source) {
    return compile(exercise, source, kit_.new_job(std::to_string(++jobs_)));
  }

  static constexpr double kSeconds = 200;  // is CPU time for a slow machine, too

  const Course course_ = read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json");
  const Exercise& with_eigen_ = *course_.find("H1");
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  const Compiler compiler_{kit_, kCache, isolation_for_tests()};
  int jobs_ = 0;
};

TEST_F(CompilerTest, WhatMustComeBeforeEigenMayComeBeforeEigen) {
  // Eigen has this function with this macro alone, which comes too late for a precompiled header.
  const std::string source = "#define EIGEN_RUNTIME_NO_MALLOC\n" + reference(with_eigen_) +
                             "bool may_allocate() { return Eigen::internal::is_malloc_allowed(); }\n";
  const Compiled compiled = compile(with_eigen_, source);
  EXPECT_FALSE(compiled.object.empty()) << compiled.log;
}

TEST_F(CompilerTest, MessagesAreThoseOfTheFileItself) {
  const Compiled compiled = compile(with_eigen_, "#include \"hair/stretch_springs.h\"\nint one = two;\n");
  EXPECT_TRUE(compiled.object.empty());
  EXPECT_EQ(compiled.messages, "stretch_springs.cpp:2:11: error: 'two' was not declared in this scope\n");
  EXPECT_FALSE(says(compiled.log, "precompiled"));
}

TEST_F(CompilerTest, TellsTheErrorsThatAHeaderHasBecauseOfTheFile) {
  for (const auto& [id, source, error, place] :
       {std::array<std::string, 4>{"S1", "class implicitMatrix {};\n#include \"linearSolver.h\"\n",
                                   ".h:11:7: error: redefinition of 'class implicitMatrix'\n",
                                   "\nconj_grad.cpp:1:7: note: "},
        {"S1", "#include <set>\nstruct A {};\nvoid f(std::set<A> all) { all.insert(A()); }\n",
         ": error: no match for 'operator<'", "conj_grad.cpp:3:"},
        {"H1", "#include <Eigen/Core>\nvoid f() { Eigen::Vector2d a(Eigen::Vector3d::Zero()); }\n",
         ": error: static assertion failed: YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES\n",
         "stretch_springs.cpp:2:"}}) {
    const Exercise& exercise = *course_.find(id);
    const Compiled compiled = compile(exercise, source);
    for (const std::string& part : {error, place}) EXPECT_TRUE(says(compiled.messages, part)) << compiled.log;
    EXPECT_FALSE(says(compiled.messages, "/handout"));
  }
}

// Otherwise a grade could depend on when, or how often, a file was compiled.
TEST_F(CompilerTest, TheSameFileBecomesTheSameBytesAtAnyTime) {
  const Exercise& exercise = *course_.find("S1");
  const std::string source = reference(exercise) +
                             "extern const char* const when;\n"
                             "const char* const when = __DATE__ __TIME__ __TIMESTAMP__;\n"
                             "namespace { struct Here { virtual ~Here() = default; }; }\n"
                             "void* make_here();\nvoid* make_here() { return new Here; }\n";
  std::string first;
  for (int run = 0; run < 2; ++run) {
    forget_objects();
    const Compiled compiled = compile(exercise, source);
    ASSERT_FALSE(compiled.object.empty()) << compiled.log;
    if (run == 0) {
      first = hair::bytes_of(compiled.object);
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // __TIME__ has seconds
    } else {
      EXPECT_EQ(hair::bytes_of(compiled.object), first);
    }
  }
}

TEST_F(CompilerTest, WarningsAreKeptWithTheObject) {
  const Exercise& exercise = *course_.find("S1");
  const std::string source = reference(exercise) + "#warning look here\n";
  const Compiled first = compile(exercise, source);
  ASSERT_FALSE(first.object.empty()) << first.log;
  EXPECT_TRUE(says(first.log, "look here"));
  const fs::path job = kit_.new_job("warns-2");
  const Compiled again = compile(exercise, source, job);
  EXPECT_FALSE(fs::exists(job / "source")) << "it was compiled once more";
  EXPECT_EQ(again.log, first.log);
}

// Long compiler output loses its middle, and the object stays whole.
TEST_F(CompilerTest, AFileWithALotOfWarningsCompiles) {
  const Exercise& exercise = *course_.find("S1");
  std::string warnings;
  for (int i = 0; i < 500; ++i)
    warnings += "#warning " + std::string(400, 'w') + " number " + std::to_string(i) + "\n";
  const Compiled right = compile(exercise, reference(exercise) + warnings);
  EXPECT_FALSE(right.object.empty());
  EXPECT_LT(right.log.size(), 70000U);
  for (const char* said : {"number 0 [", "bytes are left out here)", "number 499 ["})
    EXPECT_TRUE(says(right.log, said));
  const Compiled wrong = compile(exercise, reference(exercise) + warnings + "int one = two;\n");
  EXPECT_TRUE(wrong.object.empty());
  EXPECT_TRUE(says(wrong.messages, "'two' was not declared"));
}

TEST_F(CompilerTest, ASourceInAnotherEncodingIsToldByItsName) {
  const Exercise& exercise = *course_.find("S1");
  std::string wide;
  for (const char letter : reference(exercise)) wide += {letter, '\0'};
  const Compiled utf16 = compile(exercise, wide);
  EXPECT_TRUE(utf16.object.empty());
  EXPECT_TRUE(utf16.messages.starts_with("conj_grad.cpp is UTF-16 (little-endian)")) << utf16.messages;
  // In a comment Latin-1 is no mistake, nor are NULs.
  const std::string stray = reference(exercise) + "// L\xf6sung\n" + std::string(3, '\0');
  EXPECT_FALSE(compile(exercise, stray).object.empty());
  const Compiled both = compile(exercise, "int l\xf6sung;\nint one = two;\n");
  EXPECT_TRUE(says(both.messages, "conj_grad.cpp holds a byte in line 1"));
}

TEST_F(CompilerTest, TwoThreadsThatWantTheSameObjectCompileItOnce) {
  const Exercise& exercise = *course_.find("S1");
  const fs::path jobs[] = {kit_.new_job("at-once-0"), kit_.new_job("at-once-1")};
  Compiled compiled[2];
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 2; ++i)
      threads.emplace_back([&, i] { compiled[i] = compile(exercise, reference(exercise), jobs[i]); });
  }
  EXPECT_NE(fs::exists(jobs[0] / "source"), fs::exists(jobs[1] / "source"));
  EXPECT_NE(compiled[0].cpu_seconds > 0, compiled[1].cpu_seconds > 0);
  for (const Compiled& one : compiled) ASSERT_FALSE(one.object.empty()) << one.log;
  EXPECT_EQ(hair::bytes_of(compiled[0].object), hair::bytes_of(compiled[1].object));
}

TEST_F(CompilerTest, AnExerciseWithoutEigenHasNone) {
  const Exercise& without = *course_.find("S1");
  const Compiled compiled = compile(without, "#include <Eigen/Core>\n" + reference(without));
  EXPECT_TRUE(compiled.object.empty());
  EXPECT_TRUE(says(compiled.messages, "Eigen/Core: No such file"));
}

// A file that does not compile is itself at fault, whatever it makes the tools print.
TEST_F(CompilerTest, IsNotToldByTheFileThatTheMachineFails) {
  const Exercise& exercise = *course_.find("S1");
  for (const std::string& source :
       {std::string("#line 1 \"x\"\n#error cannot execute \x1b[2J\n"),
        std::string("#line 1 \"x\"\n#error Resource temporarily unavailable\n"),
        std::string("asm(\".globl cannot_execute\\n.error \\\"cannot execute\\\"\");\n"),
        std::string("void cannot() asm(\"cannot execute \x1b[31m\"); void f() { cannot(); }\n")}) {
    const Compiled compiled = compile(exercise, source);
    EXPECT_TRUE(compiled.object.empty()) << source;
    EXPECT_NE(compiled.messages, "") << source;
  }
}

TEST_F(CompilerTest, ProvesThatTheMachineFails) {
  const Toolchain toolchain(kit_, isolation_for_tests());
  Sandbox sandbox = toolchain.compiling({}, 5);
  EXPECT_NO_THROW(toolchain.prove_it_compiles(sandbox));
  EXPECT_NO_THROW(toolchain.prove_it_links(toolchain.linking(5)));
  sandbox.limits.memory_bytes = std::size_t{20} << 20;  // is less than the compiler itself needs
  EXPECT_THROW(toolchain.prove_it_compiles(sandbox), std::runtime_error);
  sandbox.mounts.clear();
  EXPECT_THROW(toolchain.prove_it_links(sandbox), std::runtime_error);
}

// A bomb is compiled once, with the precompiled header, up to its limit.
TEST_F(CompilerTest, EndsWhatTakesTooLong) {
  const std::string bomb =
      "#include <Eigen/Core>\ntemplate <int n, int m> struct F { static constexpr long value = F<n - 1, "
      "m>::value + F<n - 1, m + (1 << n)>::value; };\n"
      "template <int m> struct F<0, m> { static constexpr long value = m; };\nlong f() { return F<22, "
      "0>::value; }\n";
  const Compiled compiled = compiler_.compile(with_eigen_, bomb, kit_.new_job("bomb"), 2);
  EXPECT_TRUE(compiled.object.empty());
  EXPECT_NEAR(compiled.cpu_seconds, 2, 0.5);
  EXPECT_EQ(compiled.log, "a limit on time or memory was reached\n");
}

class Cache : public testing::Test {
 protected:
  // Adds a file that was used `age` seconds ago.
  void add(const std::string& name, std::size_t bytes, int age) const {
    std::ofstream(dir_ / name) << std::string(bytes, 'x');
    fs::last_write_time(dir_ / name, fs::file_time_type::clock::now() - std::chrono::seconds(age));
  }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(dir_)) all.insert(entry.path().filename().string());
    return all;
  }

  hair::TemporaryFolder temporary_{"cache"};
  const fs::path dir_ = temporary_.path();
};

TEST_F(Cache, LosesWhatWasUsedTheLongestTimeAgo) {
  add("old", 100, 300);
  add("used", 100, 400);
  add("new", 100, 1);
  fs::create_directory(dir_ / "pictures");
  mark_as_used(dir_ / "used");
  shrink_cache(dir_, 300);
  EXPECT_EQ(names(), (std::set<std::string>{"new", "old", "pictures", "used"}));
  shrink_cache(dir_, 299);
  EXPECT_EQ(names(), (std::set<std::string>{"new", "pictures", "used"}));
  shrink_cache(dir_, 0);
  EXPECT_EQ(names(), std::set<std::string>{"pictures"});
}

TEST_F(Cache, GivesBackWhatWasKept) {
  for (const KeptObject& kept : {KeptObject{"object\n\0x", "a log\n12\n"}, {"", ""}, {"7\n", ""}}) {
    std::ofstream(dir_ / "kept", std::ios::binary) << text_of(kept);
    const std::optional<KeptObject> found = read_kept(dir_ / "kept");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, kept.object);
    EXPECT_EQ(found->log, kept.log);
    EXPECT_EQ(found->cpu_seconds, kept.cpu_seconds);
  }
  for (const char* damaged :
       {"", "\n", "9 1\nlog", "x\n", "123456789012345678901 1\n", "3", "3 ", "3 1", "3\nlog"}) {
    std::ofstream(dir_ / "kept", std::ios::binary) << damaged;
    EXPECT_FALSE(read_kept(dir_ / "kept")) << damaged;
  }
  EXPECT_FALSE(read_kept(dir_ / "nobody"));
}

}  // namespace
}  // namespace grader::compile
