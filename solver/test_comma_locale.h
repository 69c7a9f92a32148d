// For tests: numbers with a decimal comma and dots between thousands, in the C library and in new streams,
// like a program with the user's locale in Germany.
#pragma once

#include <locale.h>
#include <stdlib.h>

#include <cstdio>
#include <locale>
#include <string>

namespace solver {

class CommaLocale {
 public:
  // The locale is made below `folder`, if Debian's package locales is installed.
  explicit CommaLocale(const std::string& folder)
      : before_(std::locale::global(std::locale(std::locale::classic(), new Comma))) {
    const std::string make = "localedef -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8' >/dev/null 2>&1";
    if (std::system(make.c_str()) != 0) return;
    setenv("LOCPATH", folder.c_str(), 1);
    setlocale(LC_NUMERIC, "de_DE.UTF-8");
    unsetenv("LOCPATH");
  }
  ~CommaLocale() {
    std::locale::global(before_);
    setlocale(LC_ALL, "C");
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  // True if the C library has it, too.
  bool is_everywhere() const {
    char text[16];
    std::snprintf(text, sizeof text, "%.1f", 1.5);
    return text[1] == ',';
  }

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale before_;
};

}  // namespace solver
