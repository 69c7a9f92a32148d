// STAFF ONLY. The clock of the course's place. Its zone is a name of the IANA's list, "Europe/Berlin"; the
// machine's tzdata has the rules. A time without an offset is on this clock.
//
// When the clock is set back, an hour comes twice; when it is set forward, one is missing. A time in such an
// hour is taken in the student's favour: a due date as the later moment, a hand-in as the earlier one.
#pragma once

#include <chrono>
#include <string>

#include "grader/text/time_text.h"

namespace grader::inline record {

bool is_zone(const std::string& name);  // the machine's own, "localtime", is no zone

enum class Twice { earlier, later };

// `zone` is one, or "": then offsets are ignored, and all times are on one clock without changes.
std::chrono::sys_seconds moment_of(const TimeText& time, const std::string& zone, Twice twice);
std::chrono::seconds on_clock_of(const TimeText& time, const std::string& zone);  // is like TimeText::clock

// Writes "2025-03-04 10:15:22", as that clock shows it.
std::string shown_on_clock_of(const TimeText& time, const std::string& zone);

}  // namespace grader::record
