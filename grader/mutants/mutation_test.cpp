// STAFF ONLY. Tests which mutants are made of small sources.
#include "grader/mutants/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace grader::inline mutants {
namespace {

std::set<std::string> results(const std::string& source) {
  std::set<std::string> all;
  for (const Mutation& mutation : mutations_of(source)) all.insert(mutated(source, mutation));
  return all;
}

TEST(Mutations, ChangeOperatorsComparisonsConstantsIndicesSignsNamesAndFunctions) {
  const auto all = results("double f() { x = -a[i] * 2; }");
  for (const char* expected :
       {"double f() { x = a[i] * 2; }", "double f() { x = -a[i] / 2; }", "double f() { x = -a[i] * 3; }",
        "double f() { x = -a[i + 1] * 2; }", "double f() { ; }"})
    EXPECT_TRUE(all.contains(expected)) << expected;
  EXPECT_TRUE(results("if (a < b) c();").contains("if (a <= b) c();"));
  EXPECT_TRUE(results("if (a < b) c();").contains("if ((!(a < b))) c();") ||
              results("if (a < b) c();").contains("if (!(a < b)) c();"));
  EXPECT_TRUE(results("y = a * x;").contains("y = a * v;"));
  EXPECT_TRUE(results("x += std::abs(y);").contains("x += (y);"));
  EXPECT_TRUE(results("x += 1e-12;").contains("x += (1e6 * 1e-12);"));
  EXPECT_TRUE(results("x += 0.5;").contains("x -= 0.5;"));
  EXPECT_TRUE(results("x = std::max(y, 0.0);").contains("x = std::max(y, 1.0);"));
}

TEST(Mutations, LeaveCommentsQuotesAndDeclarationsAlone) {
  EXPECT_TRUE(
      mutations_of("// a + b\n/* 1 < 2 */\n#include <a+b>\nusing A = B<3>;\nreturn \"1 + 1\";").empty());
}

TEST(Mutations, LeaveTypesAndDeclarationsAlone) {
  for (const char* source :
       {"void f(Matrix* A, const Vector& e, double x[]) {}", "const Vector &p = q, &c = d;",
        "std::array<double, 3> c;", "std::vector<std::array<int, 2>> v;", "const auto [p, q] = c;",
        "constexpr double kTable[8] = {};", "a.segment<3>().row<2, 3>();",
        "{ Arm(const Vector& v) : a(w) {} int b; }"})
    for (const Mutation& mutation : mutations_of(source))
      EXPECT_EQ(mutation.kind, "statement") << source << ": " << mutated(source, mutation);
  EXPECT_TRUE(mutations_of("struct A { A(const A&) = delete; }").empty());
  EXPECT_TRUE(results("x = v.head<3>() + a<b>(c, d);").contains("x = v.head<3>() - a<b>(c, d);"));
  EXPECT_TRUE(results("x = a<b>(c, d);").contains("x = a<b>(d, c);"));
  EXPECT_TRUE(results("x = 0x1p-51 * y;").contains("x = (2 * 0x1p-51) * y;"));
}

TEST(Mutations, AreDrawnByTheSeedAndFromEachKind) {
  std::string source = "int f() { ";
  for (int i = 0; i < 50; ++i) source += "a += b[" + std::to_string(i) + "] * c; if (d < 3) e = -g; ";
  source += "}";
  const std::vector<Mutation> all = mutations_of(source);
  std::set<std::string> kinds, some_kinds;
  for (const Mutation& mutation : all) kinds.insert(mutation.kind);
  const auto some = drawn(all, 7), again = drawn(all, 7), other = drawn(all, 8);
  EXPECT_EQ(some.size(), all.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) some_kinds.insert(some[i].kind);
  EXPECT_EQ(some_kinds, kinds);
  const auto places = [](const std::vector<Mutation>& of) {
    std::vector<std::size_t> at;
    for (const Mutation& mutation : of) at.push_back(mutation.at);
    return at;
  };
  EXPECT_EQ(places(some), places(again));
  EXPECT_NE(places(some), places(other));
}

TEST(Mutations, SayWhereAndWhat) {
  const std::string source = "int f() {\n  return c + d;\n}\n";
  const std::vector<Mutation> all = mutations_of(source);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(line_of(source, all[0]), "return c + d;");
  EXPECT_EQ(line_number(source, all[0]), 2);
  EXPECT_EQ(change_of(source, all[0]), "`+` to `-`");
}

TEST(Mutations, OfOneLineThatChangeTheSameAreTold) {
  const std::string source = "int f() {\n  g(0);\n  return a > 0 ? b + 0 : 0;\n}\n";
  std::vector<int> zeros;
  for (const Mutation& mutation : mutations_of(source))
    if (line_number(source, mutation) == 3 && change_of(source, mutation) == "`0` to `1`")
      zeros.push_back(occurrence_of(source, mutation));
  EXPECT_EQ(zeros, (std::vector<int>{1, 2, 3}));
}

}  // namespace
}  // namespace grader::mutants
