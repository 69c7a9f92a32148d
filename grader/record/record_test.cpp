// STAFF ONLY. Tests that a record returns its data, and keeps nothing of a forgotten person.
#include "grader/record/record.h"

#include <gtest/gtest.h>
#include <linux/magic.h>
#include <sys/wait.h>

#include <fstream>

#include "grader/course/input.h"
#include "grader/record/schema.h"
#include "grader/report/facts/sample_results.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using tests::says;

namespace fs = std::filesystem;

class RecordOfAClass : public testing::TestWithParam<Journal> {
 protected:
  Record record() const { return Record(dir_, GetParam()); }
  hair::TemporaryFolder temporary_{"record"};
  fs::path dir_ = temporary_.path(), file_ = dir_ / kRecordFile;
};
INSTANTIATE_TEST_SUITE_P(WithEachJournal, RecordOfAClass, testing::Values(Journal::best, Journal::rollback));

TEST_P(RecordOfAClass, GivesResultsBackWhole) {
  std::vector<SubmissionResult> results = sample_class(20);
  results.push_back(submission_full_of(std::string("\0\xff\x1b[31m<\"", 9)));
  results.back().name = "full";
  Record record(dir_, GetParam());
  for (const SubmissionResult& result : results) record.put({result});
  Record again(dir_, GetParam());
  EXPECT_EQ(again.names().size(), results.size());
  for (const SubmissionResult& result : results)
    EXPECT_EQ(json_text(again.find(result.name).value().result, 1), json_text(result, 1));
  EXPECT_FALSE(again.find("nobody"));
}

TEST_P(RecordOfAClass, ReplacesAResultAndLogsBoth) {
  SubmissionResult result = sample_class(1).front();
  Record record(dir_, GetParam());
  record.put({result, {}, {{"S1", {1}}}});
  result.exercises[0].points = 0;
  const SubmissionStudy study{};
  record.put({result, study, {{"S1", {2}}}});
  const Recorded found = record.find("alice").value();
  EXPECT_EQ(found.result, result);
  EXPECT_TRUE(found.study);
  EXPECT_EQ(found.costs.at("S1").compile_seconds, 2);
  EXPECT_EQ(record.log("alice").size(), 2U);
  EXPECT_EQ(record.log("alice").front().did, "graded");
  EXPECT_THROW(record.log("nobody"), BadInput);
}

TEST_P(RecordOfAClass, NeverChangesAStudentsInputs) {
  Record record(dir_, GetParam());
  const Owner pair{.name = "pair", .group = true, .members = {{.id = "1"}, {.id = "2"}}};
  record.put_people({{"alice", {.name = "alice"}, "folders"}, {"pair", pair, "gradescope"}});
  record.put({sample_class(1).front()});
  // The group has another name, and the group that takes its old name draws other inputs.
  const Owner others{.name = "pair", .group = true, .members = {{.id = "3"}, {.id = "4"}}};
  record.put_people({{"alice", {.name = "Alice", .id = "1"}, "canvas"},
                     {"renamed", pair, "gradescope"},
                     {"pair", others, "gradescope"}});
  Record again(dir_, GetParam());
  EXPECT_EQ(again.drawn_from("alice"), "alice");
  EXPECT_EQ(again.drawn_from("renamed"), "pair");
  EXPECT_NE(again.drawn_from("pair"), "pair");
  EXPECT_EQ(tests::refusal<BadInput>([&] { again.drawn_from("nobody"); }).find("nobody: "), 0U);
}

TEST_P(RecordOfAClass, IsClosedToOthers) {
  umask(0);
  Record record(dir_, GetParam());
  record.put({sample_class(1).front()});
  for (const auto& entry : fs::directory_iterator(dir_))
    EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << entry.path();
}

// Looks in another process: this one must not open the file beside SQLite.
bool holds(const fs::path& folder, const std::string& bytes) {
  const std::string command = "grep -rqaF '" + bytes + "' '" + folder.string() + "'";
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) < 2) << command;
  return WEXITSTATUS(status) == 0;
}

TEST_P(RecordOfAClass, ForgetsEveryByte) {
  std::vector<SubmissionResult> results = sample_class(3);
  SubmissionResult& bob = results[1];
  bob.name = "bobwillgo";
  bob.origin = "hand-in /bobwillgo-origin.zip";
  bob.exercises[0].staff_log = "bobwillgo-log" + std::string(50'000, 'x');  // takes pages of its own
  bob.exercises[0].pictures = {{"1 s", 0, 0, "bobwillgo-picture", "reference-picture", ""}};
  results[0].exercises[0].pictures = {{"1 s", 0, 0, "alice-picture", "reference-picture", ""}};
  Record record(dir_, GetParam());
  for (const SubmissionResult& result : results) record.put({result}, {"2025-03-04 10:15:22"});
  bob.exercises[0].staff_log = "bobwillgo-other-log";
  record.put({bob});
  Record next(dir_, "week 2", GetParam());
  for (const SubmissionResult& result : results) next.put({result});
  next.decide("bobwillgo", {DecisionKind::comment, "", 0, 0, "for bobwillgo"});
  EXPECT_TRUE(holds(dir_, "bobwillgo"));
  record.forget("bobwillgo");
  record.shred();
  EXPECT_FALSE(holds(dir_, "bobwillgo"));
  EXPECT_TRUE(holds(dir_, "alice-picture"));
  EXPECT_TRUE(record.find("alice").value().result == results[0]) << "a picture that both show is kept";
  EXPECT_TRUE(next.find("alice").value().result == results[0]);
  for (Record* one : {&record, &next}) EXPECT_FALSE(one->find("bobwillgo"));
  EXPECT_EQ(record.names().size(), 2U);
}

TEST_P(RecordOfAClass, ListsTheLastRunsFilesAndForgetsWhoTheyAreOf) {
  using enum Accounted::As;
  Record record(dir_, GetParam());
  record.put_people({{"bob", {}, "folders"}, {"carol", {}, "folders"}});
  record.set_listed({{"an/earlier/run", left_over, "is gone", ""}});
  const std::vector<Accounted> all{{"c/bob/a.cpp", older, "a newer one counts", "bob"},
                                   {"c/x.cpp", left_over, "belongs to nobody", ""},
                                   {"c/bob.rtf", left_over, "belongs to nobody", ""},
                                   {"", notice, "c/carol: stayed shut", "carol"},
                                   {"c/dave/a.cpp", older, "is of one whom nobody asked for", "dave"},
                                   {"c/i.html", made, "is the system's", ""}};
  record.set_listed(all);
  const auto told = [&] {
    std::string text;
    for (const Accounted& file : Record(dir_, GetParam()).listed())
      text += to_string(file.as) + " " + file.path + " " + file.reason + " " + file.whose + "\n";
    return text;
  };
  EXPECT_EQ(told(),
            "older c/bob/a.cpp a newer one counts bob\nleft_over c/x.cpp belongs to nobody \nleft_over "
            "c/bob.rtf belongs "
            "to nobody \nnotice  c/carol: stayed shut carol\nmade c/i.html is the system's \n");
  EXPECT_TRUE(says(record.export_json(), "c/carol: stayed shut"));
  record.forget("bob");
  record.shred();
  EXPECT_EQ(told(),
            "left_over c/x.cpp belongs to nobody \nnotice  c/carol: stayed shut carol\nmade c/i.html is the "
            "system's \n");
  EXPECT_FALSE(holds(dir_, "bob"));
}

TEST_P(RecordOfAClass, IsNoOtherFile) {
  std::ofstream(file_) << std::string(5000, 'x');
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { record(); }), "class.sqlite: is damaged"));
  fs::remove(file_);
  Database(file_, GetParam()).run("CREATE TABLE bookmarks (id)");
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { record(); }), "no record of grades"));
}

TEST_P(RecordOfAClass, OfANewerOrAFarOlderVersionIsRefused) {
  record();
  for (const std::string version : {"99", "6"}) {
    Database(file_, GetParam()).run_all("PRAGMA user_version = " + version);
    EXPECT_TRUE(says(tests::refusal<BadInput>([&] { record(); }),
                     "has version " + version + ", and this hairgrade knows 7 to"));
  }
}

TEST_P(RecordOfAClass, OfAnOlderVersionIsBroughtOn) {
  record().put({sample_class(1).front()});
  std::vector<std::string> steps = migrations();
  steps.push_back("ALTER TABLE people ADD COLUMN section TEXT NOT NULL DEFAULT 'A'");
  steps.push_back("ALTER TABLE people ADD COLUMN broken; this is no SQL");
  {
    Database database(file_, GetParam());
    const std::int64_t now = database.number("PRAGMA user_version");
    EXPECT_THROW(migrate(database, steps), BadInput);
    EXPECT_EQ(database.number("PRAGMA user_version"), now + 1) << "each step is whole or taken back";
    EXPECT_EQ(database.text("SELECT section FROM people"), "A");
    EXPECT_EQ(database.number("SELECT max(version) FROM migrations"), now + 1);
  }
}

TEST(Journals, AreRollbackJournalsWhereMemoryMayNotBeShared) {
  EXPECT_TRUE(is_local_file_system(EXT4_SUPER_MAGIC));
  EXPECT_TRUE(is_local_file_system(OVERLAYFS_SUPER_MAGIC));
  for (const std::uint64_t remote : {std::uint64_t{NFS_SUPER_MAGIC}, std::uint64_t{SMB2_SUPER_MAGIC},
                                     std::uint64_t{FUSE_SUPER_MAGIC}, std::uint64_t{0x0bd00bd0} /* Lustre */})
    EXPECT_FALSE(is_local_file_system(remote)) << remote;
}

// The record moves from a local disk to a network home.
TEST(Journals, ARecordChangesItsJournalWithItsPlace) {
  const hair::TemporaryFolder folder("journals");
  const fs::path file = folder.path() / kRecordFile;
  const auto journal = [&](Journal wanted) { return Database(file, wanted).text("PRAGMA journal_mode"); };
  EXPECT_EQ(journal(Journal::best), "wal");
  EXPECT_EQ(journal(Journal::rollback), "delete");
  EXPECT_EQ(journal(Journal::best), "wal");
}

}  // namespace
}  // namespace grader::record
