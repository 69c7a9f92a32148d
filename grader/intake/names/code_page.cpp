// STAFF ONLY. Guesses the code page of names.
#include "grader/intake/names/code_page.h"

#include <utf8proc.h>

#include <array>
#include <optional>
#include <string_view>

#include "grader/text/encoding.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

bool is_latin(utf8proc_int32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_accented(utf8proc_int32_t c) {
  return c >= 0xc0 && c <= 0x17f && c != 0xd7 && c != 0xf7;
}

bool is_capital(utf8proc_int32_t c) {
  return (c >= 'A' && c <= 'Z') || (c >= 0xc0 && c <= 0xde);
}

bool is_east_asian(utf8proc_int32_t c) {
  return (c >= 0x3041 && c <= 0x30fe) || (c >= 0x4e00 && c <= 0x9fff);
}

// Rates how much a text looks like a name: accented letters stand among Latin ones, ideograms together.
double likeness(std::string_view text) {
  double sum = 0;
  utf8proc_int32_t before = ' ';
  while (!text.empty()) {
    utf8proc_int32_t c = 0, after = ' ';
    const auto at = [&](std::size_t from, utf8proc_int32_t* letter) {
      return utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()) + from,
                              static_cast<utf8proc_ssize_t>(text.size() - from), letter);
    };
    const auto size = static_cast<std::size_t>(at(0, &c));
    if (size < text.size()) at(size, &after);
    text.remove_prefix(size);
    if (c >= 0x80) {
      const bool in_a_word = is_latin(before) || is_latin(after);
      if (is_accented(c)) {
        sum += in_a_word ? 1 : -0.5;
        if (is_capital(c) && is_latin(before) && !is_capital(before)) sum -= 1.5;
      } else if (is_east_asian(c)) {
        sum += in_a_word ? -2 : 1.5;
      } else {
        sum -= 2;
      }
    }
    before = c;
  }
  return sum;
}

}  // namespace

std::string decode_names(std::vector<std::string>& names) {
  std::vector<std::string*> unknown;
  for (std::string& name : names)
    if (!is_utf8(name)) unknown.push_back(&name);
  if (unknown.empty()) return {};
  // The last code page takes any bytes.
  constexpr std::array<const char*, 5> kPages{"CP1252", "CP437", "GB18030", "SHIFT_JIS", "ISO-8859-1"};
  std::string best;
  double best_sum = 0;
  std::vector<std::string> best_names;
  for (const char* page : kPages) {
    double sum = 0;
    std::vector<std::string> decoded;
    for (const std::string* name : unknown) {
      std::optional<std::string> text = from_code_page(*name, page);
      if (!text) break;
      sum += likeness(*text);
      decoded.push_back(std::move(*text));
    }
    if (decoded.size() < unknown.size() || (!best.empty() && sum <= best_sum)) continue;
    best = page;
    best_sum = sum;
    best_names = std::move(decoded);
  }
  if (best.empty()) {  // the system has none of these tables
    best = "ISO-8859-1";
    for (const std::string* name : unknown) {
      std::string& text = best_names.emplace_back();
      for (const char c : *name) {
        utf8proc_uint8_t letter[4];
        const auto size = utf8proc_encode_char(static_cast<unsigned char>(c), letter);
        text.append(reinterpret_cast<const char*>(letter), static_cast<std::size_t>(size));
      }
    }
  }
  for (std::size_t i = 0; i < unknown.size(); ++i) *unknown[i] = std::move(best_names[i]);
  return best;
}

}  // namespace grader::intake
