#include "hair/io/plot/readable.h"

#include <algorithm>

namespace hair {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

// The length of the valid UTF-8 sequence at the start of `text`, 0 if there is none (Unicode 15, table 3-7).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xbf; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4 || !follows(1)) return 0;
  if (first < 0xe0) return 2;
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) || !follows(2)) return 0;
  if (first < 0xf0) return 3;
  if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f) || !follows(3)) return 0;
  return 4;
}

// The length of a terminal's escape sequence: ESC [ parameters letter, or ESC and one more character.
std::size_t escape_length(std::string_view text) {
  if (text.size() < 2 || text[1] != '[') return std::min<std::size_t>(text.size(), 1);
  const std::size_t end = text.find_first_not_of("0123456789;:?", 2);
  return end == std::string_view::npos ? text.size() : end + 1;
}

// U+0080..U+009F are control characters, too; U+FFFE and U+FFFF are no characters of XML.
bool is_control(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f;
  if (sequence.size() == 2) return first == 0xc2 && static_cast<unsigned char>(sequence[1]) < 0xa0;
  return sequence == "\xef\xbf\xbe" || sequence == "\xef\xbf\xbf";
}

struct Entity {
  char of;
  std::string_view text;
};

constexpr Entity entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};

struct Mark {
  std::string_view bytes, shown;
};

// Marks that turn the direction of the text after them.
constexpr Mark marks[] = {{"\xd8\x9c", "U+061C"},     {"\xe2\x80\x8e", "U+200E"}, {"\xe2\x80\x8f", "U+200F"},
                          {"\xe2\x80\xaa", "U+202A"}, {"\xe2\x80\xab", "U+202B"}, {"\xe2\x80\xac", "U+202C"},
                          {"\xe2\x80\xad", "U+202D"}, {"\xe2\x80\xae", "U+202E"}, {"\xe2\x81\xa6", "U+2066"},
                          {"\xe2\x81\xa7", "U+2067"}, {"\xe2\x81\xa8", "U+2068"}, {"\xe2\x81\xa9", "U+2069"}};

// The mark at the start of `text`; null if there is none.
const Mark* mark_at(std::string_view text) {
  if (static_cast<unsigned char>(text[0]) < 0x80) return nullptr;
  const Mark* const found =
      std::ranges::find_if(marks, [&](const Mark& mark) { return text.starts_with(mark.bytes); });
  return found == std::end(marks) ? nullptr : found;
}

}  // namespace

std::string valid_utf8(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = sequence_length(bytes);
    text += length > 0 ? bytes.substr(0, length) : replacement;
    bytes.remove_prefix(length > 0 ? length : 1);
  }
  return text;
}

std::string readable(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    std::size_t length = sequence_length(bytes);
    if (bytes[0] == '\x1b') {
      length = escape_length(bytes);
    } else if (bytes.starts_with("\r\n")) {
      length = 1;
    } else if (length == 0 || is_control(bytes.substr(0, length))) {
      text += replacement;
      length = length > 0 ? length : 1;
    } else {
      text += bytes.substr(0, length);
    }
    bytes.remove_prefix(length);
  }
  return text;
}

std::string escaped(std::string_view bytes) {
  std::string text;
  const std::string whole = readable(bytes);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    if (const Mark* const mark = mark_at(std::string_view(whole).substr(at))) {
      text += "&lt;" + std::string(mark->shown) + "&gt;";
      at += mark->bytes.size() - 1;
      continue;
    }
    const auto* const entity = std::ranges::find(entities, whole[at], &Entity::of);
    text += entity == std::end(entities) ? std::string_view(&whole[at], 1) : entity->text;
  }
  return text;
}

}  // namespace hair
