// STAFF ONLY. Tests that each file that hides a part of itself from the search for memory errors gets a
// sentence with the line.
#include "grader/compile/switched_off.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grader/compile/compiler.h"
#include "grader/sandbox/isolation_for_tests.h"

namespace grader::inline compile {
namespace {

class SwitchedOffTest : public testing::Test {
 protected:
  // Returns the compiler's sentence about an S1 with these lines, which begin in line 3. Empty: it is
  // searched.
  std::string sentence_for(const std::string& lines) {
    const std::string source =
        "#include \"solver/linearSolver.h\"\n#include <vector>\n" + lines +
        "\ndouble ConjGrad(int, implicitMatrix*, double*, double*, double, int*) { return 0; }\n";
    const Compiled compiled =
        compiler_.compile(*course_.find("S1"), source, kit_.new_job("switch-" + std::to_string(++jobs_)), 200,
                          Build::sanitised);
    EXPECT_EQ(compiled.object.empty(), !compiled.switched_off.empty()) << compiled.log;
    return compiled.switched_off;
  }
  void expect_told(const std::string& lines, int line, const std::string& word) {
    EXPECT_EQ(sentence_for(lines),
              "Line " + std::to_string(line + 2) +
                  " of conj_grad.cpp keeps parts of the code from the look for memory errors, by \"" + word +
                  "\", so there is no point for it.")
        << lines;
  }

  const Course course_ = read_course(std::filesystem::path(HAIR_PROJECT) / "handout/exercises.json");
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  const Compiler compiler_{kit_, HAIR_TEST_CACHE, isolation_for_tests()};
  int jobs_ = 0;
};

TEST_F(SwitchedOffTest, EachSpellingIsTold) {
  expect_told("__attribute__((no_sanitize_address)) void f();", 1, "no_sanitize_address");
  expect_told("\n__attribute__((__no_sanitize__(\"address\"))) void f();", 2, "__no_sanitize__");
  expect_told("[ [gnu::no_sanitize_address] ] void f();", 1, "no_sanitize_address");
  expect_told("[[clang::no_sanitize(\"address\")]] void f();", 1, "no_sanitize");
  expect_told("[[gnu::__no_address_safety_analysis__]] void f();", 1, "__no_address_safety_analysis__");
  expect_told("_Pragma(\"clang attribute push(__attribute__((no_sanitize(1))), apply_to = function)\")", 1,
              "no_sanitize");
}

TEST_F(SwitchedOffTest, PiecesAreTold) {
  expect_told("#define PASTE(a, b) a##b\n[[gnu::PASTE(no_sani, tize_address)]] void f();", 2,
              "no_sanitize_address");
  expect_told("[[gnu::__CONCAT(no_sani, tize_address)]] void f();", 1, "no_sanitize_address");
  expect_told("[[gnu::no_sani\\\ntize_address]] void f();", 1, "no_sanitize_address");
  expect_told("#define PASTE(a, b) a##b\nPASTE(a, sm)(\".macro call x\\n.endm\");", 2, "asm");
}

TEST_F(SwitchedOffTest, AssemblerIsTold) {
  expect_told("asm(\".rept 2\\n.if 0\\n.endif\\n.endr\\n\");", 1, "asm");
  expect_told("inline void f() { __asm__ volatile(\"nop\"); }", 1, "__asm__");
  expect_told("extern int name asm(\"other\");", 1, "asm");
}

TEST_F(SwitchedOffTest, TextsThatReachTheAssemblerAreTold) {
  expect_told("__attribute__((section(\".data.a\\nnop\\n#\"), used)) static int note = 1;", 1, "section");
  expect_told("[[using gnu: __section__((R\"(.data.a;nop #)\")), used]] static int note = 1;", 1,
              "__section__");
  expect_told(
      "#define NAME \".data.a;nop #\"\n<:<:gnu::section(\n\n#if 1\n(NAME)\n#endif\n):>:> int note = 1;", 2,
      "section");
  expect_told("#define PASTE(a, b) a##b\n[[gnu::PASTE(sec, tion)(\"a\")]] int note = 1;", 2, "section");
  expect_told("static int f() __attribute__((weakref(\"x\\nnop\"))); int g() { return f(); }", 1, "weakref");
  expect_told("static int f() __attribute__((weakref, alias(\"x;nop\"))); int g() { return f(); }", 1,
              "weakref");
  expect_told("extern \"C\" int x() { return 1; }\nextern \"C\" int g() __attribute__((ifunc(\"x\")));", 2,
              "ifunc");
  expect_told("extern \"C\" __attribute__((symver(\"g@V1;nop#\"))) int g() { return 1; }", 1, "symver");
  expect_told("__attribute__((deprecated(\")))\"), section((0, \".data.a;nop#\")))) int note = 1;", 1,
              "section");
  expect_told("[[gnu::deprecated(R\"x(]])x\"), gnu::section(*&\"a\")]] int note = 1'0;", 1, "section");
  expect_told("[[x::y(1'\"'), gnu::section(\"a\")]] int note = 1;", 1, "section");
  expect_told("[[x::y(xR\"(\"), gnu::section(\"a)\")]] int note = 1;", 1, "section");
  expect_told("int thousand = 1'000;\n[[gnu::section(__extension__ \"a\")]] int note = 1;", 2, "section");
  expect_told("#ident \"x\\\"\\nnop\\n#\"", 1, "ident");
  expect_told("#  sccs \"x\\\"\\nnop\\n#\"", 1, "ident");
}

TEST_F(SwitchedOffTest, LinesUnderOtherNamesAreTold) {
  expect_told("# 5 \"/usr/include/stdio.h\" 3\nasm(\"\");", 1, "#line");
  expect_told("const char* text = R\"(\n# 5 \"/usr/include/stdio.h\" 3\n)\"; asm(\"nop\");", 2, "#line");
}

TEST_F(SwitchedOffTest, HonestFilesAreLookedInto) {
  EXPECT_EQ(sentence_for("[[maybe_unused]] static int one = 1;  // step #1"), "");
  EXPECT_EQ(sentence_for("inline void f() { asm volatile(\"\" ::: \"memory\"); }"), "");
  EXPECT_EQ(sentence_for("inline double section(double r) { return r; }  // \"alias\"\n"
                         "inline double ident = section(\n    1);"),
            "");
  EXPECT_EQ(sentence_for("#include <string>\nstruct Timer { explicit Timer(std::string) {} };\n"
                         "[[maybe_unused]] inline Timer section(\"start\"), ident(\"mine\");"),
            "");
  EXPECT_EQ(sentence_for("#include <map>\n#define PASTE(a, b) a##b\ninline int PASTE(x, y) = __LINE__;"), "");
}

TEST(SwitchedOff, MostFilesNeedNoPreprocessor) {
  EXPECT_FALSE(may_switch_off("#include <vector>\n[[nodiscard]] double f(); // 1. plasma, # 2\n"));
  for (const char* may :
       {"a##b", "a %:%: b", "__CONCAT(a, b)", "EIGEN_CAT(a, b)", "no_sanitize", "a\\\nsm(\"\")"})
    EXPECT_TRUE(may_switch_off(may)) << may;
}

}  // namespace
}  // namespace grader::compile
