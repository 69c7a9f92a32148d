#include "check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <locale>
#include <set>
#include <sstream>
#include <stdexcept>

#include "apart.h"
#include "hint.h"
#include "solver/matrix_market.h"

// The sanitizers call this for their options. As in grading, memory that is never freed is no error, and all
// memory that is never set holds 0xfe.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0:detect_container_overflow=0:print_legend=0:"
         "malloc_fill_byte=254:max_malloc_fill_size=2147483647";
}

namespace checks {

Vector product(solver::SparseMatrix& A, Vector x) {
  Vector b(A.rows());
  A.matVecMult(x.data(), b.data());
  return b;
}

Vector difference(const Vector& x, const Vector& y) {
  Vector result(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) result[i] = x[i] - y[i];
  return result;
}

double norm(const Vector& x) {
  double squared = 0;
  for (double value : x) squared += value * value;
  return std::sqrt(squared);
}

Vector scattered(int n) {
  Vector values(n);
  std::uint32_t state = 1;
  for (double& value : values) {
    state = 1664525 * state + 1013904223;
    value = state / 2147483648.0 - 1;
  }
  return values;
}

std::string in_words(const Vector& x) {
  const std::size_t shown = x.size() <= 8 ? x.size() : 6;
  std::ostringstream text;
  text.precision(10);
  for (std::size_t i = 0; i < shown; ++i) text << (i == 0 ? "(" : ", ") << x[i];
  if (shown == 0) text << "(";
  if (shown < x.size()) text << ", ... " << x.size() - shown << " more";
  text << ")";
  return text.str();
}

double residual_gap(double norm_of_A, double e, const Vector& solution, const Vector& b) {
  const double n = static_cast<double>(solution.size());
  return (64 * (10 + 2 * e) + n) * std::ldexp(1.0, -53) * norm_of_A * (2 * norm(solution) + norm(b));
}

namespace {

const testing::TestInfo& current() {
  return *testing::UnitTest::GetInstance()->current_test_info();
}

}  // namespace

void note_hint(const std::string& hint) {
  const testing::TestResult& so_far = *current().result();
  if (so_far.Failed()) return;  // the first failure is shown, and this hint is another one's
  for (int i = 0; i < so_far.test_property_count(); ++i)
    if (so_far.GetTestProperty(i).key() == std::string("hint")) return;
  if (!hint.empty()) testing::Test::RecordProperty("hint", hint);
}

void note_hint(std::span<const double> actual, std::span<const double> expected, double bound, int block,
               std::span<const double> before) {
  note_hint(hint(actual, expected, bound, block, before));
}

testing::AssertionResult is_near(const char* words, const char* expected_words, const char* bound_words,
                                 double actual, double expected, double bound) {
  const double error = std::abs(actual - expected);
  if (error <= bound) return testing::AssertionSuccess();
  note_hint(hint_of_one(actual, expected, current().test_suite_name() == std::string("Energy")));
  return testing::AssertionFailure() << words << "\nexpected = " << expected << " = " << expected_words
                                     << "\nactual   = " << actual << "\nerror    = " << error
                                     << ", bound = " << bound << " = " << bound_words;
}

testing::AssertionResult counts(const char* words, const char* expected_words, long actual, long expected) {
  if (actual == expected) return testing::AssertionSuccess();
  note_hint(actual == expected + 1 ? "one too many" : actual == expected - 1 ? "one too few" : "");
  return testing::AssertionFailure() << words << "\nexpected = " << expected << " = " << expected_words
                                     << "\nactual   = " << actual;
}

void expect_near(const Vector& x, const Vector& solution, double bound, const std::string& source_of_bound) {
  ASSERT_EQ(x.size(), solution.size());
  const double error = norm(difference(x, solution));
  if (error <= bound) return;
  note_hint(x, solution, bound);
  ADD_FAILURE() << "expected x = " << in_words(solution) << "\n"
                << "actual   x = " << in_words(x) << "\n"
                << "error      = " << error << ", the length of their difference\n"
                << "bound      = " << bound << " = " << source_of_bound;
}

std::vector<Golden> read_golden(const std::string& exercise) {
  const std::string folder = HAIR_GOLDEN_DIR;
  const std::string list = folder + "/" + exercise + ".txt";
  std::ifstream lines(list);
  if (!lines)
    throw std::runtime_error(list + " is missing; restore the folder check/golden from the handout");
  std::vector<Golden> cases;
  std::string line;
  while (std::getline(lines, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    words.imbue(std::locale::classic());  // whatever your file sets
    std::string name;
    double epsilon, smallest;
    int steps;
    if (!(words >> name >> epsilon >> steps >> smallest))
      throw std::runtime_error(list + ": can't read \"" + line + "\"; restore it from the handout");
    const std::string path = folder + "/" + name;
    cases.push_back({{"golden/" + name + ".mtx", solver::read_matrix_market(path + ".mtx"),
                      solver::read_vector(path + ".b.mtx"), solver::read_vector(path + ".x.mtx"), smallest},
                     epsilon,
                     steps});
  }
  return cases;
}

namespace {

using Functions = std::vector<Function>;

// Says which functions are not written yet, and returns their names.
std::set<std::string> unwritten(const Functions& functions) {
  std::set<std::string> said, missing;
  for (const Function& function : functions) {
    const std::string sentence = not_implemented_by(function.call);
    if (sentence.empty()) continue;
    if (said.insert(sentence).second) std::printf("%s\n", sentence.c_str());
    if (sentence.find(function.name) == std::string::npos)
      std::printf("  and %s calls it: its checks wait\n", function.name.c_str());
    missing.insert(function.name);
  }
  std::fflush(stdout);
  return missing;
}

// The first function of a suite's category that is among `names`; "" if none is.
std::string asked_of(const std::vector<Category>& categories, const std::string& suite,
                     const std::set<std::string>& names) {
  const Category* category = category_of(categories, suite);
  if (category == nullptr) throw std::logic_error(suite + " is the id of no category in categories.json");
  const auto of =
      std::ranges::find_if(category->functions, [&](const std::string& one) { return names.contains(one); });
  return of == category->functions.end() ? "" : *of;
}

// All checks, in the order of the file. Those of missing functions wait for them.
std::vector<Finding> all_checks(const std::vector<Category>& categories,
                                const std::set<std::string>& missing) {
  std::vector<Finding> findings;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    const std::string needed = asked_of(categories, suite.name(), missing);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      const std::string path = test.file();
      findings.push_back({suite.name(),
                          test.name(),
                          path.substr(path.rfind('/') + 1),
                          test.line(),
                          Finding::State::waits,
                          {},
                          "",
                          needed});
    }
  }
  std::ranges::stable_sort(findings, {}, &Finding::line);
  return findings;
}

// The function that this suite's checks wait for: one that they call, or one that this in turn waits for; or
// "". Only the checks of the function's first category count, so a special case that fails stops nobody.
std::string waits_for(const std::string& suite, const std::vector<Category>& categories,
                      const Functions& functions, const std::vector<Finding>& findings) {
  for (const Function& function : functions) {
    if (asked_of(categories, suite, {function.name}).empty()) continue;
    for (const std::string& needed : function.needs) {
      const auto ordinary = std::ranges::find_if(categories, [&](const Category& one) {
        return std::ranges::find(one.functions, needed) != one.functions.end();
      });
      if (ordinary == categories.end()) continue;
      for (const Finding& one : findings)
        if (one.state != Finding::State::passed && one.suite != suite &&
            category_of(categories, one.suite) == &*ordinary)
          return one.waits_for.empty() ? needed : one.waits_for;
    }
  }
  return "";
}

void run_all(std::vector<Finding>& findings, const std::vector<Category>& categories,
             const Functions& functions) {
  std::set<std::string> begun;
  // A category runs after those that it may wait for: in the order of categories.json.
  for (const Category& category : categories) {
    for (const Finding& first : findings) {
      if (category_of(categories, first.suite) != &category || !begun.insert(first.suite).second ||
          !first.waits_for.empty())
        continue;
      std::vector<Finding*> checks;
      for (Finding& one : findings)
        if (one.suite == first.suite) checks.push_back(&one);
      const std::string needed = waits_for(first.suite, categories, functions, findings);
      if (needed.empty()) {
        run_apart(checks);
      } else {
        for (Finding* one : checks) one->waits_for = needed;
      }
    }
  }
}

bool has_an_option_of_googletests(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc,
                     [](const char* one) { return std::strncmp(one, "--gtest", 7) == 0; });
}

int run_plainly(int argc, char** argv, const std::vector<Category>& categories, const Functions& functions) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  const std::set<std::string> missing = unwritten(functions);
  std::string& filter = testing::GTEST_FLAG(filter);
  for (const Finding& one : all_checks(categories, missing))
    if (!one.waits_for.empty())
      filter += (filter.find('-') == std::string::npos ? "-" : ":") + one.full_name();
  if (missing.size() == functions.size()) return 1;
  const int failed = RUN_ALL_TESTS();
  return missing.empty() ? failed : 1;
}

}  // namespace

int run_checks(int argc, char** argv, const std::string& exercise, const std::vector<Category>& categories,
               const Functions& functions) {
  if (has_an_option_of_googletests(argc, argv)) return run_plainly(argc, argv, categories, functions);
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--full" || option == "--tell") continue;
    std::printf(
        "%s is no option of the checks: there are --full, --tell and those of GoogleTest, --gtest_...\n",
        argv[i]);
    return option == "--help" ? 0 : 2;
  }
  const auto given = [&](const std::string& option) {
    return std::find(argv + 1, argv + argc, option) != argv + argc;
  };
  testing::InitGoogleTest();
  const std::set<std::string> missing = unwritten(functions);
  const bool tell = given("--tell");
  if (missing.size() == functions.size()) return tell ? 0 : 1;
  std::vector<Finding> findings = all_checks(categories, missing);
  run_all(findings, categories, functions);
  std::printf("%s", digest({exercise, argv[0], categories}, findings, given("--full")).c_str());
  const auto wrong =
      std::ranges::count_if(findings, [](const Finding& one) { return one.state != Finding::State::passed; });
  if (const char* file = std::getenv("HAIR_RESULT"))
    std::ofstream(file) << "{\"tests\": " << findings.size() << ", \"failures\": " << wrong << "}\n";
  if (const char* show = std::getenv("HAIR_SHOW")) std::printf("To see what it does: %s\n", show);
  return tell || wrong == 0 ? 0 : 1;
}

}  // namespace checks
