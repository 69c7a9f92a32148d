// STAFF ONLY. Tests that feedback reaches its student, as a file that opens.
#include "grader/gradebook/feedback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "grader/course/input.h"
#include "grader/intake/archives/archive.h"

namespace grader::inline gradebook {
namespace {

using std::string;
using Files = std::map<string, string>;

// formats.md:22: the base name is split at _, LATE is removed; the first two fields of digits are user and
// attachment, or those behind "anon". Names that begin with ._ and last fields that begin with link are
// skipped.
string canvas_gives(const string& path) {
  static const std::regex split("_");
  const string name = path.substr(path.rfind('/') + 1);
  if (name.starts_with("._")) return "";
  std::vector<string> fields(std::sregex_token_iterator(name.begin(), name.end(), split, -1), {});
  std::erase(fields, "LATE");
  if (fields.back().starts_with("link")) return "";
  if (const auto anon = std::ranges::find(fields, "anon"); anon != fields.end())
    return *(anon + 1) + " " + *(anon + 2);
  std::vector<string> numbers;
  for (const string& field : fields)
    if (!field.empty() && field.find_first_not_of("0123456789") == string::npos) numbers.push_back(field);
  return numbers.size() < 2 ? "" : numbers[0] + " " + numbers[1];
}

// formats.md:55: the first path part with four fields counts; the second field is a participant's number, the
// third and fourth name a plugin.
string moodle_gives(const string& path) {
  static const std::regex form("^([^_/]*)_([0-9]+)_assign(submission|feedback)_file[^/]*/([^.~].*)$");
  std::smatch match;
  return std::regex_match(path, match, form) ? match[2].str() + " " + match[4].str() : "";
}

Grade grade_of(const Owner& owner) {
  return {.hand_in = "h" + owner.id, .owner = owner, .system = "canvas"};
}

ReportOfStudent report_of(const string& hand_in) {
  return {"<p>" + hand_in + "</p>", hand_in + " as text"};
}

bool said(const Feedback& feedback, const string& words) {
  return std::ranges::any_of(feedback.said,
                             [&](const string& line) { return line.find(words) != string::npos; });
}

Files received(const Feedback& feedback, string (*gives)(const string&)) {
  Files files;
  for (const ArchiveEntry& entry : feedback.entries) files[gives(entry.path)] = entry.bytes;
  return files;
}

TEST(CanvasFeedback, OpensUnderTheNameOfAnAttachment) {
  const std::vector<string> files{"müllerjörg_4711_90001_main.cpp",
                                  "müllerjörg_4711_90002_notes.html",
                                  "obrienseán_LATE_4712_90017_main-1.cpp",
                                  "lab3_12_4713_90020_a.cpp",
                                  "team7_4714_90030_x.pdf",
                                  "LATE_anon_aB3dE_90021_my_main.cpp",
                                  "doejane_4715_text.html",
                                  "roe_4716_90040_linker.cpp",
                                  "._x_4717_90050_a.cpp",
                                  "z_4718_90060_z.ZIP",
                                  "no number__90070_a.html",
                                  "a student's own words_aB3dE_90080_a.html"};
  std::vector<Grade> grades{grade_of({.id = "aB3dE", .anonymous = true}), grade_of({.name = "A"})};
  for (const char* id : {"4711", "4712", "4713", "4714", "4715", "4716", "4717", "4718"})
    grades.push_back(grade_of({.id = id}));
  const Feedback feedback = feedback_for_canvas(files, grades, report_of);
  Files got = received(feedback, canvas_gives);
  const string archive = got["4718 90060"];
  got.erase("4718 90060");
  EXPECT_EQ(got, (Files{{"4711 90002", "<p>h4711</p>"},
                        {"4712 90017", "h4712 as text"},
                        {"4713 90020", "h4713 as text"},
                        {"aB3dE 90021", "haB3dE as text"}}));
  const auto zip = open_here(archive, "z.zip", {.unpacked_bytes = 10000, .entries = 10});
  const auto entries = zip->list();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].path, "report.html");
  EXPECT_TRUE(said(feedback, "h4714: gets no feedback: nothing that we can write opens as x.pdf"));
  for (const char* id : {"h4715", "h4716", "h4717", "h"})
    EXPECT_TRUE(said(feedback, string(id) + ": gets no feedback: no file in the download")) << id;
  EXPECT_TRUE(said(feedback, "3 get the report as plain text"));
  EXPECT_TRUE(said(feedback, "1 get an archive with report.html"));
}

TEST(CanvasFeedback, AnAttachmentIsOnePersons) {
  Grade again = grade_of({"", "4711", ""});
  again.hand_in = "again";
  const Feedback feedback =
      feedback_for_canvas({"x_4711_90001_main.cpp"}, {grade_of({"", "4711", ""}), again}, report_of);
  ASSERT_EQ(feedback.entries.size(), 1u);
  EXPECT_EQ(feedback.entries[0].bytes, "h4711 as text");
  EXPECT_TRUE(said(feedback, "again: gets no feedback: its attachment is h4711's, too"));
}

TEST(MoodleFeedback, NeverReachesAnotherStudent) {
  const Csv worksheet = parse_csv(
      "Identifier,Full name,Grade\nParticipant 4711,Jörg Müller,\nParticipant 55,Ann Oh,\nParticipant "
      "56,Bo Ek,\nParticipant 4713,Seán O'Brien,\n",
      "w.csv");
  const Owner team{
      .name = "T", .id = "70", .email = "", .group = true, .members = {{"Seán OBrien", "4713", ""}}};
  const Feedback feedback =
      feedback_for_moodle(worksheet,
                          {{.hand_in = "j_m", .owner = {"Jörg Müller", "4711", ""}, .system = "moodle"},
                           {.hand_in = "team7", .owner = {"Team 7", "55", ""}, .system = "moodle"},
                           {.hand_in = "t", .owner = team, .system = "moodle"},
                           {.hand_in = "n", .owner = {"Bo Ek", "", ""}, .system = "folders"}},
                          report_of);
  EXPECT_EQ(received(feedback, moodle_gives),
            (Files{{"4711 report.html", "<p>j_m</p>"}, {"4713 report.html", "<p>t</p>"}}));
  EXPECT_TRUE(
      said(feedback, "team7: gets no feedback: its id is Ann Oh's on the roster, and its name is Team 7"));
  EXPECT_TRUE(said(feedback, "n: gets no feedback: found by its name alone"));
}

TEST(MoodleFeedback, ABlindWorksheetStillTellsTeams) {
  const Csv worksheet = parse_csv("Identifier,Grade\nParticipant 4711,\nParticipant 55,\n", "w.csv");
  const Feedback feedback =
      feedback_for_moodle(worksheet,
                          {{.hand_in = "a", .owner = {"Participant", "4711", ""}, .system = "moodle"},
                           {.hand_in = "b", .owner = {"Team 7", "55", ""}, .system = "moodle"}},
                          report_of);
  EXPECT_EQ(received(feedback, moodle_gives), (Files{{"4711 report.html", "<p>a</p>"}}));
  EXPECT_TRUE(said(feedback, "b: gets no feedback: number 55 is a participant's in the worksheet"));
  EXPECT_THROW(feedback_for_moodle(parse_csv("id,name\n1,A\n", "w.csv"), {}, report_of), BadInput);
}

TEST(MoodleFeedback, TwoHandInsOfOnePersonAreLeftToStaff) {
  const Csv worksheet = parse_csv("Identifier,Grade\nParticipant 4711,\n", "w.csv");
  const Grade one{.hand_in = "a", .owner = {"", "4711", ""}, .system = "moodle"};
  const Feedback feedback = feedback_for_moodle(worksheet, {one, one}, report_of);
  EXPECT_TRUE(feedback.entries.empty());
  EXPECT_TRUE(said(feedback, "participant 4711: gets no feedback: both a and a are theirs"));
}

}  // namespace
}  // namespace grader::gradebook
