// STAFF ONLY. Reads times.
#include "grader/text/time_text.h"

#include <algorithm>
#include <array>
#include <regex>
#include <string>

#include "grader/text/letters.h"

namespace grader::inline text {
namespace {

using namespace std::chrono;

std::optional<unsigned> month_of(std::string name) {
  using Names = std::array<std::string_view, 4>;  // English, German, French, Spanish
  constexpr std::array<Names, 12> kMonths{Names{"january", "januar", "janvier", "enero"},
                                          {"february", "februar", "février", "febrero"},
                                          {"march", "märz", "mars", "marzo"},
                                          {"april", "april", "avril", "abril"},
                                          {"may", "mai", "mai", "mayo"},
                                          {"june", "juni", "juin", "junio"},
                                          {"july", "juli", "juillet", "julio"},
                                          {"august", "august", "août", "agosto"},
                                          {"september", "september", "septembre", "septiembre"},
                                          {"october", "oktober", "octobre", "octubre"},
                                          {"november", "november", "novembre", "noviembre"},
                                          {"december", "dezember", "décembre", "diciembre"}};
  name = lowered(name);
  for (unsigned i = 0; i < kMonths.size(); ++i)
    if (std::ranges::count(kMonths[i], name) > 0 || name == kMonths[i][0].substr(0, 3)) return i + 1;
  return {};
}

struct Parts {
  int year = 0;
  unsigned month = 0, day = 0;
  int hour = 0, minute = 0, second = 0;

  std::optional<seconds> clock() const {
    const year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
    if (!date.ok() || hour > 23 || minute > 59 || second > 60) return {};
    return sys_days(date).time_since_epoch() + hours(hour) + minutes(minute) + seconds(std::min(second, 59));
  }
};

// 12 AM is midnight, 12 PM noon. Returns nothing for 13 PM.
std::optional<int> hour_of(int shown, std::string half) {
  half = lowered(half);
  if (half.empty()) return shown;
  if (shown < 1 || shown > 12) return {};
  return shown % 12 + (half == "pm" ? 12 : 0);
}

std::optional<TimeText> iso(const std::smatch& found) {
  const auto number = [&](std::size_t part) { return found[part].matched ? std::stoi(found[part]) : 0; };
  const Parts parts{
      number(1), static_cast<unsigned>(number(2)), static_cast<unsigned>(number(3)), number(4), number(5),
      number(6)};
  const std::optional<seconds> clock = parts.clock();
  if (!clock) return {};
  TimeText time{*clock};
  if (found[7].matched) time.offset = minutes(0);
  if (found[8].matched) {
    if (number(9) > 15 || number(10) > 59) return {};
    time.offset = (hours(number(9)) + minutes(number(10))) * (found[8] == "-" ? -1 : 1);
  }
  return time;
}

std::optional<TimeText> in_words(const std::string& year, std::optional<unsigned> month,
                                 const std::string& day, const std::string& hour, const std::string& minute,
                                 const std::string& half) {
  const std::optional<int> shown = hour_of(std::stoi(hour), half);
  if (!month || !shown) return {};
  const std::optional<seconds> clock =
      Parts{std::stoi(year), *month, static_cast<unsigned>(std::stoi(day)), *shown, std::stoi(minute)}
          .clock();
  return clock ? std::optional(TimeText{*clock}) : std::nullopt;
}

}  // namespace

std::optional<TimeText> read_time(std::string_view text) {
  static const std::regex kIso(
      "(\\d{4})-(\\d\\d)-(\\d\\d)[T ](\\d\\d):(\\d\\d)(?::(\\d\\d)(?:[.,]\\d{1,12})?)?"
      "(?: ?(Z|UTC)| ?([+-])(\\d\\d)(?::?(\\d\\d))?)?");
  static const std::regex kMonthFirst(
      "([A-Za-z]{3,9}) (\\d{1,2}), (\\d{4}),? (\\d{1,2}):?(\\d\\d) ?([AaPp][Mm])");
  static const std::regex kDayFirst(
      "(?:[^,\\d]{1,30},? )?(\\d{1,2})\\.? (?:de )?([^\\s\\d.,]{3,12}) (?:de )?(\\d{4}), "
      "(\\d{1,2}):(\\d\\d)(?: ?([AaPp][Mm]))?");
  static const std::regex kJapanese(
      "(\\d{4})年 ?(\\d{1,2})月 ?(\\d{1,2})日 ?(?:\\((?:月|火|水|木|金|土|日)(?:曜日)?\\))? "
      "(\\d{1,2}):(\\d\\d)");
  constexpr std::size_t kLongest = 100;
  if (text.size() > kLongest) return {};
  const std::string line = composed(text);
  std::smatch found;
  if (std::regex_match(line, found, kIso)) return iso(found);
  if (std::regex_match(line, found, kMonthFirst))
    return in_words(found[3], month_of(found[1]), found[2], found[4], found[5], found[6]);
  if (std::regex_match(line, found, kDayFirst))
    return in_words(found[3], month_of(found[2]), found[1], found[4], found[5], found[6]);
  if (std::regex_match(line, found, kJapanese))
    return in_words(found[1], static_cast<unsigned>(std::stoi(found[2])), found[3], found[4], found[5], "");
  return {};
}

}  // namespace grader::text
