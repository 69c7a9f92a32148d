// Builds HTML from patterns. Every value is escaped, unless its type is Html, so that a forgotten escape is
// impossible.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace hair {

struct Html {
  std::string text;

  Html& operator+=(const Html& more) {
    text += more.text;
    return *this;
  }
};

// A value for one {} of a pattern.
class HtmlPart {
 public:
  HtmlPart(const char* text);
  HtmlPart(const std::string& text);
  HtmlPart(std::string_view text);
  HtmlPart(const Html& html) : html_(html.text) {}
  HtmlPart(std::size_t number) : html_(std::to_string(number)) {}

  const std::string& html() const { return html_; }

 private:
  std::string html_;
};

// Replaces each {} of the pattern by the next part. Throws std::invalid_argument if their numbers differ.
Html html(std::string_view pattern, std::initializer_list<HtmlPart> parts = {});

// A page's own scripts: it runs these and no others. With `asks` they may ask the page's server.
struct Scripts {
  std::vector<std::string> texts = {};
  bool asks = false;
};
enum class Pictures { inside, beside };

// A whole page with its style inside. It may load only picture files, and those only with Pictures::beside.
std::string html_page(const std::string& title, const Html& body, const Scripts& scripts = {},
                      Pictures pictures = Pictures::inside);

}  // namespace hair
