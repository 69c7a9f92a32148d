// The parts of `hairlab live` that run no program: the hand, the log of messages, the program's file.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "hair/io/files/temporary_folder.h"
#include "hair/live/hand.h"
#include "hair/live/message_log.h"
#include "hair/live/program_file.h"

namespace hair {
namespace {

TEST(Hand, ReachesItsGoalAndIsNeverTooFast) {
  const Vector3d pivot(0, 0, 1), tip(kHandReach, 0, 1);
  for (const Vector3d& goal : {Vector3d(1, 0, -0.5), Vector3d(0, 0, 0)})  // the second one only turns
    for (const double h : {1.0 / 30, 1.0 / 240, 1.0 / 3840}) {
      Hand hand(pivot);
      EXPECT_EQ(hand.after(h)(tip), tip);
      hand.go_to(goal, M_PI / 2);
      hand.go_to(Vector3d(NAN, 0, 0), 1e300);  // is ignored
      Way way, before{Eigen::Quaterniond::Identity(), pivot, pivot};
      for (double t = 0; t < 2; t += h, before = way) {
        way = hand.after(h);
        EXPECT_LE((way(pivot) - before(pivot)).norm(), (1 + 1e-12) * kFastestHand * h);
        // It moves and turns; each has its part of the speed, and the tip has both.
        EXPECT_LE((way(tip) - before(tip)).norm(), std::sqrt(2) * kFastestHand * h);
      }
      EXPECT_NEAR((way(pivot) - pivot - goal).norm(), 0, 1e-6) << h;
      EXPECT_NEAR((way(tip) - (pivot + goal + Vector3d(0, kHandReach, 0))).norm(), 0, 1e-6) << "a quarter";
    }
}

using std::chrono::milliseconds;

std::string next(const MessageLog& log, MessageLog::Place& place) {
  const MessageLog::Message message = log.next(place, milliseconds(0));
  return message ? *message : "nothing";
}

TEST(MessageLog, GivesAReaderWhoComesLateTheWholeRun) {
  MessageLog log;
  log.begin("first");
  log.add("second");
  MessageLog::Place place;
  EXPECT_EQ(next(log, place), "first");
  EXPECT_EQ(next(log, place), "second");
  EXPECT_EQ(next(log, place), "nothing");
}

TEST(MessageLog, KeepsTheBeginAndTheNewestOfALongRun) {
  MessageLog log;
  log.begin("0");
  MessageLog::Place early;
  EXPECT_EQ(next(log, early), "0");
  const int last = 3000;
  for (int i = 1; i <= last; ++i) log.add(std::to_string(i));
  MessageLog::Place late;
  EXPECT_EQ(next(log, late), "0");
  for (MessageLog::Place* place : {&early, &late}) EXPECT_EQ(next(log, *place), "1");
  for (int i = last - static_cast<int>(kNewestKept) + 1; i <= last; ++i)
    for (MessageLog::Place* place : {&early, &late}) ASSERT_EQ(next(log, *place), std::to_string(i));
  EXPECT_EQ(next(log, late), "nothing");
}

TEST(MessageLog, TakesReadersToTheNextRun) {
  MessageLog log;
  log.begin("old");
  log.add("not read any more");
  MessageLog::Place place;
  EXPECT_EQ(next(log, place), "old");
  log.begin("new");
  EXPECT_EQ(next(log, place), "new");
  EXPECT_EQ(next(log, place), "nothing");
}

TEST(MessageLog, LetsNobodyWaitWhenItIsClosed) {
  MessageLog log;
  log.begin("first");
  log.close();
  MessageLog::Place place;
  EXPECT_EQ(log.next(place, std::chrono::hours(1)), nullptr);
  EXPECT_TRUE(log.closed());
}

namespace fs = std::filesystem;

TEST(ProgramFile, IsNewOnceWhenItWasBuiltAnewAndNoLongerChanges) {
  const TemporaryFolder folder("hair-live");
  const fs::path path = folder.path() / "program";
  const auto build = [&](int seconds) {
    std::ofstream(path) << seconds;
    fs::permissions(path, fs::perms::owner_all);
    fs::last_write_time(path, fs::file_time_type() + std::chrono::seconds(seconds));
  };
  const auto looks_new = [](ProgramFile& file) {
    int times = 0;
    for (int i = 0; i < 20; ++i) times += file.is_new() ? 1 : 0;
    return times;
  };
  build(1);
  ProgramFile file(path);
  EXPECT_EQ(looks_new(file), 0);
  build(2);
  EXPECT_FALSE(file.is_new()) << "it may be half written";
  build(3);
  EXPECT_FALSE(file.is_new()) << "it changed again";
  EXPECT_EQ(looks_new(file), 1);
  fs::remove(path);
  EXPECT_EQ(looks_new(file), 0) << "the linker has taken it away";
  build(4);
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(looks_new(file), 0) << "it can't be started yet";
  fs::permissions(path, fs::perms::owner_all);
  EXPECT_EQ(looks_new(file), 1);
}

}  // namespace
}  // namespace hair
