// STAFF ONLY. Shows ratios of run times for the same error: a row a method.
#include "grader/report/pages/studies_section.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/page.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

// Returns a ratio's place on the track, in per cent: from 1/8 to 8, in logarithmic scale.
double place(double ratio) {
  return 100 * std::clamp((std::log2(ratio) + 3) / 6, 0.0, 1.0);
}

// The same code, built as a submission is and as ours is, differs by up to 8 % (MEASURED.md).
constexpr double kOfBuilds = 1.1;

// Returns the noise in both directions: which of two equal workers is the slower one is chance.
TimeRatio band_of(const TimeRatio& noise) {
  const double most = kOfBuilds * std::max(noise.most, 1 / noise.least);
  return {1, 1 / most, most};
}

}  // namespace

bool is_noise(const PartStudy& part) {
  if (!part.ratio || !part.noise) return false;
  const TimeRatio band = band_of(*part.noise);
  return part.ratio->median >= band.least && part.ratio->median <= band.most;
}

std::string in_words(const PartStudy& part) {
  if (!part.ratio) return "not compared: there is no error that both reach while both fall";
  std::string text = hair::to_text(part.ratio->median);
  if (!part.noise) return text;
  const TimeRatio band = band_of(*part.noise);
  return text + (is_noise(part) ? ", within" : ", beyond") + " the noise, " + hair::to_text(band.least) +
         " to " + hair::to_text(band.most);
}

Html track(const std::vector<Dot>& dots, const std::optional<TimeRatio>& noise) {
  Html marks;
  if (noise) {
    const TimeRatio band = band_of(*noise);
    marks += html("<span class=\"noise\" style=\"left: {}%; width: {}%\"></span>",
                  {std::to_string(place(band.least)), std::to_string(place(band.most) - place(band.least))});
  }
  for (const Dot& dot : dots)
    marks += html("<span class=\"dot\" style=\"left: {}%\" title=\"{}\"></span>",
                  {std::to_string(place(dot.ratio)), dot.title});
  return html("<div class=\"track\" aria-hidden=\"true\">{}</div>", {marks});
}

Html table_of_tracks(const Html& heads, const Html& rows) {
  return html(R"(<div class="wide"><table>
<thead><tr><th scope="col">Method</th><th scope="col"><span class="ends"><span>&#8539;</span><span>1</span><span>8</span></span></th>{}</tr></thead>
<tbody>
{}</tbody>
</table></div>
)",
              {heads, rows});
}

Html studies_section(const std::vector<Studied>& studies) {
  struct Method {
    std::vector<Dot> dots;
    std::optional<TimeRatio> noise;
  };
  std::vector<std::pair<std::string, Method>> methods;  // in the order of the scenes
  for (const Studied& one : studies)
    for (const SceneStudy& scene : one.study.scenes)
      for (const PartStudy& part : scene.parts) {
        auto found = std::ranges::find(methods, part.name, &std::pair<std::string, Method>::first);
        if (found == methods.end()) found = methods.insert(methods.end(), {part.name, {}});
        Method& method = found->second;
        if (part.ratio)
          method.dots.push_back({part.ratio->median, one.name + ": " + hair::to_text(part.ratio->median)});
        if (!part.noise) continue;
        if (!method.noise || part.noise->most / part.noise->least > method.noise->most / method.noise->least)
          method.noise = part.noise;
      }
  if (methods.empty()) return {};
  Html rows;
  for (const auto& [name, method] : methods) {
    std::vector<double> ratios;
    for (const Dot& dot : method.dots) ratios.push_back(dot.ratio);
    rows += html(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{} of "
        "{}</td></tr>\n",
        {name, track(method.dots, method.noise), ratios.empty() ? "" : hair::to_text(timing::median(ratios)),
         ratios.size(), studies.size()});
  }
  return html(R"(<section id="studies">
<h2>Error against run time</h2>
<p class="quiet">A dot is one submission: its time for the same error, ours is 1. Grey is the noise, the widest that a study of this class had.</p>
{}</section>
)",
              {table_of_tracks(html("<th scope=\"col\" class=\"number\">Median</th><th scope=\"col\" "
                                    "class=\"number\">Compared</th>"),
                               rows)});
}

}  // namespace grader::report
