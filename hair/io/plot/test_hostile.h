// Texts that break careless code.
#pragma once

#include <string>
#include <vector>

namespace hair::plot {

inline std::vector<std::string> hostile_texts() {
  return {
      "</title><script>alert(1)</script>",
      "\" onload=\"alert(1)",
      "' onload='alert(1)",
      "a & b &amp; &nosuch; &#0;",
      "]]> <![CDATA[ <!-- -->",
      std::string("nul \0 bell \a escape \x1b[31m", 22),
      "carriage return \r and line\nfeed",
      "overlong \xC0\xAF, \xE0\x80\xAF, \xF0\x80\x80\xAF",
      "surrogate \xED\xA0\x80, beyond \xF4\x90\x80\x80, no character \xEF\xBF\xBF",
      "cut \xE2\x82",
      "lone \xBF\xFF\xFE",
      "C1 controls \xC2\x80\xC2\x9F",
      std::string(2000, 'W'),
      std::string(500, '\xFF'),
      "",
      "   ",
  };
}

}  // namespace hair::plot
