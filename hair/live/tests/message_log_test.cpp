#include "hair/live/message_log.h"

#include <gtest/gtest.h>

namespace hair {
namespace {

using std::chrono::milliseconds;

TEST(MessageLog, GivesAReaderWhoComesLateTheWholeRun) {
  MessageLog log;
  log.begin("first");
  log.add("second");
  MessageLog::Place place;
  EXPECT_EQ(*log.next(place, milliseconds(0)), "first");
  EXPECT_EQ(*log.next(place, milliseconds(0)), "second");
  EXPECT_EQ(log.next(place, milliseconds(0)), nullptr);
}

TEST(MessageLog, TakesReadersToTheNextRun) {
  MessageLog log;
  log.begin("old");
  log.add("not read any more");
  MessageLog::Place place;
  EXPECT_EQ(*log.next(place, milliseconds(0)), "old");
  log.begin("new");
  EXPECT_EQ(*log.next(place, milliseconds(0)), "new");
  EXPECT_EQ(log.next(place, milliseconds(0)), nullptr);
}

TEST(MessageLog, LetsNobodyWaitWhenItIsClosed) {
  MessageLog log;
  log.begin("first");
  log.close();
  MessageLog::Place place;
  EXPECT_EQ(log.next(place, std::chrono::hours(1)), nullptr);
  EXPECT_TRUE(log.closed());
}

}  // namespace
}  // namespace hair
