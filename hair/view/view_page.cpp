#include "hair/view/view_page.h"

#include "hair/view/page_scripts.h"
#include "hair/view/run_script.h"
#include "hair/view/viewer_script.h"

namespace hair {

namespace {

// JSON inside of a page: `<` occurs only in its texts, and none may end the element that holds it.
Html inside_a_page(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) letter == '<' ? text += "\\u003c" : text += letter;
  return {text};
}

}  // namespace

std::string view_page(const std::vector<NamedMotion>& motions, const Html& below) {
  std::string title;
  Html data;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    title += (i == 0 ? "" : " and ") + motions[i].name;
    data += html("<script type=\"application/json\" id=\"{}\" data-name=\"{}\">{}</script>\n",
                 {i == 0 ? "motion" : "other", motions[i].name, inside_a_page(motions[i].json)});
  }
  const Html body = html(R"(<main class="view">
<h1>{}</h1>
<p id="shows"></p>
<noscript><p>This page needs JavaScript, which this browser does not run.</p></noscript>
<p id="note" role="status"></p>
<canvas id="picture" tabindex="0" role="img" aria-label="The run"></canvas>
<div class="controls">
<button id="play" type="button">Play</button>
<input id="time" type="range" min="0" max="0" value="0" aria-label="Frame"/>
<label>speed <select id="rate"><option value="1">as it is</option><option value="0.5">half</option><option value="0.25">a quarter</option><option value="0.1">a tenth</option></select></label>
<label>colour <select id="colour"></select></label>
<span id="runs"></span>
</div>
<p id="moment" class="quiet"></p>
<div id="plots"></div>
<h2>In words</h2>
<div id="words"></div>
<p class="quiet">Drag to turn, with shift to move, and use the wheel or two fingers to come nearer. Arrow keys turn, + and - come nearer and go away, 0 goes back. Space plays and stops; comma and full stop go a frame back and on.</p>
{}</main>
{})",
                         {title, below, data});
  Scripts scripts{{"\"use strict\";\n" + kPageScripts + kRunScript}};
  if (motions.size() > 1) scripts.texts.push_back(viewer_script());
  return html_page(title, body, scripts);
}

std::string viewer_script() {
  return "\"use strict\";\n{\n" + kViewerScript + "}\n";
}

}  // namespace hair
