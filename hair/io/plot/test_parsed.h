// Parses XML with a strict parser (libxml2) into a tree of plain data.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace hair::plot {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  // its own text and that of its elements, one after the other
  std::vector<Element> elements;

  const std::string& operator[](const std::string& attribute) const { return attributes.at(attribute); }
  bool has(const std::string& attribute, const std::string& value) const;

  // All elements within it for which `holds` is true, in the order of the text; named() selects those with a
  // tag.
  template <class Holds>
  std::vector<Element> all(const Holds& holds) const {
    std::vector<Element> found;
    for (const Element& element : elements) {
      if (holds(element)) found.push_back(element);
      const std::vector<Element> within = element.all(holds);
      found.insert(found.end(), within.begin(), within.end());
    }
    return found;
  }
  std::vector<Element> named(const std::string& tag) const;
  std::vector<Element> of_class(const std::string& wanted) const;
};

// Throws std::runtime_error with the parser's own message if the XML is not well formed.
Element parse(const std::string& xml);

// The same for a page. It has no elements within a script: a script's text is no XML.
Element parse_page(std::string html);

}  // namespace hair::plot
