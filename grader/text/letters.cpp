// STAFF ONLY. Handles letters by Unicode's tables, from utf8proc.
#include "grader/text/letters.h"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <memory>

#include "hair/io/plot/readable.h"

namespace grader::inline text {
namespace {

const utf8proc_uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const utf8proc_uint8_t*>(text.data());
}

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string mapped(std::string_view text, int options) {
  if (!is_stream_safe(text)) return std::string(text);
  utf8proc_uint8_t* result = nullptr;
  const utf8proc_ssize_t size = utf8proc_map(bytes_of(text), static_cast<utf8proc_ssize_t>(text.size()),
                                             &result, static_cast<utf8proc_option_t>(options));
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(result, &std::free);
  if (size < 0) return std::string(text);
  return {reinterpret_cast<const char*>(result), static_cast<std::size_t>(size)};
}

struct Letter {
  utf8proc_int32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;  // false: a byte that is no UTF-8
};

Letter first_letter(std::string_view text) {
  Letter letter;
  const utf8proc_ssize_t size =
      utf8proc_iterate(bytes_of(text), static_cast<utf8proc_ssize_t>(text.size()), &letter.code);
  return size <= 0 ? Letter() : Letter{letter.code, static_cast<std::size_t>(size), true};
}

std::size_t columns_of(const Letter& letter) {
  return letter.valid ? static_cast<std::size_t>(utf8proc_charwidth(letter.code)) : 1;
}

// Visits letters up to the first byte that is no UTF-8.
void each_letter(std::string_view text, const std::function<void(utf8proc_int32_t)>& take) {
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    if (!letter.valid) return;
    take(letter.code);
    text.remove_prefix(letter.bytes);
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

// U+0F73 is a mark, too: its own combining class is 0, but its parts have others.
bool is_mark(utf8proc_int32_t letter) {
  const utf8proc_category_t kind = utf8proc_category(letter);
  return kind >= UTF8PROC_CATEGORY_MN && kind <= UTF8PROC_CATEGORY_ME;
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
  return mapped(line, UTF8PROC_STABLE | UTF8PROC_COMPOSE);
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

std::string without_unseen(std::string_view text) {
  return is_ascii(text) ? std::string(text)
                        : mapped(hair::readable(text), UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_IGNORE);
}

bool is_utf8(std::string_view bytes) {
  return hair::valid_utf8(bytes) == bytes;
}

bool is_stream_safe(std::string_view text) {
  constexpr int kMostMarks = 30;
  int marks = 0, most = 0;
  each_letter(text, [&](utf8proc_int32_t letter) {
    marks = is_mark(letter) ? marks + 1 : 0;
    most = std::max(most, marks);
  });
  return most <= kMostMarks;
}

std::string composed_path(std::string_view path) {
  return is_ascii(path) ? std::string(path) : mapped(path, UTF8PROC_STABLE | UTF8PROC_COMPOSE);
}

std::string without_marks(std::string_view name) {
  if (is_ascii(name)) return std::string(name);
  return mapped(mapped(name, UTF8PROC_STABLE | UTF8PROC_DECOMPOSE | UTF8PROC_STRIPMARK),
                UTF8PROC_STABLE | UTF8PROC_COMPOSE);
}

bool has_word(std::string_view text, std::string_view word) {
  const auto is_of_word = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if (!is_of_word(at - 1) && !is_of_word(at + word.size())) return true;
  return false;
}

std::string legible(std::string_view text, std::size_t most) {
  constexpr char digits[] = "0123456789abcdef";
  std::string line;
  while (!text.empty()) {
    if (line.size() >= most) return line + "...";
    const Letter letter = first_letter(text);
    const utf8proc_category_t kind = letter.valid ? utf8proc_category(letter.code) : UTF8PROC_CATEGORY_CN;
    const bool seen = kind != UTF8PROC_CATEGORY_CC && kind != UTF8PROC_CATEGORY_CF &&
                      kind != UTF8PROC_CATEGORY_CS && kind != UTF8PROC_CATEGORY_CN &&
                      kind != UTF8PROC_CATEGORY_CO && kind != UTF8PROC_CATEGORY_ZL &&
                      kind != UTF8PROC_CATEGORY_ZP;
    for (const char c : text.substr(0, letter.bytes)) {
      if (seen)
        line += c;
      else
        line += {'\\', 'x', digits[static_cast<unsigned char>(c) >> 4], digits[c & 15]};
    }
    text.remove_prefix(letter.bytes);
  }
  return line;
}

std::size_t terminal_columns(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    columns += columns_of(letter);
    text.remove_prefix(letter.bytes);
  }
  return columns;
}

std::string first_columns(std::string_view text, std::size_t most) {
  std::size_t columns = 0, length = 0;
  while (length < text.size()) {
    const Letter letter = first_letter(text.substr(length));
    columns += columns_of(letter);
    if (columns > most) break;
    length += letter.bytes;
  }
  return std::string(text.substr(0, length));
}

}  // namespace grader::text
