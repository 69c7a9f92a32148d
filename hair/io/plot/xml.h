// XML (SVG), written so that it can't be anything but well formed: elements close in their order, and
// whatever a text holds is shown and never obeyed.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "hair/io/plot/readable.h"

namespace hair::plot {

// At most two decimals, without zeros at the end: what a coordinate in pixels needs.
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
  XmlWriter& close();  // what was opened last
  XmlWriter& text(std::string_view text);
  XmlWriter& leaf(std::string_view tag, Attributes attributes, std::string_view text);  // <tag>text</tag>
  XmlWriter& empty(std::string_view tag, Attributes attributes);                        // <tag/>
  XmlWriter& as_it_is(std::string_view xml);

  // All that was written. Throws std::logic_error if something is still open.
  std::string take();

 private:
  void begin(std::string_view tag, Attributes attributes);

  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace hair::plot
