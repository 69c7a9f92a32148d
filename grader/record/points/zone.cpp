// STAFF ONLY. Converts times with the tz library, whose names C++20 took over: this compiler's standard
// library has no zones yet.
#include "grader/record/points/zone.h"

#include <date/tz.h>

#include <stdexcept>

namespace grader::inline record {

using namespace std::chrono;

bool is_zone(const std::string& name) {
  if (name == "localtime") return false;
  try {
    date::locate_zone(name);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

sys_seconds moment_of(const TimeText& time, const std::string& zone, Twice twice) {
  if (zone.empty()) return sys_seconds(time.clock);
  if (time.offset) return sys_seconds(time.clock - *time.offset);
  return date::locate_zone(zone)->to_sys(date::local_seconds(time.clock), twice == Twice::earlier
                                                                              ? date::choose::earliest
                                                                              : date::choose::latest);
}

seconds on_clock_of(const TimeText& time, const std::string& zone) {
  if (zone.empty() || !time.offset) return time.clock;
  return date::locate_zone(zone)->to_local(sys_seconds(time.clock - *time.offset)).time_since_epoch();
}

std::string shown_on_clock_of(const TimeText& time, const std::string& zone) {
  return date::format("%F %T", date::local_seconds(on_clock_of(time, zone)));
}

}  // namespace grader::record
