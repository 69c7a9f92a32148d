// STAFF ONLY. Tests that times are read in the forms of learning systems, each with its offset, and that
// other texts are no times.
#include "grader/text/time_text.h"

#include <gtest/gtest.h>

namespace grader::inline text {
namespace {

using namespace std::chrono;

TimeText at(int hour, int minute, int second, std::optional<minutes> offset = {}) {
  constexpr sys_days kDay = 2025y / March / 4;
  return {kDay.time_since_epoch() + hours(hour) + minutes(minute) + seconds(second), offset};
}

TEST(TimeText, IsReadInEachSystemsForm) {
  struct Row {
    const char* text;
    TimeText time;
  };
  for (const Row& row : {
           Row{"2025-03-04 10:15", at(10, 15, 0)},
           Row{"2025-03-04 10:15:22", at(10, 15, 22)},
           Row{" 2025-03-04  10:15:22 ", at(10, 15, 22)},
           Row{"2025-03-04T10:15:22", at(10, 15, 22)},
           Row{"2025-03-04T10:15:22Z", at(10, 15, 22, minutes(0))},
           Row{"2025-03-04 10:15:22 UTC", at(10, 15, 22, minutes(0))},
           Row{"2025-03-04 10:15:22.000000000 Z", at(10, 15, 22, minutes(0))},
           Row{"2025-03-04 10:15:22 -0800", at(10, 15, 22, -hours(8))},
           Row{"2025-03-04T10:15:22.123456-08:00", at(10, 15, 22, -hours(8))},
           Row{"2025-03-04T10:15:22+01", at(10, 15, 22, hours(1))},
           Row{"2025-03-04 10:15:22 +05:45", at(10, 15, 22, minutes(345))},
           Row{"2025-03-04 10:15:22 -03:30", at(10, 15, 22, -minutes(210))},
           Row{"March 4, 2025 1015 AM", at(10, 15, 0)},
           Row{"Mar 4, 2025 1215 AM", at(0, 15, 0)},
           Row{"Mar 4, 2025 12:15 pm", at(12, 15, 0)},
           Row{"Tuesday, 4 March 2025, 10:15 AM", at(10, 15, 0)},
           Row{"Tuesday, 4 March 2025, 10:15 PM", at(22, 15, 0)},
           Row{"4 Mar 2025, 22:15", at(22, 15, 0)},
           Row{"Dienstag, 4. März 2025, 10:15", at(10, 15, 0)},
           Row{"Dienstag, 04. März 2025, 22:15", at(22, 15, 0)},
           Row{"mardi 4 mars 2025, 10:15", at(10, 15, 0)},
           Row{"martes, 4 de marzo de 2025, 10:15", at(10, 15, 0)},
           Row{"2025年 03月 4日(火曜日) 10:15", at(10, 15, 0)},
           Row{"2025年03月04日 22:15", at(22, 15, 0)},
       }) {
    const std::optional<TimeText> found = read_time(row.text);
    ASSERT_TRUE(found) << row.text;
    EXPECT_EQ(found->clock, row.time.clock) << row.text;
    EXPECT_EQ(found->offset, row.time.offset) << row.text;
  }
}

// In each language every month is another one, and all languages agree.
TEST(TimeText, HasTwelveMonthsInEachLanguage) {
  const std::vector<std::vector<const char*>> languages = {
      {"January", "February", "March", "April", "May", "June", "July", "August", "September", "October",
       "November", "December"},
      {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"},
      {"Januar", "Februar", "März", "April", "Mai", "Juni", "Juli", "August", "September", "Oktober",
       "November", "Dezember"},
      {"janvier", "février", "mars", "avril", "mai", "juin", "juillet", "août", "septembre", "octobre",
       "novembre", "décembre"},
      {"enero", "febrero", "marzo", "abril", "mayo", "junio", "julio", "agosto", "septiembre", "octubre",
       "noviembre", "diciembre"}};
  for (const auto& months : languages)
    for (unsigned i = 0; i < 12; ++i) {
      const std::optional<TimeText> found = read_time("4 " + std::string(months[i]) + " 2025, 10:15");
      ASSERT_TRUE(found) << months[i];
      EXPECT_EQ(found->clock, sys_days(2025y / month(i + 1) / 4).time_since_epoch() + hours(10) + minutes(15))
          << months[i];
    }
}

TEST(TimeText, IsNothingForWhatIsNoTimeOrCouldBeTwo) {
  for (const char* text : {"",
                           "-",
                           "yesterday",
                           "2025-02-30 10:00",
                           "2025-03-04 24:00",
                           "2025-03-04 10:60",
                           "2025-03-04",
                           "3/4/2025 10:15",
                           "Mar 4, 2025 1315 PM",
                           "Mar 4, 2025 0015 AM",
                           "wtorek, 4 marca 2025, 10:15",
                           "utorak, 4. listopad 2025, 10:15",
                           "martes, 4 de marzo de 2025, 10:15 a. m.",
                           "4 mar. 2025, 10:15",
                           "mardi 31 février 2025, 10:15",
                           "2025年03月04日 下午 2:15",
                           "2025年 13月 4日(火曜日) 10:15",
                           "2025-03-04 10:15:22 +1",
                           "2025-03-04 10:15:22 +16:00",
                           "2025-03-04 10:15:22 PST",
                           "2025-03-04 10:15\n7"})
    EXPECT_FALSE(read_time(text)) << text;
}

}  // namespace
}  // namespace grader::text
