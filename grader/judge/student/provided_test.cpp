// STAFF ONLY. Tests that a worker that breaks the protocol of provided functions ends its request, and not
// the suite.
#include "grader/judge/student/provided.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "grader/judge/student/student.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;

class Provided : public testing::Test {
 protected:
  Provided() {
    fs::permissions(folder_, fs::perms(0755));
    signal(SIGPIPE, SIG_IGN);
    fs::create_directories(folder_ / "serve");
    fs::create_directories(folder_ / "provided");
    fs::copy(HAIR_HOSTILE_CALLER, folder_ / "worker");
    for (const char* file : {"serve/X.so", "provided/S1.so", "provided/H5.so"})
      std::ofstream(folder_ / file) << "";
  }
  // Asks twice, to see that the suite goes on after the first answer.
  Outcome outcome(const std::string& how) {
    allowance_ = std::make_shared<Allowance>();
    WorkerSetup setup;
    setup.allowance = allowance_;
    setup.kit = folder_;
    setup.exercise = "X";
    setup.provided = {"S1", "H5"};
    setup.objects = {folder_ / (how + ".so")};
    setup.log = folder_ / "log";
    setup.isolation = Isolation::none;
    setup.allowance->limit.messages = 2000;
    std::ofstream(setup.objects[0]) << "";
    Student student(setup);
    const auto no_products = [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator"); };
    const Outcome first = student.ask({}, no_products).outcome;
    EXPECT_EQ(student.ask({}, no_products).outcome, first) << how << " the second time";
    return first;
  }

  hair::TemporaryFolder temporary_{"provided-test"};
  fs::path folder_ = temporary_.path();
  std::shared_ptr<Allowance> allowance_;  // belongs to the last worker
};

TEST_F(Provided, RefusesWhatMakesNoSense) {
  for (const char* how :
       {"calls-what-is-not-provided", "calls-what-is-not-there", "calls-before-the-first",
        "has-fewer-numbers-than-unknowns", "has-less-than-no-unknowns", "calls-in-callbacks-forever",
        "throws-unasked", "answers-unasked", "answers-with-another-length", "is-done-in-a-callback"})
    EXPECT_EQ(outcome(how), Outcome::broke_rules) << how;
}

TEST_F(Provided, GoesOnAfterACallbackThatEnds) {
  EXPECT_EQ(outcome("exits-in-a-callback"), Outcome::crashed);
  EXPECT_EQ(outcome("throws-in-a-callback"), Outcome::threw);
}

TEST_F(Provided, ComputesNoLongerThanItMay) {
  EXPECT_EQ(outcome("solves-forever"), Outcome::timed_out);
  EXPECT_GT(allowance_->spent.messages, allowance_->limit.messages) << "it ended for another reason";
  EXPECT_EQ(outcome("sweeps-forever"), Outcome::done);
  EXPECT_LT(allowance_->spent.suite_cpu_seconds, 5) << "two calls";
}

}  // namespace
}  // namespace grader::judge
