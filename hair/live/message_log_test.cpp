#include "hair/live/message_log.h"

#include <gtest/gtest.h>

namespace hair {
namespace {

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

}  // namespace
}  // namespace hair
