// STAFF ONLY. Shows pictures of graded runs next to the reference's.
#include "grader/report/pages/pictures.h"

#include <algorithm>
#include <utility>

#include "grader/compare/compare.h"
#include "grader/compare/montage.h"
#include "grader/course/input.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "hair/io/files/base64.h"
#include "hair/io/image/read_png.h"
#include "hair/io/plot/page.h"
#include "hair/view/view_page.h"

namespace grader::inline report {
namespace {

constexpr std::size_t kMostSmallPictures = 20;  // bounds the rows of the class's page with pictures

std::string name_of(const PictureResult& picture) {
  return picture.name + (picture.breaks_off ? ", the last moment that can be drawn" : "");
}

// A picture that is the same needs no close look, and a report stays small. A damaged one stays as it is: the
// report is written all the same.
std::string half_size(const std::string& png) try {
  constexpr int kWidth = 240;  // pixels
  return hair::encode_png(shrunk(hair::decode_png(png, "a picture"), kWidth));
} catch (const BadInput&) {
  return png;
}

// Says "blurred RMSE 0.0033, 6.6 times the limit".
std::string measured(const char* name, double distance, double limit) {
  return name + (" " + shown_distance(distance)) +
         (distance > limit ? ", " + shown_distance(distance / limit) + " times the limit" : "");
}

// Returns a place of a page of a run, as hair/view reads it.
std::string at_time(const PictureResult& picture) {
  return "time=" + picture.name.substr(0, picture.name.find(' '));
}

Html link_closer(const ExerciseResult& exercise, const PictureResult& picture, const PicturePlace& place) {
  return link_to_run(exercise, at_time(picture), place.runs, "Look closer");
}

Html moment(const ExerciseResult& exercise, const PictureResult& picture, const std::string& whose,
            const PicturePlace& place) {
  if (picture.heat.empty()) {
    const std::string png = place.is_for_student ? half_size(picture.student) : picture.student;
    return html(
        "<div class=\"moment\">\n<div class=\"line\"><strong>{}</strong><span>the same, pixel for "
        "pixel</span></div>\n<div class=\"pictures one\">\n{}</div>\n</div>\n",
        {name_of(picture), figure(image(png, whose + " and the reference's hair at " + picture.name, place),
                                  html("{} and the reference&#39;s", {whose}))});
  }
  const bool is_coarse = picture.far_off && place.is_for_student;
  return html(
      "<div class=\"moment\">\n<div "
      "class=\"line\"><strong>{}</strong><span>{}</span><span>{}</span>{}{}</div>\n<div "
      "class=\"pictures\">\n{}{}{}</div>\n</div>\n",
      {name_of(picture), measured("blurred RMSE", picture.blurred_rmse, kBlurredRmse),
       measured("FLIP", picture.flip, kFlip),
       picture.apart > 0 ? html("<span>apart by up to {} %</span>", {shown_distance(picture.apart)}) : Html{},
       link_closer(exercise, picture, place),
       figure(image(picture.student, whose + " at " + picture.name, place),
              html("{}{}", {whose, is_coarse ? ", shown coarsely: it is far from the reference's" : ""})),
       figure(image(picture.reference, "The reference's at " + picture.name, place),
              html("The reference&#39;s")),
       figure(image(picture.heat, "Where the two differ at " + picture.name, place),
              html("Where they differ {}", {heat_scale()}))});
}

// Holds the run of a submission that is furthest from the reference's: one that breaks off, or else that of
// the worst picture.
struct Worst {
  const SubmissionResult* result = nullptr;
  const ExerciseResult* exercise = nullptr;
  const PictureResult* picture = nullptr;  // null: the run breaks off without one
  bool breaks_off = false;

  double flip() const { return picture ? picture->flip : 0; }
};

std::vector<Worst> worst_first(const std::vector<SubmissionResult>& results) {
  const auto is_worse = [](const Worst& a, const Worst& b) {
    return a.breaks_off != b.breaks_off ? a.breaks_off : a.flip() > b.flip();
  };
  std::vector<Worst> all;
  for (const SubmissionResult& result : results) {
    Worst worst{&result};
    const auto take = [&](const Worst& other) {
      if (!worst.exercise || is_worse(other, worst)) worst = other;
    };
    for (const ExerciseResult& exercise : result.exercises) {
      const bool breaks_off = run_breaks_off(exercise);
      if (breaks_off && exercise.pictures.empty()) take({&result, &exercise, nullptr, true});
      for (const PictureResult& picture : exercise.pictures) take({&result, &exercise, &picture, breaks_off});
    }
    if (worst.exercise) all.push_back(worst);
  }
  std::stable_sort(all.begin(), all.end(), is_worse);
  return all;
}

Html row(const Worst& worst, bool with_pictures, const PicturePlace& place, const NamesForPeople& people) {
  const PictureResult* picture = worst.picture;
  const std::string at = worst.exercise->id + (picture ? " at " + picture->name : "");
  const auto small = [&](const std::string& png, const std::string& alt) {
    return png.empty() ? Html{} : image(png, alt, place, "small");
  };
  Html pictures = html("<td></td><td></td><td></td>");
  if (with_pictures && picture)
    pictures =
        html("<td>{}</td><td>{}</td><td>{}</td>",
             {small(picture->student, shown_name(worst.result->name, people) + ", " + at),
              small(picture->reference, "The reference, " + at), small(picture->heat, "Difference, " + at)});
  // A run that breaks off is further out than all others, whichever column sorts them.
  const auto number = [&](double distance, const char* of_broken = "") {
    return html("<td class=\"number\" data-value=\"{}\">{}</td>",
                {worst.breaks_off ? std::string("1e9") : shown_distance(distance),
                 worst.breaks_off ? of_broken : shown_distance(distance)});
  };
  const PictureResult none;
  const PictureResult& measured = picture ? *picture : none;
  const double lost = worst.exercise->max_points - worst.exercise->points;
  const Html closer = link_to_run(*worst.exercise, picture ? at_time(*picture) : "apart=1",
                                  "staff/runs/" + worst.result->name, "look closer");
  return html(
      "<tr><th scope=\"row\"><a href=\"staff/{}.html#{}\">{}</a></th>{}{}{}<td class=\"number\" "
      "data-value=\"{}\">{}</td><td>{}<br/>{}</td>{}</tr>\n",
      {worst.result->name, worst.exercise->id, shown_name(worst.result->name, people),
       number(measured.flip, "breaks off"), number(measured.blurred_rmse), number(measured.apart),
       std::to_string(lost), shown_points(lost), at, closer, pictures});
}

}  // namespace

std::string shown_distance(double distance) {
  return hair::to_text(distance);
}

Html image(const std::string& png, const std::string& alt, const PicturePlace& place, const char* look) {
  const std::string source = place.folder.empty() ? "data:image/png;base64," + hair::base64(png)
                                                  : place.folder + "/" + picture_name(png);
  return html("<img{}alt=\"{}\" src=\"{}\"/>",
              {*look == '\0' ? html(" ") : html(" class=\"{}\" ", {look}), alt, Html{source}});
}

Html heat_scale() {
  std::string colors;
  for (const HeatColor& color : kHeatColors)
    colors += (colors.empty() ? "rgb(" : ", rgb(") + std::to_string(color[0]) + " " +
              std::to_string(color[1]) + " " + std::to_string(color[2]) + ")";
  return html(
      "<span class=\"quiet\">0<span class=\"scale\" style=\"background:linear-gradient(to right, {})\" "
      "aria-hidden=\"true\"></span>1</span>",
      {colors});
}

Html figure(const Html& picture, const Html& caption) {
  return html("<figure>{}<figcaption>{}</figcaption></figure>\n", {picture, caption});
}

Html link_to_run(const ExerciseResult& exercise, const std::string& place, const std::string& runs,
                 const std::string& text) {
  if (runs.empty() || exercise.motions.student.empty()) return {};
  return html("<a href=\"{}/{}.html#{}\">{}</a>", {runs, exercise.id, place, text});
}

Html film(const std::string& png) {
  if (png.empty()) return {};
  const std::string moments = std::to_string(hair::decode_png(png, "a film").height / kCoarseHeight);
  return html(
      "<div class=\"film\"><label><input type=\"checkbox\"/> play it: yours to the left, the reference&#39;s "
      "to the right, at {} moments, as coarse as pictures that are far off</label>\n<div role=\"img\" "
      "aria-label=\"Both runs\" style=\"--moments: {}; background-image: "
      "url(data:image/png;base64,{})\"></div></div>\n",
      {moments, moments, Html{hair::base64(png)}});
}

Html moments(const ExerciseResult& exercise, const std::string& heading, RunEnding ending,
             const std::string& whose, const PicturePlace& place) {
  const std::vector<PictureResult>& pictures = exercise.pictures;
  if (pictures.empty()) return {};
  double flip = 0;
  bool open = ending == RunEnding::breaks_off;
  Html rows;
  for (const PictureResult& picture : pictures) {
    flip = std::max(flip, picture.flip);
    open = open || picture.flip > 0;
    rows += moment(exercise, picture, whose, place);
  }
  return html(
      "<details{}><summary>{}{}</summary>\n{}{}{}<p class=\"quiet\">Blurred RMSE is how far they "
      "are "
      "apart once both are blurred by 4 pixels, 1 for black and white. FLIP is how different they look to a "
      "person who flips between them, 0 to 1. Apart is the largest distance of a point from the "
      "reference&#39;s, in per cent of the longest strand, or of a scene without strands.</p>\n</details>\n",
      {open ? html(" open=\"\"") : Html{}, heading,
       ending == RunEnding::breaks_off ? ", until it breaks off" : ": FLIP up to " + shown_distance(flip),
       rows, film(exercise.motions.film),
       link_to_run(exercise, "apart=1", place.runs, "Both runs, from where they differ by more than 1 %")});
}

std::string run_page(const SubmissionResult& result, const ExerciseResult& exercise,
                     const NamesForPeople& people) {
  const std::string whose = shown_name(result.name, people);
  const Html measured =
      moments(exercise, "As measured", run_breaks_off(exercise) ? RunEnding::breaks_off : RunEnding::whole,
              whose, {});
  return hair::view_page({{exercise.id + " of " + whose, exercise.motions.student},
                          {"the reference", exercise.motions.reference}},
                         measured);
}

Html pictures_by_distance(const std::vector<SubmissionResult>& results, const PicturePlace& place,
                          const NamesForPeople& people) {
  const std::vector<Worst> all = worst_first(results);
  if (all.empty()) return {};
  std::size_t same = 0;
  Html rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].breaks_off || all[i].flip() > 0)
      rows += row(all[i], i < kMostSmallPictures, place, people);
    else
      ++same;
  }
  Html section = html(R"(<section id="pictures">
<h2>Pictures, furthest from the reference&#39;s first</h2>
<p class="quiet">Of each submission the worst of its graded runs: one that breaks off, or else that of the picture with the largest FLIP. The same as the reference&#39;s in all pictures: {}. Without pictures: {}.</p>
)",
                      {same, results.size() - all.size()});
  if (!rows.text.empty())
    section += html(R"(<div class="wide"><table>
<thead><tr><th scope="col">Submission</th><th scope="col" class="number" data-sort="number">FLIP</th><th scope="col" class="number" data-sort="number">Blurred RMSE</th><th scope="col" class="number" data-sort="number">Apart, % of a strand</th><th scope="col" class="number" data-sort="number">Points lost</th><th scope="col">Where</th><th scope="col">Theirs</th><th scope="col">The reference&#39;s</th><th scope="col">Difference {}</th></tr></thead>
<tbody>
{}</tbody>
</table></div>
)",
                    {heat_scale(), rows});
  return section += html("</section>\n");
}

}  // namespace grader::report
