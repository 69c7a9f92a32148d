// HTML from patterns in which every value is escaped unless it is HTML by its type: what is
// forgotten is safe.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace hair {

struct Html {
  std::string text;

  Html& operator+=(const Html& more) {
    text += more.text;
    return *this;
  }
};

// What stands for a {} in a pattern.
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

// The pattern with each {} replaced by the next part. Throws std::invalid_argument if their numbers differ.
Html html(std::string_view pattern, std::initializer_list<HtmlPart> parts = {});

enum class Scripts { off, on };
enum class Pictures { inside, beside };

// A whole page: its style is in it, and it may load nothing but, with Pictures::beside, picture files. Only a
// page with Scripts::on runs its own inline script.
std::string html_page(const std::string& title, const Html& body, Scripts scripts = Scripts::off,
                      Pictures pictures = Pictures::inside);

}  // namespace hair
