// STAFF ONLY. Tests that each gate lets a clean handout pass and stops a planted leak.

#include "grader/package/gates.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace grader::inline package {
namespace {

const std::string solution =
    "// the solution\n"
    "#include <vector>\n"
    "double f(double x) {\n"
    "  const double y = 2 * x;\n"
    "\n"
    "  return y * y;\n"
    "}\n";

// Returns the message that `call` throws, or nothing.
template <typename Call>
std::string complaint_of(Call call) {
  return tests::refusal<HandoutError>([&] { call(); });
}

TEST(ListingGate, OpensForWhatIsListed) {
  EXPECT_EQ(complaint_of([] { check_listing({{"a", ""}, {"b/c", ""}}, {"a", "b/c"}); }), "");
}

TEST(ListingGate, ClosesForAFileTooManyOrTooFew) {
  EXPECT_EQ(complaint_of([] {
              check_listing({{"a", ""}, {"secret", ""}}, {"a"});
            }),
            "the archive holds secret, which the manifest does not list");
  EXPECT_EQ(complaint_of([] {
              check_listing({{"a", ""}}, {"a", "b"});
            }),
            "the archive lacks b, which the manifest lists");
}

TEST(AcceptedGate, OpensForTheListAndSaysWhatIsNewOrGone) {
  EXPECT_EQ(complaint_of([] { check_accepted({"a", "b"}, {"a", "b"}); }), "");
  const std::string said = complaint_of([] { check_accepted({"a", "b"}, {"a", "c"}); });
  EXPECT_NE(said.find("\nb is new\nc is gone\n"), std::string::npos) << said;
}

TEST(CanaryGate, ClosesForAFileOfTheStaffs) {
  const Files handout = {{"README.md", "Welcome"}, {"student/f.cpp", "// STAFF ONLY. f\n"}};
  EXPECT_NE(complaint_of([&] { check_canary(handout, {}); }).find("student/f.cpp"), std::string::npos);
}

TEST(CanaryGate, ExemptsExactlyTheSolvedFiles) {
  Files handout = {{"README.md", "Welcome"}, {"student/f.cpp", "// STAFF ONLY. f\n"}};
  EXPECT_EQ(complaint_of([&] { check_canary(handout, {"student/f.cpp"}); }), "");
  handout["notes/f.cpp"] = handout["student/f.cpp"];
  EXPECT_NE(complaint_of([&] { check_canary(handout, {"student/f.cpp"}); }).find("notes/f.cpp"),
            std::string::npos);
}

TEST(ReferenceLinesGate, ClosesForFourLinesHoweverTheyAreSpaced) {
  const std::string leak =
      "An example:\n\n\tdouble f(double x) {\n\n\n    const double y = 2 * x;\r\nreturn y * y;\n}  \nand so "
      "on\n";
  const std::string said = complaint_of([&] {
    check_reference_lines({{"text.md", leak}}, {{"f.cpp", solution}}, {});
  });
  EXPECT_NE(said.find("text.md:3"), std::string::npos) << said;
  EXPECT_NE(said.find("reference/f.cpp:3"), std::string::npos) << said;
}

TEST(ReferenceLinesGate, ClosesForFourLinesInAnyDress) {
  const std::string lines[] = {"double f(double x) {", "const double y = 2 * x;", "return y * y;", "}"};
  const auto dressed = [&](const std::string& before, const std::string& after) {
    std::string text;
    for (const std::string& line : lines) text += before + line + after;
    return text;
  };
  const std::string dresses[] = {
      dressed("// ", "\n"), dressed(" * ", "\n"),     dressed("> // ", "\r\n"),  dressed("", " // so\n"),
      dressed("", " "),     dressed("\"", "\\n\"\n"), dressed("&lt;", "&gt;\n"), dressed("", "\n\n// and\n")};
  for (const std::string& leak : dresses)
    for (const std::string& secret : {solution, std::string("// f\n") + dressed("", "  // why\n")}) {
      const std::string said = complaint_of([&] {
        check_reference_lines({{"text.md", leak}}, {{"f.cpp", secret}}, {});
      });
      EXPECT_NE(said.find("text.md:1"), std::string::npos) << leak << said;
    }
}

TEST(ReferenceLinesGate, LooksPastUsingAndNamespace) {
  const std::string secret = "double f(double x) {\nusing std::abs;\nreturn 2 * abs(x) +\nx / 17.25;\n}\n";
  for (const std::string leak :
       {"// double f(double x) {\n// using std::abs;\n// return 2 * abs(x) +\n// x / 17.25;\n// }\n",
        "namespace hair { double f(double x) { return 2 * abs(x) + x / 17.25; } }"})
    EXPECT_NE(complaint_of([&] {
                check_reference_lines({{"text.md", leak}}, {{"f.cpp", secret}}, {});
              }),
              "")
        << leak;
}

// A secret needs three lines with letters, 30 in all.
TEST(ReferenceLinesGate, OpensForWhatAnybodyMayWrite) {
  const auto says = [](const std::string& text) {
    return complaint_of([&] { check_reference_lines({{"text.md", text}}, {{"f.cpp", text}}, {}); });
  };
  EXPECT_EQ(says("one_of_ten\nten_of_ten\n}\nnineteen9\n"), "");
  EXPECT_NE(says("one_of_ten\nten_of_ten\n}\nnineteen10\n"), "");
  EXPECT_EQ(says("(one_of_ten\n{\n}\nlong_enough_to_be_a_secret_of_its_own)\n"), "");
  EXPECT_EQ(says("a;\nb;\nc;\n}\nlast_of_twenty_six_letters\n"), "") << "29 letters";
  EXPECT_NE(says("a;\nb;\nc;\n}\nlast_of_twenty_seven_letter\n"), "") << "five lines";
}

TEST(ReferenceLinesGate, OpensForThreeLines) {
  const std::string three = "  const double y = 2 * x;\n  return y * y;\n}\n";
  EXPECT_EQ(complaint_of([&] {
              check_reference_lines({{"text.md", three}}, {{"f.cpp", solution}}, {});
            }),
            "");
}

TEST(ReferenceLinesGate, OverlooksWhatIsIncluded) {
  const std::string includes =
      "#include <cmath>\n#include <limits>\n\n  #include <string>\n#include <vector>\n";
  const Files reference = {{"f.cpp", includes + solution}};
  EXPECT_EQ(complaint_of([&] { check_reference_lines({{"g.cpp", includes}}, reference, {}); }), "");
  EXPECT_NE(complaint_of([&] {
              check_reference_lines({{"g.cpp", includes + solution}}, reference, {});
            }),
            "");
}

TEST(ReferenceLinesGate, ClosesForAStubThatSaysWhatItShouldNot) {
  const std::string stub = "double f(double) {\n  throw NotImplemented(\"f\");\n}\n/*\n" + solution + "*/\n";
  EXPECT_NE(complaint_of([&] {
              check_reference_lines({{"student/f.cpp", stub}}, {{"f.cpp", solution}}, {});
            }),
            "");
}

TEST(ReferenceLinesGate, ExemptsExactlyTheSolvedFiles) {
  const Files reference = {{"f.cpp", solution}};
  EXPECT_EQ(complaint_of([&] {
              check_reference_lines({{"student/f.cpp", solution}}, reference, {"student/f.cpp"});
            }),
            "");
  EXPECT_NE(complaint_of([&] {
              check_reference_lines({{"student/g.cpp", solution}}, reference, {"student/f.cpp"});
            }),
            "");
}

// The canary guards only files that carry it.
TEST(Canary, StandsInEveryFileOfTheStaffs) {
  namespace fs = std::filesystem;
  // JSON and pictures have no comments.
  const std::set<fs::path> without_comments = {".json", ".png"};
  for (const std::string folder : {"reference", "grader"})
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(HAIR_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file() || without_comments.contains(entry.path().extension())) continue;
      EXPECT_TRUE(carries_canary(hair::bytes_of(entry.path())))
          << entry.path() << " must say STAFF ONLY in one of its first three lines";
    }
}

}  // namespace
}  // namespace grader::package
