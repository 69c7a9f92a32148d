// STAFF ONLY. Distinguishes encodings.
#include "grader/text/encoding.h"

#include <iconv.h>
#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "grader/course/input.h"
#include "grader/text/letters.h"

namespace grader::inline text {
namespace {

using std::string_view_literals::operator""sv;

constexpr const char* kHowToSave =
    "Save it as UTF-8: in Visual Studio with File > Save As > Save with Encoding, in VS Code with a click on "
    "the encoding in "
    "the status bar, in Notepad with Encoding in Save As";

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

struct Wide {
  const char* name;
  const char* page;
  std::string_view mark;  // is the byte order mark
  std::size_t unit;
  bool little_endian;
};
// UTF-32's mark begins with UTF-16's.
constexpr std::array kEncodings = {Wide{"UTF-32", "UTF-32LE", "\xff\xfe\0\0"sv, 4, true},
                                   Wide{"UTF-32", "UTF-32BE", "\0\0\xfe\xff"sv, 4, false},
                                   Wide{"UTF-16", "UTF-16LE", "\xff\xfe"sv, 2, true},
                                   Wide{"UTF-16", "UTF-16BE", "\xfe\xff"sv, 2, false}};

// Source code is ASCII, except comments: then all bytes of a unit but one are zero. Returns the share of such
// units. A truncated file may end within a unit.
double share_of_ascii(std::string_view bytes, const Wide& encoding) {
  const std::size_t units = bytes.size() / encoding.unit;
  if (units == 0) return 0;
  std::size_t ascii = 0;
  for (std::size_t i = 0; i < units; ++i) {
    const std::string_view unit = bytes.substr(i * encoding.unit, encoding.unit);
    const std::size_t letter = encoding.little_endian ? 0 : encoding.unit - 1;
    const auto zeros = static_cast<std::size_t>(std::ranges::count(unit, '\0'));
    ascii += zeros == encoding.unit - 1 && unit[letter] >= '\t' && unit[letter] <= '~';
  }
  return static_cast<double>(ascii) / static_cast<double>(units);
}

std::optional<Wide> wide_encoding_of(std::string_view bytes) {
  for (const Wide& encoding : kEncodings)
    if (bytes.starts_with(encoding.mark)) return encoding;
  // Looks from the first letter on: a later addition to a file in UTF-8 is a stray part.
  for (const Wide& encoding : kEncodings)
    if (share_of_ascii(bytes.substr(0, encoding.unit), encoding) == 1 &&
        share_of_ascii(bytes, encoding) > 0.3)
      return encoding;
  return {};
}

// Returns the length in bytes of the letter at the beginning; 0 if it is not UTF-8. No text has NUL and
// control characters, except those between words.
std::size_t letter_at(std::string_view bytes) {
  if (const auto byte = static_cast<std::uint8_t>(bytes[0]); byte < 0x20)
    return byte >= '\t' && byte <= '\r' ? 1 : 0;
  utf8proc_int32_t letter = 0;
  const utf8proc_ssize_t size = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(bytes.data()),
                                                 static_cast<utf8proc_ssize_t>(bytes.size()), &letter);
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

void append(std::string& text, char32_t letter) {
  std::array<utf8proc_uint8_t, 4> bytes;
  const auto size = utf8proc_encode_char(static_cast<utf8proc_int32_t>(letter), bytes.data());
  text.append(bytes.begin(), bytes.begin() + size);
}

// Half a pair becomes U+FFFD.
std::string from_utf16(std::string_view bytes, bool little_endian) {
  std::string text;
  const auto unit = [&](std::size_t i) {
    const auto byte = [&](std::size_t j) { return static_cast<std::uint8_t>(bytes[j]); };
    return static_cast<char32_t>(little_endian ? byte(i + 1) << 8 | byte(i) : byte(i) << 8 | byte(i + 1));
  };
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    char32_t letter = unit(i);
    const bool first = letter >= 0xd800 && letter < 0xdc00, second = letter >= 0xdc00 && letter < 0xe000;
    if (first && i + 3 < bytes.size() && unit(i + 2) >= 0xdc00 && unit(i + 2) < 0xe000) {
      letter = 0x10000 + ((letter - 0xd800) << 10) + (unit(i + 2) - 0xdc00);
      i += 2;
    } else if (first || second) {
      letter = 0xfffd;
    }
    append(text, letter);
  }
  return text;
}

std::optional<std::string> converted(std::string_view bytes, const char* from_page, const char* to_page) {
  const iconv_t table = iconv_open(to_page, from_page);
  if (reinterpret_cast<std::intptr_t>(table) == -1) return {};
  std::string from(bytes), text(bytes.size() * 4, '\0');
  char *in = from.data(), *out = text.data();
  std::size_t in_left = from.size(), out_left = text.size();
  const bool whole = iconv(table, &in, &in_left, &out, &out_left) != std::size_t(-1) && in_left == 0;
  iconv_close(table);
  if (!whole) return {};
  text.resize(text.size() - out_left);
  return text;
}

}  // namespace

std::optional<std::string> from_code_page(std::string_view bytes, const char* page) {
  return converted(bytes, page, "UTF-8");
}

std::string encoded(std::string_view text, const Encoding& encoding) {
  const std::string page = std::string(encoding.page) + "//TRANSLIT";
  return std::string(encoding.mark) + converted(text, "UTF-8", page.c_str()).value_or(std::string(text));
}

Decoded decoded(std::string_view bytes, const std::string& file) {
  if (bytes.starts_with(kUtf8Mark)) {
    while (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
    Decoded rest = decoded(bytes, file);
    rest.said.insert(rest.said.begin(), file + ": a byte order mark is passed over");
    rest.encoding.mark = kUtf8Mark;
    return rest;
  }
  if (const std::optional<Wide> wide = wide_encoding_of(bytes)) {
    if (wide->unit == 4) throw BadInput(file + ": is UTF-32; save it as UTF-8");
    const bool marked = bytes.starts_with(wide->mark);
    if (marked) bytes.remove_prefix(wide->mark.size());
    if (bytes.size() % 2 != 0)
      throw BadInput(file + ": is UTF-16 and ends within a letter; save it as UTF-8");
    return {from_utf16(bytes, wide->little_endian),
            {file + ": is read as UTF-16 (" + (wide->little_endian ? "little" : "big") + "-endian)"},
            {wide->page, marked ? wide->mark : ""}};
  }
  if (is_utf8(bytes)) return {std::string(bytes)};
  std::optional<std::string> western = from_code_page(bytes, "CP1252");
  if (!western)
    throw BadInput(
        file +
        ": is neither UTF-8 nor UTF-16 nor Windows-1252, and names in it would be others; save it as UTF-8");
  return {std::move(*western),
          {file + ": is no UTF-8 and is read as Windows-1252, a guess; look at names that are not ASCII"},
          {"CP1252"}};
}

std::string told_if_wide(std::string_view bytes, const std::string& file) {
  const std::optional<Wide> wide = wide_encoding_of(bytes);
  if (!wide) return "";
  return file + " is " + wide->name + " (" + (wide->little_endian ? "little" : "big") +
         "-endian), and compilers read UTF-8. " + kHowToSave + ", anywhere with iconv -f " + wide->page +
         " -t UTF-8.\n";
}

std::string told_of_stray_byte(std::string_view bytes, const std::string& file) {
  for (std::size_t i = 0, line = 1, size = 0; i < bytes.size(); i += size) {
    size = letter_at(bytes.substr(i));
    if (size == 0)
      return file + " holds a byte in line " + std::to_string(line) +
             " that is no text in UTF-8: " + std::to_string(static_cast<std::uint8_t>(bytes[i])) + ". " +
             kHowToSave + ".\n";
    line += bytes[i] == '\n';
  }
  return "";
}

}  // namespace grader::text
