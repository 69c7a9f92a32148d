// STAFF ONLY. Writes the page of a study.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "grader/report/pages/pages.h"
#include "grader/report/pages/studies_section.h"
#include "hair/io/plot/figure.h"
#include "hair/io/plot/page.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

using hair::to_text;

std::string rounded(double value) {
  return hair::printed("%.3g", value);
}

// Returns "1/240 s".
std::string step_text(const PartStudy& part, int steps) {
  const double each_second = 1 / step_of(part, steps);
  return "1/" + (each_second < 1000 ? rounded(each_second) : std::to_string(std::lround(each_second))) + " s";
}

const StudyPoint* with_steps(const StudyCurve& curve, int steps) {
  for (const StudyPoint& point : curve.points)
    if (point.steps == steps) return &point;
  return nullptr;
}

// Returns the median of a run's rounds. A failed run gets the time of the nearest finished one, times the
// ratio of their steps, or the time of its first run if none finished. 0: unknown.
double seconds_of(const StudyPoint& point, const StudyCurve& curve) {
  if (point.end == StudyEnd::finished) return timing::median(point.seconds);
  const StudyPoint* nearest = nullptr;
  for (const StudyPoint& other : curve.points)
    if (other.end == StudyEnd::finished && timing::median(other.seconds) > 0 &&
        (nearest == nullptr || std::abs(other.steps - point.steps) < std::abs(nearest->steps - point.steps)))
      nearest = &other;
  return nearest == nullptr ? point.first_seconds
                            : timing::median(nearest->seconds) * point.steps / nearest->steps;
}

// Divides the median of a run's measured times by its first time; 0: unknown.
double again(const StudyPoint* point) {
  if (point == nullptr || point->end != StudyEnd::finished || !(point->first_seconds > 0)) return 0;
  return timing::median(point->seconds) / point->first_seconds;
}

// Returns the median over a curve's runs that another curve has, too: short runs take longer at first on both
// sides.
double again(const StudyCurve& curve, const StudyCurve& other) {
  std::vector<double> all;
  for (const StudyPoint& point : curve.points)
    if (again(&point) > 0 && again(with_steps(other, point.steps)) > 0) all.push_back(again(&point));
  return timing::median(all);
}

// True if the student's code is far faster in repetitions, compared with the reference's.
bool far_less_again(const PartStudy& part) {
  constexpr double kFarLess = 0.25;
  const double theirs = again(part.student, part.reference), ours = again(part.reference, part.student);
  return part.rounds > 0 && theirs > 0 && theirs < kFarLess * std::min(1.0, ours);
}

hair::Series series_of(const PartStudy& part, const StudyCurve& curve, const std::string& name) {
  hair::Series series{name, {}};
  for (const StudyPoint& point : curve.points) {
    const bool failed = point.end != StudyEnd::finished;
    const double seconds = seconds_of(point, curve);
    if (!(seconds > 0)) continue;
    std::string note = "h = " + step_text(part, point.steps);
    if (point.steps == part.own_steps) note += ", the scene's own";
    if (failed) note += ": " + to_string(point.end) + ", " + point.note;
    series.points.push_back({1e3 * seconds, std::max(point.error, part.least_error), note, failed});
  }
  return series;
}

std::vector<std::string> figure_of(const PartStudy& part, const std::string& id) {
  hair::Figure figure;
  figure.id = id;
  figure.title = part.name;
  figure.description =
      "Error against CPU time, one point for each step size, of your code and of ours. The further to the "
      "left and the further down, the better.";
  figure.x.title = "CPU time of one run, ms";
  figure.y.title = "error, m";
  figure.series = {series_of(part, part.student, "yours"), series_of(part, part.reference, "ours")};
  std::erase_if(figure.series, [](const hair::Series& series) { return series.points.empty(); });
  if (figure.series.empty()) return {};
  figure.guides = {{-static_cast<double>(part.order), "order " + std::to_string(part.order)}};
  return {to_svg(figure)};
}

std::string stability(const PartStudy& part, const StudyCurve& curve) {
  if (curve.stable_steps == 0) {
    const bool to_the_end = !curve.points.empty() && !part.reference.points.empty() &&
                            curve.points.back().end != StudyEnd::broke &&
                            curve.points.back().steps == part.reference.points.back().steps;
    return to_the_end ? "none" : "not known";
  }
  return std::string(curve.stable_everywhere ? "all that were tried, up to " : "up to ") +
         "h = " + step_text(part, curve.stable_steps);
}

std::string ratio_text(const TimeRatio& ratio) {
  return rounded(ratio.median) + " (" + rounded(ratio.least) + " to " + rounded(ratio.most) + ")";
}

std::string error_text(const StudyPoint* point) {
  if (point == nullptr) return "not run";
  return point->end == StudyEnd::finished ? to_text(point->error)
                                          : to_string(point->end) + ": " + point->note;
}

std::string time_text(double seconds) {
  return seconds > 0 ? rounded(1e3 * seconds) : "";
}

std::string times_of(const PartStudy& part) {
  if (part.rounds == 0)
    return "Times are those of first runs, yours and ours: no round was measured to its end.";
  return "Times are medians of " + std::to_string(part.rounds) + (part.rounds == 1 ? " round" : " rounds") +
         " in which both took turns.";
}

hair::Table table_of(const PartStudy& part) {
  std::set<int> all;
  for (const StudyCurve* curve : {&part.student, &part.reference})
    for (const StudyPoint& point : curve->points) all.insert(point.steps);
  hair::Table table{"Numbers of " + part.name,
                    {"Steps", "h", "Your error, m", "Ours, m", "Your time, ms", "Your first run",
                     "Our time, ms", "Our first run", "Your solver steps", "Ours"},
                    {}};
  for (const int steps : all) {
    std::vector<std::string> row = {std::to_string(steps) + (steps == part.own_steps ? " (the scene)" : ""),
                                    step_text(part, steps)};
    const std::array points = {with_steps(part.student, steps), with_steps(part.reference, steps)};
    for (const StudyPoint* point : points) row.push_back(error_text(point));
    for (const StudyPoint* point : points) {
      row.push_back(point == nullptr ? "" : time_text(timing::median(point->seconds)));
      row.push_back(point == nullptr ? "" : time_text(point->first_seconds));
    }
    for (const StudyPoint* point : points)
      row.push_back(point == nullptr ? "" : std::to_string(point->solver_steps));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Html part_of(const SceneStudy& scene, const PartStudy& part, const std::string& id) {
  hair::Section section{part.name, {scene.shows + "."}};
  if (!part.note.empty()) section.paragraphs.push_back(part.note);
  section.paragraphs.push_back(
      part.ratio
          ? "For the same error your code takes " + ratio_text(*part.ratio) + " times our time."
          : std::string(
                "There is no error that both reach while both fall, so their times can't be compared."));
  if (far_less_again(part))
    section.paragraphs.push_back(
        "Asked for the same again, your code took " + rounded(again(part.student, part.reference)) +
        " times the time of its first runs, ours " + rounded(again(part.reference, part.student)) +
        " times: it may remember its answers. First runs are in the numbers below.");
  section.paragraphs.push_back("Stable: " + stability(part, part.student) +
                               " (ours: " + stability(part, part.reference) + ").");
  section.paragraphs.push_back(times_of(part) + " Errors are against " + part.truth + "; errors below " +
                               to_text(part.least_error) + " m mean nothing.");
  section.figures = figure_of(part, "plot-" + id);
  section.tables = {table_of(part)};
  return hair::html_of(section, "part-" + id);
}

// Says which of a scene's exercises are not right in this submission; empty if all are.
std::string not_right(const SceneStudy& scene, const SubmissionResult& result) {
  std::string all;
  for (const ExerciseResult& exercise : result.exercises) {
    const bool is_right = exercise.status == Status::passed || exercise.status == Status::given;
    if (!is_right && std::ranges::count(scene.exercises, exercise.id) > 0)
      all += (all.empty() ? "" : ", ") + exercise.id + " is " + to_string(exercise.status);
  }
  return all;
}

Html overview_of(const SubmissionStudy& study, const SubmissionResult& result) {
  Html rows;
  for (const SceneStudy& scene : study.scenes) {
    if (!scene.left_out.empty())
      rows += html("<tr><th scope=\"row\">{}</th><td colspan=\"4\">left out: {}</td></tr>\n",
                   {scene.name, scene.left_out});
    const std::string wrong = not_right(scene, result);
    for (const PartStudy& part : scene.parts) {
      std::string words = !part.ratio && !wrong.empty() ? "not compared: " + wrong : in_words(part);
      if (part.ratio && !wrong.empty()) words += "; " + wrong;
      std::vector<Dot> dots;
      if (part.ratio) dots = {{part.ratio->median, words}};
      rows += html("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                   {is_noise(part) ? html(" class=\"quiet\"") : Html(), part.name, track(dots, part.noise),
                    words, stability(part, part.student), stability(part, part.reference)});
    }
  }
  return html(
      R"(<section id="summary">
<h2>All motions</h2>
<p class="quiet">Your time for the same error; ours is 1. Grey is the noise: a second worker of ours, measured in the same rounds. A ratio within it means nothing.</p>
{}</section>
)",
      {table_of_tracks(html("<th scope=\"col\">Your time, ours is 1</th><th scope=\"col\">Your steps are "
                            "stable</th><th scope=\"col\">Ours</th>"),
                       rows)});
}

}  // namespace

std::string study_page(const SubmissionResult& result, const SubmissionStudy& study,
                       const NamesForPeople& people) {
  Html body = stamps(result.isolation, true);
  body += html(R"(<header>
<h1>Error against run time: {}</h1>
<p class="quiet"><a href="report.html">The report</a> &#183; <a href="study.json">study.json</a></p>
</header>
<main>
<p>Your code and ours run small scenes with more steps and with fewer; all of your files work together. These numbers
are for you to look at: they give no points and take none. Another run gives other times.</p>
<p>Error: the root mean square of the particles&#39; distances from where they should be, over the whole motion.
Time: CPU time of a whole run, by the kernel&#39;s clock, the median of rounds in which your code and ours took
turns, each in a worker of its own; a failed run is drawn at the time that its steps would have taken. Ratios are medians
of these rounds, with the least and the largest. Steps are stable if no particle is ever further from where it should
be than the motion is large, with these and with all shorter ones.</p>
<p>Errors are found by us, from where your code says that the particles are. Two numbers need care. Your code
itself reports its solver steps. Code that keeps its answers takes no time when it is asked the same again; so the
tables show the time of each first run, too. (The scene&#39;s own steps were run once before, to warm up.) Code that
works before it is asked pays for this in another run.</p>
)",
               {shown_name(result.name, people)});
  body += overview_of(study, result);
  for (std::size_t i = 0; i < study.scenes.size(); ++i) {
    const SceneStudy& scene = study.scenes[i];
    for (std::size_t k = 0; k < scene.parts.size(); ++k)
      body += part_of(scene, scene.parts[k], std::to_string(i + 1) + "-" + std::to_string(k + 1));
  }
  body += html("</main>\n");
  return html_page("Error against run time: " + shown_name(result.name, people), body);
}

}  // namespace grader::report
