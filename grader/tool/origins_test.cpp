// STAFF ONLY. Rows in a folder of grades are replaced by their own origin alone, or by a word and a flag.
#include "grader/tool/origins.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/intake/origin.h"
#include "grader/record/record.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

using Names = std::vector<std::string>;

const std::string kHandInOfAlice = origin_text(kHandIn, "/a/alice.zip");
const std::string kFirst = origin_text(kClass, "/a/class.zip"), kLater = origin_text(kClass, "/b/new.zip");

class Origins : public testing::Test {
 protected:
  void add_rows(const std::string& origin, const Names& names) const {
    for (const std::string& name : names) {
      SubmissionResult result;
      result.name = name;
      result.origin = origin;
      Record(dir_).put({result});
    }
  }
  static std::vector<Submission> from(const std::string& origin, const Names& names) {
    std::vector<Submission> submissions;
    for (const std::string& name : names) submissions.push_back({name, origin, {}, {}});
    return submissions;
  }
  // The line that refuses; "" if nothing is refused.
  std::string refusal(std::vector<Submission> submissions,
                      const std::optional<std::string>& only = {}) const {
    try {
      EXPECT_EQ(settle_origins(dir_, submissions, only, false), Names{});
    } catch (const BadInput& line) {
      return line.what();
    }
    return "";
  }

  hair::TemporaryFolder temporary_{"origins"};
  const std::filesystem::path dir_ = temporary_.path();
};

TEST_F(Origins, AFolderWithoutRowsTakesAny) {
  EXPECT_EQ(refusal(from(kFirst, {"alice", "bob"})), "");
}

TEST_F(Origins, AClassReplacesNoHandIn) {
  add_rows(kHandInOfAlice, {"alice"});
  const std::string line = refusal(from(kFirst, {"alice", "mallory"}));
  EXPECT_EQ(line,
            dir_.string() +
                ": the rows of alice are of another origin, so nothing was graded: alice is there of the "
                "hand-in /a/alice.zip, and here of the class /a/class.zip; leave them out, or say "
                "--replace to replace these rows");
  EXPECT_EQ(refusal(from(kFirst, {"alice", "mallory"}), "mallory"), "") << "alice is not graded";
}

TEST_F(Origins, AHandInReplacesNoOtherOfItsNameAndNoRowOfAClass) {
  add_rows(kHandInOfAlice, {"handin"});
  EXPECT_EQ(refusal(from(kHandInOfAlice, {"handin"})), "");
  EXPECT_NE(refusal(from(origin_text(kHandIn, "/b/alice.zip"), {"handin"})), "");
  add_rows(kFirst, {"alice", "bob"});
  EXPECT_NE(refusal(from(kHandInOfAlice, {"alice"})), "");
}

TEST_F(Origins, ALaterDownloadIsTheSameClassWhateverItsName) {
  add_rows(kFirst, {"alice", "bob"});
  std::vector<Submission> later = from(kLater, {"alice", "bob", "carol"});
  EXPECT_EQ(settle_origins(dir_, later, {}, false), Names{});
  for (const Submission& one : later) EXPECT_EQ(one.origin, kFirst) << "its rows are of one class";
}

TEST_F(Origins, AnotherClassIsNoLaterDownload) {
  add_rows(kFirst, {"alice", "bob", "carol"});
  EXPECT_NE(refusal(from(kLater, {"alice", "bob", "mallory"})), "") << "carol is not in it";
  EXPECT_NE(refusal(from(origin_text(kLearningSystem, "/b/new.zip"), {"alice", "bob", "carol"})), "")
      << "of another kind";
  EXPECT_EQ(refusal(from(kLater, {"dave", "mallory"})), "") << "it replaces nobody";
  EXPECT_EQ(refusal(from(kFirst, {"alice", "bob"})), "") << "the same path: carol has left";
}

TEST_F(Origins, OneNameTellsNoClass) {
  add_rows(kFirst, {"handin"});
  EXPECT_NE(refusal(from(kLater, {"handin"})), "");
}

TEST_F(Origins, TheFlagReplacesWithAWord) {
  add_rows(kHandInOfAlice, {"alice"});
  std::vector<Submission> submissions = from(kFirst, {"alice", "bob"});
  EXPECT_EQ(settle_origins(dir_, submissions, {}, true),
            Names{"alice is there of the hand-in /a/alice.zip, and here of the class /a/class.zip"});
  EXPECT_EQ(submissions[0].origin, kFirst);
}

}  // namespace
}  // namespace grader
