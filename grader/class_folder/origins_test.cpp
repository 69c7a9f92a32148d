// STAFF ONLY. Tests that a submission is replaced by its own origin, or by a confirmation or option.
#include "grader/class_folder/origins.h"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "grader/class_folder/says_yes.h"
#include "grader/grading/grading.h"
#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline class_folder {
namespace {

using Names = std::vector<std::string>;

const std::string kHandInOfAlice = origin_text(kHandIn, "/a/alice.zip");
const std::string kFirst = origin_text(kClass, "/a/class.zip"),
                  kLater = origin_text(kLearningSystem, "/b/new.zip");
const CallersWord kNothingSaid, kClassSaid{.class_over_rows = true}, kFromSaid{.choices = {.from = "canvas"}},
    kReplaceSaid{.replace = true};

class Origins : public testing::Test {
 protected:
  // Makes hand-ins of these people; "bob!" has a new one, "bob?" none that counts, and "bob=" the one that
  // all such people share.
  static std::vector<Submission> from(const std::string& origin, const Names& people) {
    std::vector<Submission> submissions;
    for (const std::string& text : people) {
      Submission one{text.substr(0, text.find_first_of("!?=")), origin};
      if (!text.ends_with('?'))
        one.files["conj_grad.cpp"].text = text.ends_with('=') ? "the stub" : "int of_" + text + ";\n";
      submissions.push_back(one);
    }
    return submissions;
  }
  void add_rows(const std::string& origin, const Names& people) const {
    for (const Submission& one : from(origin, people)) {
      SubmissionResult result;
      result.name = one.name;
      result.origin = one.origin;
      Record(dir_).put({result}, {.files = hash_of_files(one)});
    }
  }
  // Returns the line of the refusal; "" if nothing is refused.
  std::string refusal(std::vector<Submission> submissions, const CallersWord& word = kNothingSaid,
                      const std::optional<std::string>& only = {}) const {
    return tests::refusal<Question>(
        [&] { EXPECT_EQ(settle_origins(dir_, submissions, only, word).replaced, Names{}); });
  }

  hair::TemporaryFolder temporary_{"origins"};
  const std::filesystem::path dir_ = temporary_.path();
};

TEST_F(Origins, AFolderWithoutRowsTakesAny) {
  EXPECT_EQ(refusal(from(kFirst, {"alice", "bob"})), "");
}

TEST_F(Origins, AClassReplacesNoHandIn) {
  add_rows(kHandInOfAlice, {"alice"});
  const std::vector<Submission> submissions = from(kFirst, {"alice!", "mallory"});
  EXPECT_EQ(refusal(submissions, kClassSaid),
            dir_.string() +
                ": the rows of alice are of another origin, so nothing was graded: alice is there of the "
                "hand-in /a/alice.zip, and here of the class /a/class.zip; leave them out, or, to replace "
                "these rows, say --replace");
  EXPECT_EQ(refusal(submissions, kNothingSaid, "mallory"), "") << "alice is not graded";
  EXPECT_NE(refusal(submissions, kNothingSaid, "alice"), "");
  EXPECT_EQ(refusal(from(kFirst, {"alice"})), "") << "the same bytes";
}

TEST_F(Origins, AHandInReplacesNoOtherOfItsNameAndNoRowOfAClass) {
  add_rows(kHandInOfAlice, {"handin"});
  EXPECT_EQ(refusal(from(kHandInOfAlice, {"handin!"})), "");
  EXPECT_NE(refusal(from(origin_text(kHandIn, "/b/alice.zip"), {"handin!"})), "");
  add_rows(kFirst, {"alice", "bob"});
  EXPECT_NE(refusal(from(kHandInOfAlice, {"alice!"})), "");
  EXPECT_EQ(refusal(from(kHandInOfAlice, {"carol"})), "") << "somebody new";
}

TEST_F(Origins, ALaterDownloadHasMostHandInsAsTheyWere) {
  const struct {
    Names before, now;
    const char* would;  // would change; "": nothing that needs a word
  } cases[]{
      {{"a", "b", "c"}, {"a", "b", "c!", "d"}, ""},
      {{"a", "b", "c"}, {"a", "b"}, ""},
      {{"a", "b", "c", "d?", "e?"}, {"a", "b", "d", "e?"}, ""},
      {{"a", "b", "c", "d?", "e?"}, {"a", "b", "c", "d", "e?"}, ""},
      {{"a", "b", "c"}, {"a", "b!", "c!"}, "replace the rows of b, c;"},
      {{"a", "b", "c", "d"}, {"a", "b", "c!"}, "replace the rows of c;"},
      {{"a", "b", "c", "d"}, {"a", "b!", "e"}, "replace the rows of b and add rows of e;"},
      {{"a", "b"}, {"a", "e"}, "add rows of e;"},
      {{"a", "b?"}, {"a", "b"}, "replace the rows of b;"},
      {{"a?", "b?", "c?"}, {"a?", "b?", "c?", "d"}, "add rows of d;"},
      {{"a!", "b!"}, {"a", "b"}, "replace the rows of a, b;"},
      {{"a", "b=", "c=", "d=", "e"}, {"a!", "b=", "c=", "d=", "e"}, "replace the rows of a;"},
      {{"a", "b=", "c=", "d"}, {"a", "b=", "c=", "d", "e"}, ""},
  };
  for (const auto& [before, now, would] : cases) {
    SCOPED_TRACE(testing::PrintToString(now));
    std::filesystem::remove(dir_ / kRecordFile);
    add_rows(kFirst, before);
    const std::string line = refusal(from(kLater, now));
    EXPECT_EQ(line.empty(), std::string(would).empty()) << line;
    EXPECT_NE((line + ";").find(would), std::string::npos) << line;
    EXPECT_TRUE(line.empty() || line.ends_with("--class")) << line;
    EXPECT_EQ(refusal(from(kLater, now), kFromSaid), line);
    for (const CallersWord& word : {kClassSaid, kReplaceSaid})
      EXPECT_EQ(refusal(from(kLater, now), word), "");
    EXPECT_EQ(refusal(from(kFirst, now)), "") << "the same path";
    std::vector<Submission> later = from(kLater, now);
    settle_origins(dir_, later, {}, kClassSaid);
    for (const Submission& one : later) EXPECT_EQ(one.origin, kFirst) << "its rows are of one class";
  }
}

TEST_F(Origins, ADownloadOfOtherPeopleIsAnotherClassIfTheCallerSaysSo) {
  add_rows(kFirst, {"1_ann", "2_bob"});
  std::vector<Submission> others = from(kLater, {"7_ann", "8_bob"});
  EXPECT_NE(refusal(from(kFirst, {"7_ann", "8_bob"})), "") << "the same path";
  for (const CallersWord& word : {kNothingSaid, kFromSaid})
    EXPECT_NE(
        refusal(others, word)
            .find("nobody who was graded of the class /a/class.zip is in the class of a learning system "
                  "/b/new.zip"),
        std::string::npos);
  EXPECT_EQ(settle_origins(dir_, others, {}, kClassSaid).missing, Names{});
  EXPECT_EQ(others[0].origin, kLater);
}

TEST_F(Origins, WhoIsMissingIsNamedUnlessOneAloneIsGraded) {
  add_rows(kFirst, {"a", "b", "c", "d"});
  for (const std::string& origin : {kFirst, kLater}) {
    std::vector<Submission> later = from(origin, {"a", "b"});
    const Names missing = settle_origins(dir_, later, {}, {}).missing;
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_TRUE(missing[0].starts_with("not in this download, but in an earlier one: c, d;")) << missing[0];
    EXPECT_EQ(settle_origins(dir_, later, "a", {}).missing, Names{});
  }
}

TEST_F(Origins, TheFlagReplacesWithAWord) {
  add_rows(kHandInOfAlice, {"alice"});
  std::vector<Submission> submissions = from(kFirst, {"alice!", "bob"});
  EXPECT_EQ(settle_origins(dir_, submissions, {}, kReplaceSaid).replaced,
            Names{"alice is there of the hand-in /a/alice.zip, and here of the class /a/class.zip"});
  EXPECT_EQ(submissions[0].origin, kFirst);
}

// Asks a child on a terminal of its own; "" stands for no terminal.
bool goes_on(const std::string& answer) {
  int terminal = -1;
  const pid_t child = answer.empty() ? fork() : forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    if (answer.empty()) close(STDIN_FILENO);
    bool classes = false, replace = false;
    try {
      until_answered(classes, replace, [&] {
        if (!classes) throw Question("it may be one student's; if it is a class, say", kSaysClass);
      });
    } catch (const Question&) {
      _exit(1);
    }
    _exit(0);
  }
  const bool typed =
      terminal < 0 || write(terminal, answer.data(), answer.size()) == static_cast<ssize_t>(answer.size());
  int status = -1;
  waitpid(child, &status, 0);
  if (terminal >= 0) close(terminal);
  return typed && status == 0;
}

TEST(Asking, GoesOnAfterAYesAtATerminalAlone) {
  EXPECT_TRUE(goes_on("y\n"));
  EXPECT_TRUE(goes_on("yes\n"));
  for (const char* no : {"", "\n", "n\n", "nay\n", "\x04"}) EXPECT_FALSE(goes_on(no)) << no;
}

}  // namespace
}  // namespace grader::class_folder
