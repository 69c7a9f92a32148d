// STAFF ONLY. The clock of the course's place. Its zone is a name of the IANA's list, "Europe/Berlin"; the
// machine's tzdata has the rules. A time that is written without an offset is one of this clock.
//
// When the clock is set back, an hour comes twice; when it is set forward, one is missing. A time of the
// course's clock in such an hour is what is better for the student: a due date the later moment, a hand-in
// the earlier one.
#pragma once

#include <chrono>
#include <string>

#include "grader/text/time_text.h"

namespace grader::inline record {

bool is_zone(const std::string& name);  // the machine's own, "localtime", is none

enum class Twice { earlier, later };

// `zone` is one, or "": then offsets are not looked at, and all times are of one clock without changes.
std::chrono::sys_seconds moment_of(const TimeText& time, const std::string& zone, Twice twice);
std::chrono::seconds on_clock_of(const TimeText& time, const std::string& zone);  // as TimeText::clock

// "2025-03-04 10:15:22", as that clock shows it.
std::string shown_on_clock_of(const TimeText& time, const std::string& zone);

}  // namespace grader::record
