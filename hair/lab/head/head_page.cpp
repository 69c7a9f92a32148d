#include "hair/lab/head/head_record.h"

#include <algorithm>

#include "hair/io/plot/figure.h"
#include "hair/io/plot/html.h"

namespace hair::head_study {
namespace {

constexpr std::size_t kInterpolate = 0;  // an index of kModes
constexpr double kLeast = 1e-6;          // smallest value of a figure: mm, and s

std::string mm(double metres) {
  return to_text(1e3 * metres);
}

std::string ms(double seconds) {
  return to_text(1e3 * seconds);
}

std::string place_of(const HeadCase& one) {
  return one.collides ? "on a head" : "without a head";
}

Point point_of(const GuideRun& run, std::size_t mode, double error) {
  return {std::max(run.seconds(mode), kLeast), std::max(1e3 * error, kLeast),
          std::to_string(run.guides) + " guides"};
}

Figure figure_of(const HeadCase& one) {
  Figure figure{
      "error-against-time-" + one.hair->id + (one.collides ? "-head" : "-free"),
      one.hair->title + " " + place_of(one) + ": error against run time",
      "The distance of hair that is made of guides from the same hair simulated, over the second in which "
      "the head moves, against the CPU time of that second. A point for each number of guides. The dashed "
      "line is the time of every strand simulated, which has no such error. Both axes are logarithmic.",
      {"CPU time for a second of motion, s"},
      {"RMS distance, mm"}};
  const auto add = [&](const std::string& name, std::size_t mode, HeadError HeadErrors::*of) {
    Series& series = figure.series.emplace_back(Series{name, {}});
    for (const GuideRun& run : one.runs)
      series.points.push_back(point_of(run, mode, (run.modes[mode].errors.*of).rms));
  };
  for (std::size_t m = 0; m < kModes.size(); ++m) add(kModes[m].id, m, &HeadErrors::all);
  add("interpolate, motion alone", kInterpolate, &HeadErrors::motion);
  double low = 1 / kLeast, high = kLeast;
  for (const Series& series : figure.series)
    for (const Point& point : series.points) low = std::min(low, point.y), high = std::max(high, point.y);
  if (one.runs.empty()) return figure;
  const double x = std::max(one.seconds, kLeast);
  figure.series.push_back({"every strand simulated", {{x, low, {}}, {x, high, {}}}, true, false, true, {}});
  return figure;
}

std::string caption_of(const HeadCase& one, std::size_t mode) {
  return one.hair->title + " " + place_of(one) + ", " + kModes[mode].id + ": " + std::to_string(one.strands) +
         " strands, " + mm(one.length) + " mm long in the mean";
}

// A head's costs and errors.
Table table_of(const HeadCase& one) {
  Table table{
      caption_of(one, kInterpolate) + "; ms of CPU time for a second of motion, RMS distances of all moments",
      {"guides", "simulation", "synthesis", "together", "error, mm", "% of the length", "motion alone, mm"},
      {}};
  for (const GuideRun& run : one.runs) {
    const HeadErrors& e = run.modes[kInterpolate].errors;
    table.rows.push_back({std::to_string(run.guides), ms(run.simulation),
                          ms(run.modes[kInterpolate].synthesis), ms(run.seconds(kInterpolate)), mm(e.all.rms),
                          to_text(100 * e.all.rms / one.length), mm(e.motion.rms)});
  }
  table.rows.push_back({std::to_string(one.strands), ms(one.seconds), "0", ms(one.seconds), "0", "0", "0"});
  return table;
}

// All errors, in mm, and the time together.
void add_errors(const HeadCase& one, std::size_t mode, std::vector<Table>& tables) {
  std::vector<Row> rows;
  for (const GuideRun& run : one.runs)
    rows.push_back(Row{{"guides", "", run.guides}, {"seconds", "", run.seconds(mode), {"ms", 1e3}}} +
                   row_of_mode(run.modes[mode]));
  add_table(tables, rows, caption_of(one, mode) + "; errors in mm");
}

Table answer(const HeadStudy& study) {
  Table table{
      "Interpolated, of all moments: RMS distance in mm, in brackets of the motion alone; CPU time for a "
      "second of motion, s; and how many times as long a strand takes to simulate as to interpolate",
      {"hair", "by", "strands", "100 guides", "s", "1,000 guides", "s", "every strand, s", "times"},
      {}};
  for (const HeadCase& one : study.cases) {
    std::vector<std::string> row = {one.hair->title + " " + place_of(one), "exercises",
                                    std::to_string(one.strands)};
    for (const int guides : {100, 1'000}) {
      const auto run = std::ranges::find(one.runs, guides, &GuideRun::guides);
      if (run == one.runs.end()) {
        row.insert(row.end(), 2, "");
        continue;
      }
      const HeadErrors& e = run->modes[kInterpolate].errors;
      row.push_back(mm(e.all.rms) + " (" + mm(e.motion.rms) + ")");
      row.push_back(to_text(run->seconds(kInterpolate)));
    }
    row.push_back(to_text(one.seconds));
    row.push_back(one.runs.empty() ? ""
                                   : to_text(one.seconds / one.runs.front().modes[kInterpolate].synthesis));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string figure_of(const HeadStudy& study, const std::string& hair) {
  Html all = html("<div class=\"pictures\">\n");
  std::vector<HeadPicture> pictures = study.pictures;
  std::ranges::sort(pictures, [](const HeadPicture& a, const HeadPicture& b) { return a.guides < b.guides; });
  for (const HeadPicture& picture : pictures) {
    if (picture.hair != hair) continue;
    const auto& one =
        *std::ranges::find_if(study.cases, [&](const HeadCase& each) { return each.hair->id == hair; });
    const std::string says = picture.guides >= one.strands
                                 ? "every strand simulated, " + std::to_string(one.strands)
                                 : "interpolated from " + std::to_string(picture.guides) + " guides";
    all += html("<figure><img src=\"{}\" alt=\"{}\"/><figcaption>{}</figcaption></figure>\n",
                {picture.file, "The head while it turns: " + says, says});
  }
  return (all += html("</div>\n")).text;
}

// A section for each hair, its cases one after the other.
Section section_of(const HeadStudy& study, const std::string& id) {
  Section section;
  for (const HeadCase& one : study.cases) {
    if (one.hair->id != id) continue;
    section.heading = one.hair->title;
    section.first.push_back(table_of(one));
    section.figures.push_back(to_svg(figure_of(one)));
    for (std::size_t m = 0; m < kModes.size(); ++m) add_errors(one, m, section.tables);
  }
  if (std::ranges::any_of(study.pictures, [&](const HeadPicture& picture) { return picture.hair == id; }))
    section.figures.push_back(figure_of(study, id));
  return section;
}

}  // namespace

Page head_page(const HeadStudy& study) {
  Page page;
  page.title = "Why not simulate every single strand?";
  page.paragraphs = {
      "A head of hair turns by " + to_text(kTurn) +
          " degrees to one side and back, within a second. Once every strand is simulated; and beside that, "
          "with the same steps, only some of them, the guides, and all strands are made of these by "
          "synthesis (H10). The error is how far these are from the same strands simulated.",
      "Straight hair is straight at rest and lies as weight and head let it; 'all alike' has no clumps, and "
      "no differences of length and direction. Wavy and curly hair rests as it grew.",
      "The exercises (H1, H2, H4) step one strand at a time, and so there are fewer strands than on a real "
      "head.",
      "Times are CPU times, of " + std::to_string(kMoving) + " frames with " +
          std::to_string(kStepsPerFrame) +
          " steps each, and of a synthesis for each frame. 'Start': as the head begins to move. 'All': of "
          "all frames after that. 'Motion alone': as if each strand were given its own shape once, at the "
          "start. '95 %': of the strands are not farther off, at the worst moment."};
  page.picture_files = !study.pictures.empty();
  if (!study.no_pictures.empty())
    page.paragraphs.push_back("There are no pictures: " + study.no_pictures + ".");
  page.sections.push_back({"The answer in numbers", {}, {}, {}, {answer(study)}});
  std::vector<std::string> ids;
  for (const HeadCase& one : study.cases)
    if (ids.empty() || ids.back() != one.hair->id) ids.push_back(one.hair->id);
  for (const std::string& id : ids) page.sections.push_back(section_of(study, id));
  return page;
}

}  // namespace hair::head_study
