// STAFF ONLY. Tests that staff read people's names next to the folders' names; in blind grading they read
// codes, and no file or line for them has a name.
#include "grader/record/record.h"
#include "grader/tests/in_a_folder.h"
#include "grader/text/letters.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using std::string;
using tests::says;

class NamesAndCodes : public InAFolder {
 protected:
  NamesAndCodes() : InAFolder(course_of({"S1"})) {}
  ProgramRun grade(std::vector<string> more) const {
    more.insert(more.begin(), {path("class"), "--from", "canvas", "--roster", path("roster.csv")});
    return InAFolder::grade(more);
  }
  // Writes a class whose files don't compile, which saves time.
  void write_class() const {
    write("class/mustermannerika_4711047110_90001_conj_grad.cpp",
          "int mustermann = \"Erika\";  // Erika Mustermann, e.mustermann@u.de\n");
    write("class/mustermannerika_4711047110_90002_erika_notes.txt", "by Erika");
    write("class/zuckerzoe_4712047120_90003_conj_grad.cpp", "no\n");
    write("class/fremdfritz_4713047130_90004_conj_grad.txt", "no\n");
    write("roster.csv",
          "ID,Student,SIS Login ID,Section\n4711047110,\"Mustermann, Erika\",em1234,A\n"
          "4712047120,\"Zucker, Zoë\",zz,B\n4714047140,\"Weg, Walter\",ww9999,A\n");
  }
  // Reads files by path, except the record's own.
  std::map<string, string> files() const { return files_in(out_); }

  const fs::path out_ = root_ / "grades";
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
      for (const double points : {1., 2.})
        record.put(
            {{.name = name, .exercises = {{.id = "H2", .title = "Two", .points = points, .max_points = 8}}}});
  }
  ASSERT_EQ(run({"comment", "mueller_4711047110", "all", "x"}).code, 0);
  std::map<string, string> all = files();
  const string name = "Müller, &lt;b&gt;";
  for (const char* page : {"index.html", "staff/mueller_4711047110.html", "costs.html"}) {
    EXPECT_TRUE(says(all[page], name)) << page;
    EXPECT_TRUE(says(all[page], "mueller_4711047110")) << page;
  }
  EXPECT_TRUE(says(all["mueller_4711047110/report.html"], "<h1>" + name + "</h1>"));
  EXPECT_TRUE(says(all["plain/report.html"], "<h1>plain</h1>"));
  EXPECT_FALSE(says(all["staff/plain.html"], "<code>plain</code>"));
  EXPECT_TRUE(says(all["grades.csv"], "\"Müller, <b>\"")) << all["grades.csv"];
  const nlohmann::json json = nlohmann::json::parse(all["staff/mueller_4711047110.json"]);
  EXPECT_EQ(json["name"], "mueller_4711047110");
  EXPECT_EQ(json["person"], "Müller, <b>");
  EXPECT_FALSE(says(run({"export"}).output, "\"person\""));
  EXPECT_TRUE(says(run({"export"}).output, "\"müllerb\""));
  EXPECT_TRUE(says(run({"diff"}).output, "Müller, <b> (mueller_4711047110)  H2  1 -> 2"));
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
      EXPECT_FALSE(says(lowered(text), name)) << where << " has "
                                              << ": " << text;
  };
  look(first.output, "the terminal");
  look(first.errors, "the terminal");
  for (const auto& [path, bytes] : all) {
    look(path, "a path");
    if (!path.ends_with(".png")) look(bytes, path);
  }
  EXPECT_TRUE(says(first.output, "roster: 2 of 3 handed in"));

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
  EXPECT_TRUE(says(hair::bytes_of(root_ / "book.csv"), "4711047110"));
}

}  // namespace
}  // namespace grader
