// STAFF ONLY. Tests that staff read people's names next to the folders' names; in blind grading they read
// codes, and no file or line for them has a name.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/record/record.h"
#include "grader/tests/run_program.h"
#include "grader/text/letters.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;

class NamesAndCodes : public testing::Test {
 protected:
  ProgramRun run(std::vector<string> words) const {
    words.insert(words.end(), {"--out", out_.string()});
    return run_hairgrade(words);
  }
  ProgramRun grade(std::vector<string> more) const {
    more.insert(more.begin(),
                {"grade", (root_ / "class").string(), "--from", "canvas", "--roster",
                 (root_ / "roster.csv").string(), "--secret", (root_ / "secret").string(), "--cache",
                 (root_ / "cache").string(), "--course", (root_ / "course.json").string(), "--no-images"});
    return run(more);
  }
  // Writes a class whose files don't compile, which saves time.
  void write_class() const {
    fs::create_directory(root_ / "class");
    std::ofstream(root_ / "course.json") << course_of({"S1"});
    std::ofstream(root_ / "secret") << "a secret for this test";
    std::ofstream(root_ / "class/mustermannerika_4711047110_90001_conj_grad.cpp")
        << "int mustermann = \"Erika\";  // Erika Mustermann, e.mustermann@u.de\n";
    std::ofstream(root_ / "class/mustermannerika_4711047110_90002_erika_notes.txt") << "by Erika";
    std::ofstream(root_ / "class/zuckerzoe_4712047120_90003_conj_grad.cpp") << "no\n";
    std::ofstream(root_ / "class/fremdfritz_4713047130_90004_conj_grad.txt") << "no\n";
    std::ofstream(root_ / "roster.csv") << "ID,Student,SIS Login ID,Section\n4711047110,\"Mustermann, "
                                           "Erika\",em1234,A\n4712047120,\"Zucker, Zoë\",zz,B\n"
                                           "4714047140,\"Weg, Walter\",ww9999,A\n";
  }
  // Reads files by path, except the record's own.
  std::map<string, string> files() const {
    std::map<string, string> all;
    for (const auto& entry : fs::recursive_directory_iterator(out_))
      if (const string path = fs::relative(entry.path(), out_); !path.starts_with(kRecordFile))
        all[path] = entry.is_regular_file() ? hair::bytes_of(entry.path()) : "";
    return all;
  }

  hair::TemporaryFolder temporary_{"names and codes"};
  fs::path root_ = temporary_.path(), out_ = root_ / "grades";
};

TEST_F(NamesAndCodes, PeopleReadNamesAndCommandsTakeFolders) {
  fs::create_directory(out_);
  {
    Record record(out_);
    const Roster roster(parse_csv("id,name\n4711047110,\"Mu\xcc\x88ller, <b>\"\n", "r.csv"));
    record.put_people({{"mueller_4711047110", {.name = "müllerb", .id = "4711047110"}, "canvas"},
                       {"plain", {.name = "plain"}, "folders"}},
                      roster.people());
    for (const char* name : {"mueller_4711047110", "plain"})
      for (const double points : {1., 2.}) {
        Recorded one;
        one.result.name = name;
        ExerciseResult& exercise = one.result.exercises.emplace_back();
        exercise.id = "H2";
        exercise.title = "Two";
        exercise.points = points;
        exercise.max_points = 8;
        record.put(one);
      }
  }
  ASSERT_EQ(run({"comment", "mueller_4711047110", "all", "x"}).code, 0);
  std::map<string, string> all = files();
  const auto has = [](const string& text, const string& words) { return text.find(words) != string::npos; };
  const string name = "Müller, &lt;b&gt;";
  for (const char* page : {"index.html", "staff/mueller_4711047110.html", "costs.html"}) {
    EXPECT_TRUE(has(all[page], name)) << page;
    EXPECT_TRUE(has(all[page], "mueller_4711047110")) << page;
  }
  EXPECT_TRUE(has(all["mueller_4711047110/report.html"], "<h1>" + name + "</h1>"));
  EXPECT_TRUE(has(all["plain/report.html"], "<h1>plain</h1>"));
  EXPECT_FALSE(has(all["staff/plain.html"], "<code>plain</code>"));
  EXPECT_TRUE(has(all["grades.csv"], "\"Müller, <b>\"")) << all["grades.csv"];
  const nlohmann::json json = nlohmann::json::parse(all["staff/mueller_4711047110.json"]);
  EXPECT_EQ(json["name"], "mueller_4711047110");
  EXPECT_EQ(json["person"], "Müller, <b>");
  EXPECT_FALSE(has(run({"export"}).output, "\"person\""));
  EXPECT_TRUE(has(run({"export"}).output, "\"müllerb\""));
  EXPECT_TRUE(has(run({"diff"}).output, "Müller, <b> (mueller_4711047110)  H2  1 -> 2"));
  EXPECT_TRUE(run({"log", "mueller_4711047110"}).output.starts_with("Müller, <b> (mueller_4711047110)\n"));
}

TEST_F(NamesAndCodes, BlindGradingShowsNobodysName) {
  write_class();
  const ProgramRun first = grade({"--anonymous"});
  ASSERT_EQ(first.code, 3) << first.errors;
  const std::map<string, string> all = files();
  const auto look = [](const string& text, const string& where) {
    for (const char* name : {"mustermann", "erika", "4711047110", "em1234", "zucker", "zoë", "zoe",
                             "4712047120", "fremd", "fritz", "4713047130", "walter", "ww9999"})
      EXPECT_EQ(lowered(text).find(name), string::npos) << where << " has " << name << ": " << text;
  };
  look(first.output, "the terminal");
  look(first.errors, "the terminal");
  for (const auto& [path, bytes] : all) {
    look(path, "a path");
    if (!path.ends_with(".png")) look(bytes, path);
  }
  EXPECT_NE(first.output.find("roster: 2 of 3 handed in"), string::npos) << first.output;

  std::vector<string> names;
  {
    Record record(out_);
    EXPECT_TRUE(record.is_blind());
    names = record.names();
    ASSERT_EQ(names.size(), 3U);
    for (const string& name : names) EXPECT_TRUE(all.contains(name + "/report.html"));
    EXPECT_EQ(record.drawn_from(record.codes().at("mustermannerika_4711047110")),
              "mustermannerika_4711047110");
  }
  for (const char* file : {"class.sqlite", "index.html", "grades.csv"})
    EXPECT_TRUE(fs::exists(out_ / file)) << file;
  EXPECT_EQ(fs::status(out_ / kRecordFile).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  // It stays blind, with the same codes; commands take these.
  const ProgramRun second = grade({"--resume"});
  EXPECT_EQ(second.code, 3) << second.errors;
  look(second.output + second.errors, "the second terminal");
  EXPECT_EQ(Record(out_).names(), names);
  for (const std::vector<string>& words : std::vector<std::vector<string>>{
           {"comment", names[0], "all", "x"}, {"log", names[0]}, {"diff"}, {"export"}}) {
    const ProgramRun told = run(words);
    EXPECT_EQ(told.code, 0) << told.errors;
    look(told.output + told.errors, words.front());
  }

  // Gradebooks and feedback are for people, and have their names.
  const ProgramRun book =
      run_hairgrade({"gradebook", "gradescope", "--grades", out_.string(), "--roster",
                     (root_ / "roster.csv").string(), "--out", (root_ / "book.csv").string()});
  ASSERT_EQ(book.code, 0) << book.errors;
  EXPECT_NE(hair::bytes_of(root_ / "book.csv").find("4711047110"), string::npos);
}

}  // namespace
}  // namespace grader
