// STAFF ONLY. Tests that a reader's sandbox holds, and that a reader's failure costs only its archive.
#include "grader/intake/archives/sandboxed_archive.h"

#include <signal.h>

#include "grader/intake/submissions_fixture.h"
#include "grader/sandbox/isolation_for_tests.h"

namespace grader::inline intake {
namespace {

// Reads classes by a hostile reader (hostile_reader.cpp).
class SandboxedReading : public Submissions {
 protected:
  SandboxedReading() { limits_.unpacked_bytes = limits_.stream_bytes = 1 << 20; }  // gives it 5 s

  Intake read_hostile(const fs::path& argument) const {
    return read_submissions({argument}, two_exercises(), hostile_.opener(), limits_);
  }
  // Returns the one submission that is an archive of these bytes.
  Submission attacked(const std::string& bytes) {
    intake_ = read_hostile(write("only/alice.zip", bytes).parent_path());
    return intake_.submissions.at(0);
  }

  SandboxedReader hostile_{HAIR_HOSTILE_READER, isolation_for_tests()};
  IntakeLimits limits_;
  Intake intake_;
};

TEST_F(SandboxedReading, SeesNothingButLibraries) {
  const fs::path secret = write("secret", "secret");
  fs::permissions(dir_, fs::perms::all);
  fs::permissions(secret, fs::perms::all);
  EXPECT_EQ(attacked("evil-look " + secret.string()).problem, "found: ");
}

// All of these raise SIGSYS.
TEST_F(SandboxedReading, OpensNoSocketStartsNoProcessAndWritesNoFile) {
  for (const char* how : {"evil-socket", "evil-process", "evil-write"}) {
    const Submission alice = attacked(how);
    EXPECT_TRUE(alice.unreadable);
    EXPECT_TRUE(says(alice.problem, "alice.zip can't be read")) << how;
    EXPECT_TRUE(has_remark(intake_, {"alice.zip: the reader of alice.zip ended by signal 31"})) << how;
  }
}

TEST_F(SandboxedReading, BreaksDownForItselfAlone) {
  const std::map<std::string, std::string> ends = {
      {"crash", "ended by signal 6"},
      {"leave", "ended with code 7"},
      {"memory", "ran out of memory"},
      {"loop", "took too long"},
      {"sleep", "took too long"},
      {"noise", "broke its protocol"},
      {"boast", "broke its protocol: 1152921504606846976 entries"}};
  for (const auto& [how, end] : ends) {
    SCOPED_TRACE(how);
    const hair::TemporaryFolder folder("class");
    dir_ = folder.path();
    write("class/alice.zip", zip("conj_grad.cpp", "a"));
    write("class/mallory.zip", "evil-" + how);
    write("class/zoe.zip", zip("conj_grad.cpp", "z"));
    const Intake intake = read_hostile(dir_ / "class");
    ASSERT_EQ(told(intake.submissions), (Names{"alice: conj=a", "mallory: !", "zoe: conj=z"}));
    EXPECT_TRUE(intake.submissions[1].unreadable);
    EXPECT_TRUE(says(intake.submissions[1].problem, "mallory.zip can't be read"));
    ASSERT_EQ(intake.notices.size(), 1U);
    EXPECT_TRUE(says(intake.notices[0], "class/mallory.zip: was not graded: mallory.zip can't be read"));
    EXPECT_TRUE(has_remark(intake, {"class/mallory.zip: the reader of mallory.zip " + end}));
  }
}

TEST_F(SandboxedReading, BreaksDownForItselfAloneInAnArchiveOfAClass) {
  const std::string bytes = ArchiveBuilder(Packing::zip)
                                .file("alice.zip", zip("conj_grad.cpp", "a"))
                                .file("mallory.zip", "evil-crash")
                                .file("zoe.zip", zip("handin.zip", zip("conj_grad.cpp", "z")))
                                .bytes();
  const Intake intake = read_hostile(write("class.zip", bytes));
  ASSERT_EQ(told(intake.submissions), (Names{"alice: conj=a", "mallory: !", "zoe: conj=z"}));
  EXPECT_TRUE(intake.submissions[1].unreadable);
}

// A class that can't be read whole is no reason for a 0.
TEST_F(SandboxedReading, MayBreakDownHalfway) {
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read_hostile(write("class.zip", "evil-half")); }),
                   "class.zip: nothing was graded: "));
}

TEST_F(SandboxedReading, SaysNothingThatIsNotAskedForOrPrinted) {
  limits_.file_bytes = 1000;
  const Submission more = attacked("evil-more");
  EXPECT_TRUE(more.files.empty() || more.files.at("conj_grad.cpp").text.empty());
  const std::string problem = attacked("evil-speech").problem;
  EXPECT_TRUE(problem.starts_with("?[2J<b>?? xxx") || problem.starts_with(" [2J<b> ? xxx"))
      << problem.substr(0, 20);
  EXPECT_LE(problem.size(), 1000u);
}

TEST_F(SandboxedReading, ReadsWhatOnlyItsCallerMay) {
  const fs::path archive = write("closed/alice.zip", zip("conj_grad.cpp", "a"));
  fs::permissions(archive, fs::perms::owner_read);
  fs::permissions(archive.parent_path(), fs::perms::owner_all);
  const SandboxedReader reader(HAIR_READER, isolation_for_tests());
  const Intake intake = read_submissions({archive}, two_exercises(), reader.opener());
  EXPECT_EQ(intake.submissions.at(0).files.at("conj_grad.cpp").text, "a");
}

TEST_F(SandboxedReading, ThatDoesNotStartIsNoStudentsFault) {
  const SandboxedReader none(write("no_reader", "#!/no/such/program"), isolation_for_tests());
  EXPECT_THROW(read_submissions({write("alice.zip", zip("conj_grad.cpp"))}, two_exercises(), none.opener()),
               std::runtime_error);
}

}  // namespace
}  // namespace grader::intake
