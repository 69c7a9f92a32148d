// STAFF ONLY. Writes the page of compared pictures.
#include "grader/report/pages/pages.h"

#include "grader/report/pages/pictures.h"
#include "hair/io/plot/html.h"
#include "hair/view/view_page.h"

namespace grader::inline report {
namespace {

// Writes a file's name as a part of a link: all but letters, digits and -._~ as %XX (RFC 3986).
std::string link_to(const std::string& file) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~";
  constexpr char digits[] = "0123456789ABCDEF";
  std::string link;
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string_view::npos)
      link += c;
    else
      link += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return link;
}

Html shown_pair(const ShownPair& shown) {
  const PictureDistance& distance = shown.pair.distance;
  return html(
      "<div class=\"moment\">\n<div class=\"line\"><strong>{}</strong><span>FLIP {}, up to "
      "{}</span><span>blurred "
      "RMSE {}</span></div>\n<div class=\"pictures\">\n{}{}{}</div>\n</div>\n",
      {shown.pair.name, shown_distance(distance.flip_mean), shown_distance(distance.flip_max),
       shown_distance(distance.blurred_rmse),
       figure(image(shown.reference, shown.pair.name + ", the first"), html("The first")),
       figure(image(shown.test, shown.pair.name + ", the second"), html("The second")),
       figure(image(shown.heat, shown.pair.name + ", where they differ"),
              html("Where they differ {}", {heat_scale()}))});
}

Html row(const ComparedPair& pair) {
  const PictureDistance& distance = pair.distance;
  if (!pair.obstacle.empty())
    return html("<tr><th scope=\"row\">{}</th><td colspan=\"5\">not compared: {}</td></tr>\n",
                {pair.name, pair.obstacle});
  return html(
      "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td><a href=\"{}\">side by side</a></td><td>{}</td></tr>\n",
      {pair.name, shown_distance(distance.flip_mean), shown_distance(distance.flip_max),
       shown_distance(distance.blurred_rmse), link_to(side_file(pair.name)),
       distance.identical ? html("the same")
                          : html("<a href=\"{}\">heat map</a>", {link_to(heat_file(pair.name))})});
}

Html missing(const std::string& folder, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return html("<p class=\"note\">Only in {}: {}</p>\n", {folder, list});
}

// Returns "a" for "a.png"; "a.PNG" stays, since "a.png" may exist, too.
std::string stem_of(const std::string& name) {
  return name.ends_with(".png") ? name.substr(0, name.size() - 4) : name;
}

}  // namespace

std::string heat_file(const std::string& name) {
  return stem_of(name) + "-heat.png";
}

std::string side_file(const std::string& name) {
  return stem_of(name) + "-side.png";
}

std::string comparison_page(const Comparison& comparison, const std::vector<ShownPair>& worst) {
  Html body = html(
      "<header>\n<h1>Pictures compared</h1>\n<p>The first: <code>{}</code><br/>The second: "
      "<code>{}</code></p>\n"
      "<p>{} compared, {} of them the same, pixel for pixel.</p>\n</header>\n<main>\n",
      {comparison.reference, comparison.test, count_compared(comparison), count_identical(comparison)});
  if (const std::size_t left = comparison.pairs.size() - count_compared(comparison); left > 0)
    body += html("<p class=\"note\">{} could not be compared: the first in the table below.</p>\n", {left});
  body += missing(comparison.reference, comparison.only_in_reference);
  body += missing(comparison.test, comparison.only_in_test);
  if (!worst.empty()) {
    body += html("<section id=\"worst\">\n<h2>{}</h2>\n",
                 {worst.size() + count_identical(comparison) == count_compared(comparison)
                      ? "Those that differ"
                      : "The worst " + std::to_string(worst.size())});
    for (const ShownPair& shown : worst) body += shown_pair(shown);
    body += html("</section>\n");
  }
  body += html(R"(<section id="all">
<h2>All, worst first</h2>
<div class="wide"><table>
<thead><tr><th scope="col">Picture</th><th scope="col" class="number">FLIP</th><th scope="col" class="number">FLIP, largest</th><th scope="col" class="number">Blurred RMSE</th><th scope="col">Both</th><th scope="col">Difference</th></tr></thead>
<tbody>
)");
  for (const ComparedPair& pair : comparison.pairs) body += row(pair);
  body += html("</tbody>\n</table></div>\n</section>\n</main>\n");
  return html_page("Pictures compared", body, {{hair::viewer_script()}});
}

}  // namespace grader::report
