// STAFF ONLY. Tests Student with workers that break the rules: the answer is right, and comes soon, and its
// costs are charged. A recording is read back.
#include "grader/judge/student/student.h"

#include <gtest/gtest.h>

#include <fstream>

#include "grader/judge/student/recording.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/processes/identity.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline judge {
namespace {
namespace fs = std::filesystem;

class StudentTest : public testing::Test {
 protected:
  StudentTest() {
    share_with_sandbox(folder_, false);
    fs::create_directory(folder_ / "serve");
    fs::copy_file(HAIR_HOSTILE_WORKER, folder_ / "worker");
    std::ofstream(folder_ / "serve" / "X.so") << "nothing";
    for (const char* path : {"worker", "serve", "serve/X.so"})
      fs::permissions(folder_ / path, fs::perms(0755));
    allowance_->limit = share_of(Budget(), 10);
  }

  Student student(const std::string& way) {
    std::ofstream(folder_ / (way + ".so")) << "nothing";
    fs::permissions(folder_ / (way + ".so"), fs::perms(0755));
    WorkerSetup setup;
    setup.isolation = isolation_for_tests();
    setup.kit = folder_;
    setup.exercise = "X";
    setup.objects = {folder_ / (way + ".so")};
    setup.log = folder_ / "log";
    setup.cpu_seconds = 2;
    setup.allowance = allowance_;
    return Student(setup);
  }

  // Asks at most `times` times until the suite gives up, and returns the last answer.
  static Answer ask(Student& student, int times = 1) {
    Answer answer{Outcome::done, MessageReader({}), {}};
    for (int i = 0; i < times; ++i)
      answer = student.ask(MessageWriter(), [](int, const std::vector<double>& x, std::vector<double>& y) {
        y = x;
        return true;
      });
    return answer;
  }

  hair::TemporaryFolder temporary_{"student-test"};
  fs::path folder_ = temporary_.path();
  std::shared_ptr<Allowance> allowance_ = std::make_shared<Allowance>();
  const Budget& spent_ = allowance_->spent;
};

TEST_F(StudentTest, AnswersAndIsCharged) {
  Student student = this->student("right");
  EXPECT_EQ(ask(student, 50).outcome, Outcome::done);
  student.finish();
  EXPECT_EQ(student.starts(), 1);
  EXPECT_EQ(spent_.messages, 1 + 2 * 50);
  EXPECT_GT(spent_.worker_cpu_seconds, 0);
  EXPECT_GT(spent_.suite_cpu_seconds, 0);
  EXPECT_EQ(spent_.restarts, 0);
  EXPECT_LT(spent_.idle_seconds, 0.5);
}

TEST_F(StudentTest, EndsARequestAtItsFirstDeniedCall) {
  Student student = this->student("tries-calls");
  EXPECT_EQ(ask(student).outcome, Outcome::broke_rules);
  EXPECT_EQ(spent_.messages, 2);  // its greeting and this request
  EXPECT_EQ(ask(student).outcome, Outcome::broke_rules);
  EXPECT_EQ(student.starts(), 2);
}

TEST_F(StudentTest, StopsListeningToAFlood) {
  allowance_->limit.messages = 20000;
  Student student = this->student("floods");
  EXPECT_EQ(ask(student).outcome, Outcome::timed_out);
  EXPECT_EQ(student.gave_up()->note, "used up: messages");
  EXPECT_NEAR(spent_.messages, 20000, 2);
}

TEST_F(StudentTest, SpendsNoMoreOnAFloodThanThereIs) {
  allowance_->limit.suite_cpu_seconds = 0.05;
  Student student = this->student("floods");
  EXPECT_EQ(ask(student).outcome, Outcome::timed_out);
  EXPECT_LT(spent_.suite_cpu_seconds, 0.2);
}

TEST_F(StudentTest, IsStartedAgainUntilItsRestartsAreUsedUp) {
  Student student = this->student("crashes");
  const Answer last = ask(student, 20);
  EXPECT_EQ(last.outcome, Outcome::crashed);
  EXPECT_EQ(last.note, "used up: restarts");
  EXPECT_EQ(student.starts(), 1 + static_cast<int>(allowance_->limit.restarts));
}

// A worker that idles in each of its starts idles in all no longer than one that never wakes up. On a busy
// machine a part of a nap of 0.15 s is a wait for a processor: there it takes more naps.
TEST_F(StudentTest, IdlesNoLongerInSeveralStarts) {
  allowance_->limit.restarts = 1000;
  allowance_->limit.worker_cpu_seconds = 1000;
  allowance_->limit.idle_seconds = 1;
  Student student = this->student("naps-and-crashes");
  ask(student, 500);
  ASSERT_TRUE(student.gave_up());
  EXPECT_EQ(student.gave_up()->note, "used up: idle time");
}

TEST_F(StudentTest, IsEndedTwiceWhenItSleeps) {
  Student student = this->student("sleeps");
  allowance_->limit.idle_seconds = 1;
  EXPECT_EQ(ask(student, 5).outcome, Outcome::timed_out);
  EXPECT_EQ(student.starts(), 2);
  EXPECT_LT(spent_.idle_seconds, 1.8);
}

TEST_F(StudentTest, IsEndedByTheClockWhateverItDoes) {
  for (const char* way : {"sleeps", "floods"}) {
    *allowance_ = {share_of(Budget(), 10)};
    allowance_->limit.idle_seconds = allowance_->limit.suite_cpu_seconds = allowance_->limit.messages = 1e9;
    allowance_->limit.worker_cpu_seconds = allowance_->limit.megabytes = 1e9;
    allowance_->limit.wall_seconds = 0.5;
    Student student = this->student(way);
    EXPECT_EQ(ask(student, 5).outcome, Outcome::timed_out) << way;
    EXPECT_GT(spent_.wall_seconds, allowance_->limit.wall_seconds) << way << " is not listed";
    EXPECT_EQ(student.starts(), 1) << way;
  }
}

// A slow end is allowed, but it is charged.
TEST_F(StudentTest, PaysForItsSlowEnd) {
  Student student = this->student("leaves-late");
  EXPECT_EQ(ask(student).outcome, Outcome::done);
  student.finish();
  EXPECT_GT(spent_.idle_seconds, 0.3);
}

TEST_F(StudentTest, KeepsToTheProtocol) {
  for (const char* way : {"huge", "another-nonce", "speaks-first"}) {
    Student student = this->student(way);
    EXPECT_EQ(ask(student).outcome, Outcome::broke_rules) << way;
  }
  allowance_->limit.idle_seconds = 1;
  Student half = student("half");
  EXPECT_EQ(ask(half).outcome, Outcome::timed_out);
}

const MessageReader kNoReply({});

MessageWriter numbers(std::size_t bytes) {
  MessageWriter message;
  message.put(std::span<const double>(std::vector<double>(bytes / sizeof(double))));
  return message;
}

TEST(Recording, HoldsRequestsWithTheirProducts) {
  Recording recording;
  recording.begin(numbers(16));
  recording.add_product(1, {}, {1, 2}, true);
  recording.add_product(0, {}, {}, false);
  recording.end(Outcome::stopped, kNoReply);
  ASSERT_EQ(recording.requests().size(), 1u);
  const Recording::Request& request = recording.requests()[0];
  EXPECT_EQ(request.message.bytes().size(), numbers(16).bytes().size());
  ASSERT_EQ(request.products.size(), 2u);
  EXPECT_EQ(request.products[0].which, 1);
  EXPECT_EQ(request.products[0].result, (std::vector<double>{1, 2}));
  EXPECT_TRUE(request.products[0].go_on);
  EXPECT_FALSE(request.products[1].go_on);
}

TEST(Recording, HoldsSoMuchAndSaysThatItIsCut) {
  Recording recording(Recording::Keeps::last_case);
  const std::vector<double> quarter(Recording::kMostBytes / 4 / sizeof(double));
  recording.begin_case();
  recording.begin(numbers(Recording::kMostBytes / 4 - 100));
  for (int i = 0; i < 2; ++i) recording.add_product(0, {}, quarter, true);
  EXPECT_FALSE(recording.is_cut());
  recording.add_product(0, quarter, quarter, true);
  recording.end(Outcome::done, kNoReply);
  recording.begin(numbers(Recording::kMostBytes / 2));
  EXPECT_TRUE(recording.is_cut());
  ASSERT_EQ(recording.requests().size(), 1u);
  EXPECT_EQ(recording.requests()[0].products.size(), 2u);
  recording.begin_case();
  EXPECT_FALSE(recording.is_cut());
}

}  // namespace
}  // namespace grader::judge
