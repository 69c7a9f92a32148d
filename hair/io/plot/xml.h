// Writes XML (SVG) that is always well formed: elements are closed in order, and all text is escaped.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "hair/io/plot/readable.h"

namespace hair::plot {

// A coordinate in pixels: at most two decimals, without trailing zeros.
std::string pixels(double value);

struct Attribute {
  Attribute(std::string_view a_name, std::string_view text) : name(a_name), value(text) {}
  Attribute(std::string_view a_name, const char* text) : name(a_name), value(text) {}
  Attribute(std::string_view a_name, const std::string& text) : name(a_name), value(text) {}
  Attribute(std::string_view a_name, double number) : name(a_name), value(pixels(number)) {}

  std::string_view name;
  std::string value;
};
using Attributes = std::initializer_list<Attribute>;

class XmlWriter {
 public:
  XmlWriter& open(std::string_view tag, Attributes attributes = {});
  XmlWriter& close();  // the innermost open element
  XmlWriter& text(std::string_view text);
  XmlWriter& leaf(std::string_view tag, Attributes attributes, std::string_view text);  // <tag>text</tag>
  XmlWriter& empty(std::string_view tag, Attributes attributes);                        // <tag/>
  XmlWriter& as_it_is(std::string_view xml);

  // Returns the whole text. Throws std::logic_error if an element is still open.
  std::string take();

 private:
  void begin(std::string_view tag, Attributes attributes);

  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace hair::plot
