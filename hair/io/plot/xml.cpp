#include "hair/io/plot/xml.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace hair::plot {

namespace {

constexpr std::string_view kLost = "\xEF\xBF\xBD";  // U+FFFD

// The bytes of the UTF-8 character that `text` begins with (RFC 3629, section 4), 0 if it begins with none
// that XML allows.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
  };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : first == '\t' || first == '\n';
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  std::uint32_t code = first & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF, no_character = code == 0xFFFE || code == 0xFFFF;
  const bool control = code < 0xA0;  // U+0080 to U+009F
  if (first < 0xC2 || code < kLeast[length] || code > 0x10FFFF || surrogate || no_character || control)
    return 0;
  return length;
}

// In running text a line break would come between words that belong together.
bool breaks_line_after(std::string_view tag) {
  return tag != "tspan" && tag != "a" && tag != "sup";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text.substr(i));
    const char c = text[i];
    if (length == 0)
      out += kLost;
    else if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else
      out += text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return out;
}

std::string pixels(double value) {
  const double rounded = std::round(value * 100) / 100;
  std::array<char, 32> text = {};
  // Adding 0 makes -0 a 0.
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), rounded + 0.0).ptr};
}

void XmlWriter::begin(std::string_view tag, Attributes attributes) {
  out_ += '<';
  out_ += tag;
  for (const Attribute& attribute : attributes) {
    out_ += ' ';
    out_ += attribute.name;
    out_ += "=\"";
    out_ += escaped(attribute.value);
    out_ += '"';
  }
}

XmlWriter& XmlWriter::open(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  out_ += '>';
  open_.emplace_back(tag);
  return *this;
}

XmlWriter& XmlWriter::close() {
  if (open_.empty()) throw std::logic_error("XmlWriter: nothing is open that could be closed");
  const std::string tag = std::move(open_.back());
  open_.pop_back();
  out_ += "</" + tag + ">";
  if (breaks_line_after(tag)) out_ += '\n';
  return *this;
}

XmlWriter& XmlWriter::text(std::string_view text) {
  out_ += escaped(text);
  return *this;
}

XmlWriter& XmlWriter::leaf(std::string_view tag, Attributes attributes, std::string_view content) {
  return open(tag, attributes).text(content).close();
}

XmlWriter& XmlWriter::empty(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  out_ += "/>";
  if (breaks_line_after(tag)) out_ += '\n';
  return *this;
}

XmlWriter& XmlWriter::as_it_is(std::string_view xml) {
  out_ += xml;
  return *this;
}

std::string XmlWriter::take() {
  if (!open_.empty()) throw std::logic_error("XmlWriter: <" + open_.back() + "> is still open");
  return std::move(out_);
}

}  // namespace hair::plot
