// STAFF ONLY. A time as others write it, on some clock and perhaps with that clock's offset:
//
//   2025-03-04 10:15, 2025-03-04 10:15:22                 Blackboard, Brightspace (from its layout), people
//   2025-03-04 10:15:22 -0800, 2025-03-04 10:15:22.0 Z    Gradescope's tables and its export
//   2025-03-04T10:15:22Z, 2025-03-04T10:15:22+01:00       ISO 8601: Canvas, GitHub Classroom
//   May 18, 2025 1224 PM                                  Brightspace
//   Tuesday, 4 March 2025, 10:15 AM                       Moodle in English; the day's name is ignored
//   Dienstag, 4. März 2025, 10:15                         Moodle in German
//   mardi 4 mars 2025, 10:15                              in French
//   martes, 4 de marzo de 2025, 10:15                     in Spanish
//   2025年 03月 4日(火曜日) 10:15                          in Japanese
//
// Other languages are not guessed: a word may be one month here and another one there ("listopad"), or mean
// that an hour is past noon.
#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace grader::inline text {

struct TimeText {
  std::chrono::seconds clock{};                     // is the clock's time, since 1970-01-01 00:00 on it
  std::optional<std::chrono::minutes> offset = {};  // clock - offset is UTC

  bool operator==(const TimeText&) const = default;
};

// Returns nothing for any other form, and for an impossible day or hour. Parts of a second are left out.
std::optional<TimeText> read_time(std::string_view text);

}  // namespace grader::text
