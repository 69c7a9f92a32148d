#include "hair/io/plot/test_parsed.h"

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <memory>
#include <stdexcept>

namespace hair::plot {

namespace {

std::string text_of(const xmlChar* text) {
  return text ? reinterpret_cast<const char*>(text) : "";
}

Element element_of(const xmlNode* node) {
  Element element;
  element.name = text_of(node->name);
  for (const xmlAttr* attribute = node->properties; attribute; attribute = attribute->next) {
    xmlChar* value = xmlNodeListGetString(node->doc, attribute->children, 1);
    element.attributes[text_of(attribute->name)] = text_of(value);
    xmlFree(value);
  }
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (child->type == XML_TEXT_NODE) element.text += text_of(child->content);
    if (child->type != XML_ELEMENT_NODE) continue;
    element.elements.push_back(element_of(child));
    element.text += element.elements.back().text;
  }
  return element;
}

}  // namespace

bool Element::has(const std::string& attribute, const std::string& value) const {
  const auto found = attributes.find(attribute);
  return found != attributes.end() && found->second == value;
}

std::vector<Element> Element::named(const std::string& tag) const {
  return all([&](const Element& element) { return element.name == tag; });
}

std::vector<Element> Element::of_class(const std::string& wanted) const {
  return all([&](const Element& element) { return element.has("class", wanted); });
}

Element parse(const std::string& xml) {
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document(
      xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "text", "UTF-8",
                    XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      xmlFreeDoc);
  if (!document) {
    const xmlError* error = xmlGetLastError();
    throw std::runtime_error("not well formed: line " + std::to_string(error ? error->line : 0) + ": " +
                             (error && error->message ? error->message : "no reason given"));
  }
  return element_of(xmlDocGetRootElement(document.get()));
}

Element parse_page(std::string html) {
  for (std::size_t at = html.find("<script"); at != std::string::npos; at = html.find("<script", at + 1)) {
    const std::size_t from = html.find('>', at) + 1;
    html.erase(from, html.find("</script>", from) - from);
  }
  return parse(html);
}

}  // namespace hair::plot
