// STAFF ONLY. Letters by Unicode's tables, which utf8proc has.
#include "grader/text/letters.h"

#include <utf8proc.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <memory>

#include "hair/io/plot/readable.h"

namespace grader {
namespace {

// `text` is well-formed.
void each_letter(const std::string& text, const std::function<void(utf8proc_int32_t)>& take) {
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
  for (std::size_t at = 0; at < text.size();) {
    utf8proc_int32_t letter = 0;
    const utf8proc_ssize_t size =
        utf8proc_iterate(bytes + at, static_cast<utf8proc_ssize_t>(text.size() - at), &letter);
    if (size <= 0) return;
    at += static_cast<std::size_t>(size);
    take(letter);
  }
}

void append(std::string& text, utf8proc_int32_t letter) {
  std::array<utf8proc_uint8_t, 4> bytes;
  text.append(bytes.begin(), bytes.begin() + utf8proc_encode_char(letter, bytes.data()));
}

bool is_blank(utf8proc_int32_t letter) {
  const utf8proc_category_t kind = utf8proc_category(letter);
  return kind == UTF8PROC_CATEGORY_ZS || kind == UTF8PROC_CATEGORY_CC || kind == UTF8PROC_CATEGORY_ZL ||
         kind == UTF8PROC_CATEGORY_ZP;
}

bool is_of_words(utf8proc_int32_t letter) {
  const utf8proc_category_t kind = utf8proc_category(letter);
  return (kind >= UTF8PROC_CATEGORY_LU && kind <= UTF8PROC_CATEGORY_NO) || kind == UTF8PROC_CATEGORY_PC;
}

}  // namespace

std::string composed(std::string_view name) {
  std::string line;
  bool blank = false;
  each_letter(hair::readable(name), [&](utf8proc_int32_t letter) {
    if (is_blank(letter)) {
      blank = !line.empty();
      return;
    }
    if (blank) line += ' ';
    blank = false;
    append(line, letter);
  });
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> form(
      utf8proc_NFC(reinterpret_cast<const utf8proc_uint8_t*>(line.c_str())), &std::free);
  return form ? reinterpret_cast<const char*>(form.get()) : line;
}

std::string squeezed(std::string_view name) {
  std::string text;
  each_letter(composed(name), [&](utf8proc_int32_t letter) {
    if (is_of_words(letter)) append(text, utf8proc_tolower(letter));
  });
  return text;
}

std::string lowered(std::string_view name) {
  std::string text;
  each_letter(composed(name), [&](utf8proc_int32_t letter) { append(text, utf8proc_tolower(letter)); });
  return text;
}

}  // namespace grader
