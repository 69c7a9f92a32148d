// STAFF ONLY. Tests that Moodle's importer takes the filled cells.
#include "grader/gradebook/filling.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/gradebook/importers.h"
#include "solver/test_refusal.h"

namespace grader::inline gradebook {
namespace {

using std::string;
using tests::says;
using Scores = std::map<string, string>;

const string kTitles =
    "Identifier,Full name,Status,Grade,Maximum grade,Grade can be changed,Last modified (submission),Last "
    "modified (grade),Feedback comments\n";
const string kWorksheet =
    kTitles +
    "Participant 4711,Jörg Müller-Lüdenscheidt,Submitted for grading,7.50,10.00,Yes,\"Tuesday, 4 March 2025, "
    "10:15 AM\",-,<p>3 tests failed</p>\n"
    "Participant 4712,Seán O'Brien,Submitted for grading,,10.00,Yes,-,-,\n"
    "Participant 4713,=1+1,Submitted for grading,,10.00,No,-,-,\n"
    "Participant 4714,Ann Oh,No submission,,10.00,Yes,-,-,\n";
const Scores kParticipants{{"4711", "7.50"}, {"4712", ""}, {"4713", ""}, {"4714", ""}};

Grade moodle_grade(const string& id, double points, double of = 10) {
  return {.hand_in = "hand_in_" + id,
          .owner = {"", id, ""},
          .system = "moodle",
          .points = points,
          .max_points = of,
          .entered = {"7.5"}};
}

Gradebook fill_sheet(const string& text, const std::vector<Grade>& grades, const FillOptions& options = {}) {
  return fill_moodle(parse_csv(text, "sheet.csv"), grades, options);
}

string sheet_error_of(const string& text, const FillOptions& options = {}) {
  return tests::refusal<BadInput>([&] { fill_sheet(text, {moodle_grade("4711", 5)}, options); });
}

TEST(MoodleWorksheet, ImportsTheGrades) {
  const Gradebook book =
      fill_sheet(kWorksheet, {moodle_grade("4711", 9.125), moodle_grade("4712", 0), moodle_grade("4713", 5)});
  const Imported imported = import_into_moodle(book.csv, kParticipants, false);
  EXPECT_EQ(imported.scores, (Scores{{"4711", "9.12"}, {"4712", "0"}}));
  EXPECT_EQ(imported.refused, Cells{});
  EXPECT_EQ(book.written, 2u);
  EXPECT_TRUE(says(book, "line 4: hand_in_4713's grade is not entered: Moodle has locked it"));
  EXPECT_TRUE(says(book, "1 person has no grade here, and their cells stay as they were: line "));
  EXPECT_TRUE(says(book.csv, "<p>3 tests failed</p>\n"));
  for (const Csv::Row& row : parse_csv(book.csv, "x").rows)
    for (const string& cell : row.cells) EXPECT_FALSE(starts_formula(cell)) << cell;
}

TEST(MoodleWorksheet, LeavesWhatMoodleWouldPassOver) {
  Grade excused = moodle_grade("4712", 3);
  excused.excused = true;
  const Gradebook book = fill_sheet(kWorksheet, {moodle_grade("4711", 10.5), excused});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, false).refused, Cells{});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, false).scores, Scores{});
  EXPECT_TRUE(says(book, "10.5 is more than the maximum of 10"));
  EXPECT_TRUE(says(book, "it is excused"));
}

TEST(MoodleWorksheet, DecimalsAreTheWorksheets) {
  string commas = kWorksheet;
  for (std::size_t at = 0; (at = commas.find("10.00", at)) != string::npos;)
    commas.replace(at, 5, "\"10,00\"");
  commas.replace(commas.find("7.50"), 4, "\"7,50\"");
  const Gradebook book = fill_sheet(commas, {moodle_grade("4711", 9.5)});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, true).scores, (Scores{{"4711", "9.5"}}));
  EXPECT_TRUE(says(book.csv, "\"9,5\""));
  EXPECT_TRUE(says(book, "not certain: decimals have a comma"));
}

TEST(MoodleWorksheet, AnotherMaximumIsNoAccident) {
  EXPECT_TRUE(says(sheet_error_of(kTitles + "Participant 4711,A,S,,5.00,Yes,-,-,\n"),
                   "is out of 5 points, and the grades are out of 10"));
  const Gradebook book = fill_sheet(kWorksheet, {moodle_grade("4711", 150, 200)}, {.scale = true});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, false).scores.at("4711"), "7.5");
}

TEST(MoodleWorksheet, ATeamIsNobody) {
  Grade team = moodle_grade("4711", 5);
  team.owner.group = true;
  const Gradebook book = fill_sheet(kWorksheet, {team, moodle_grade("4714", 5)});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, false).scores, (Scores{{"4714", "5"}}));
  EXPECT_TRUE(says(book, "a group is nobody on the roster"));
}

// Participants' numbers are those of one assignment.
TEST(MoodleWorksheet, OfAnotherAssignmentIsRefused) {
  Grade grade = moodle_grade("4711", 5);
  grade.owner.name = "Ann Oh";
  EXPECT_THROW(fill_sheet(kWorksheet, {grade}), BadInput);
  const Gradebook book = fill_sheet(kWorksheet, {grade, moodle_grade("4714", 5)});
  EXPECT_EQ(import_into_moodle(book.csv, kParticipants, false).scores, (Scores{{"4714", "5"}}));
  EXPECT_TRUE(says(book, "has no row in sheet.csv, its id is Jörg Müller-Lüdenscheidt's on the roster, and"));
}

// Translates the English worksheet: titles, the word for participants, "Yes" and "No".
struct Language {
  string titles, participant, yes, no;
};
const std::vector<Language> kLanguages{
    {"ID,Vollständiger Name,Status,Bewertung,Bestwertung,Bewertung kann geändert werden,Zuletzt geändert "
     "(Abgabe),Zuletzt geändert (Bewertung),Feedback als Kommentar\n",
     "Teilnehmer/in ", "Ja", "Nein"},
    {"Identifiant,Nom complet,Statut,Note,Note maximale,La note peut être modifiée,Dernière modification "
     "(travail remis),Dernière modification (note),Feedback par commentaires\n",
     "Participant ", "Oui", "Non"},
    {"Identificador,Nombre completo,Estado,Calificación,Calificación máxima,La calificación puede ser "
     "cambiada,Última modificación (entrega),Última modificación (calificación),Comentarios\n",
     "Participante ", "Sí", "No"},
    {"識別子,氏名,ステータス,評定,最大評定,評定変更可,最終更新日時 (提出),最終更新日時 "
     "(評定),フィードバックコメント\n",
     "参加者", "はい", "いいえ"}};

string replaced(string text, const string& from, const string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

string in_language(const Language& language) {
  const string rows = replaced(kWorksheet.substr(kTitles.size()), "Participant ", language.participant);
  return language.titles +
         replaced(replaced(rows, ",Yes,", "," + language.yes + ","), ",No,", "," + language.no + ",");
}

// Reads it as Moodle in that language does.
string in_english(const Language& language, const string& csv) {
  EXPECT_EQ(csv.find(language.titles), 0u) << "titles stay as they are";
  return kTitles + replaced(csv.substr(language.titles.size()), language.participant, "Participant ");
}

TEST(MoodleWorksheet, InAnotherLanguageIsKnownByItsForm) {
  for (const Language& language : kLanguages) {
    const Gradebook book =
        fill_sheet(in_language(language),
                   {moodle_grade("4711", 9.125), moodle_grade("4712", 0), moodle_grade("4713", 5)});
    const Imported imported = import_into_moodle(in_english(language, book.csv), kParticipants, false);
    EXPECT_EQ(imported.scores, (Scores{{"4711", "9.12"}, {"4712", "0"}})) << language.titles;
    EXPECT_EQ(imported.refused, Cells{});
    EXPECT_TRUE(says(book, "line 4: hand_in_4713's grade is not entered: Moodle has locked it"));
    EXPECT_TRUE(says(book, "not certain: the titles are not English"));
    EXPECT_TRUE(says(book, "upload with Moodle in that language"));
  }
}

TEST(MoodleWorksheet, InAnotherLanguageHasTheGradesThatAPersonNames) {
  const string unclear =
      replaced(replaced(in_language(kLanguages[0]), "Vollständiger Name,", "Vollständiger Name,Alt,Von,"),
               "Submitted for grading,", "3,20,Submitted for grading,");
  const string two = replaced(unclear, "Ann Oh,", "Ann Oh,,20,");
  EXPECT_TRUE(says(sheet_error_of(two),
                   "several columns look like grades; give --column with one of \"Alt\", \"Bewertung\""));
  const Gradebook book = fill_sheet(two, {moodle_grade("4711", 9)}, {.column = "bewertung"});
  EXPECT_TRUE(
      says(book.csv, "Teilnehmer/in 4711,Jörg Müller-Lüdenscheidt,3,20,Submitted for grading,9,10.00,Ja"));
  EXPECT_TRUE(says(sheet_error_of(in_language(kLanguages[0]), {.column = "Note"}), "no title is \"Note\""));
  const string words =
      replaced(replaced(in_language(kLanguages[0]), "10.00", "\"Gut, Schlecht\""), "7.50", "");
  EXPECT_TRUE(says(
      sheet_error_of(words),
      "no column looks like grades with a maximum behind it; give --column with the title of the grades"));
  EXPECT_TRUE(says(sheet_error_of(words, {.column = "Bewertung"}), "is a scale of words"));
}

TEST(MoodleWorksheet, InAnotherLanguageMayBeBlind) {
  string blind = kLanguages[0].titles;
  blind = replaced(blind, "Vollständiger Name,", "");
  for (const char* id : {"4711", "4712", "4713"})
    blind += "Teilnehmer/in " + string(id) +
             ",Zur Bewertung abgegeben,,\"10,00\",Ja,\"Dienstag, 4. März 2025, 10:15\",-,\n";
  const Gradebook book = fill_sheet(blind, {moodle_grade("4712", 9.5)});
  EXPECT_TRUE(says(book.csv, "4712,Zur Bewertung abgegeben,\"9,5\",\"10,00\""));
}

TEST(MoodleWorksheet, SaysWhatIsNoWorksheet) {
  for (const auto& [text, why] : std::vector<std::pair<string, string>>{
           {"id,name\n1,A\n", "sheet.csv, line 1: no title is \"Identifier\", and"},
           {"Identifier,Bewertung,x\nTeilnehmer/in 4711,,-\n", "give --column with the title of the grades"},
           {"Identifier,Grade,x\nParticipant 4711,,-\n", "no title is \"Last modified (grade)\""},
           {kTitles + "Participant 4711,A,S\n", "line 2: has 3 cells, and there are 9 titles"},
           {kTitles + "Participant 4711,A,S,,\"Good, Bad\",Yes,-,-,\n", "\"Good, Bad\" is a scale of words"}})
    EXPECT_TRUE(says(sheet_error_of(text), why));
}

}  // namespace
}  // namespace grader::gradebook
