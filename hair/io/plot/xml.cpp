#include "hair/io/plot/xml.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace hair::plot {

namespace {

// In running text a line break would separate words that belong together.
bool breaks_line_after(std::string_view tag) {
  return tag != "tspan" && tag != "a" && tag != "sup";
}

}  // namespace

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
