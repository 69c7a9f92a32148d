// Numbers in texts have a decimal point in every locale.
#pragma once

#include <locale.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

namespace solver {

// While this object lives, the C library's functions (strtod, snprintf, ...) read and write numbers with a
// point in this thread. setlocale has no effect on this thread then, only on others.
class DecimalPoint {
 public:
  DecimalPoint() : before_(uselocale(plain())) {}
  ~DecimalPoint() { uselocale(before_); }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  static locale_t plain() {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }
  locale_t before_;
};

}  // namespace solver
