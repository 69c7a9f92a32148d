// STAFF ONLY. Tests the answers of about.txt and their section on the class's page.
#include "grader/report/facts/about.h"

#include <gtest/gtest.h>

#include "grader/report/pages/pages.h"
#include "hair/io/files/read_file.h"

namespace grader::inline report {
namespace {

TEST(About, AnswersEndAtTheNextQuestion) {
  const About about = read_about(
      "Three questions: hours and more.\nHOURS of work, about: 12\nHardest exercise, and why: H6,\n  the "
      "filter: "
      "two solves\nUnclear in texts, headers or checks:\n\nHandout: 3f2a91c0\n");
  EXPECT_EQ(about, (About{"12", "H6, the filter: two solves", "", "3f2a91c0"}));
  EXPECT_EQ(read_about(""), About());
  EXPECT_EQ(read_about("Unclear:\nHandout page 3: what is epsilon?\nHours later I saw: a sign."),
            (About{"", "", "Handout page 3: what is epsilon? Hours later I saw: a sign.", ""}));
  EXPECT_EQ(read_about("It was fun: really."), About());
  EXPECT_EQ(read_about("Hours:\xff\x1b[31m3\n").hours,
            "\xef\xbf\xbd"
            "3");
}

// Reads the students' file: its questions are found, and its answers are empty.
TEST(About, ReadsTheHandoutsQuestions) {
  std::string text = hair::bytes_of(HAIR_ABOUT_FILE);
  EXPECT_EQ(read_about(text), About());
  for (const char* word : {"Unclear", "Hardest", "Hours"}) {
    const std::size_t colon = text.find(':', text.find(word));
    ASSERT_NE(colon, std::string::npos);
    text.insert(colon + 1, std::string(" answer to ") + word);
  }
  EXPECT_EQ(read_about(text), (About{"answer to Hours", "answer to Hardest", "answer to Unclear", ""}));
}

TEST(About, HoursAreTheFirstNumber) {
  const auto hours = [](const char* text) { return hours_of({text, "", "", ""}); };
  EXPECT_EQ(hours("about 12,5 h"), 12.5);
  EXPECT_EQ(hours("10-12"), 10);
  EXPECT_EQ(hours("many"), std::nullopt);
  EXPECT_EQ(hours("1e9"), 1) << "no exponents";
  EXPECT_EQ(hours("4000000"), std::nullopt);
}

SubmissionResult says(const std::string& about) {
  return {.name = "somebody", .exercises = {{.id = "H1"}, {.id = "H6"}, {.id = "H10"}}, .about = about};
}

TEST(AboutSection, CountsAndNamesNobody) {
  EXPECT_EQ(about_section({says(""), says("Handout: aaaaaaaa\n")}).text, "");
  const std::string section =
      about_section({says("Hours: 4\nHardest: H6 and H1\nUnclear: zeta <b>\nHandout: aaaaaaaa"),
                     says("Hours: 20\nHardest: H6\nHandout: bbbbbbbb"),
                     says("Hours: 9\nHardest: H10\nUnclear: alpha"), says("")})
          .text;
  for (const char* part :
       {"3 of 4 answered", "median 9, from 4 to 20", "Named as the hardest: H6 2, H1 1, H10 1.",
        "Made with several handouts: aaaaaaaa (1), bbbbbbbb (1).", "zeta &lt;b&gt;"})
    EXPECT_NE(section.find(part), std::string::npos) << part << "\n" << section;
  EXPECT_LT(section.find("alpha"), section.find("zeta")) << "in another order than people";
  EXPECT_EQ(section.find("somebody"), std::string::npos);
}

}  // namespace
}  // namespace grader::report
