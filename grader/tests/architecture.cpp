// STAFF ONLY. Draws the folders, and the arrows between them.
#include "grader/tests/architecture.h"

#include <algorithm>
#include <stdexcept>

#include "hair/io/plot/look.h"
#include "hair/io/plot/xml.h"

namespace grader {
namespace {

using hair::plot::Attributes, hair::plot::XmlWriter;

constexpr double kLeft = 20, kTop = 70, kWidth = 168, kHeight = 92, kAcross = 290, kDown = 150;
constexpr double kLine = 17, kTip = 6;
constexpr double kPictureWidth = 2 * kLeft + 5 * kAcross + kWidth;
constexpr double kPictureHeight = kTop + 3 * kDown + kHeight + 20;

double left_of(const Room& room) {
  return kLeft + kAcross * room.column;
}
double top_of(const Room& room) {
  return kTop + kDown * room.row;
}

const Room& room_of(const std::string& folder) {
  const auto found =
      std::find_if(rooms().begin(), rooms().end(), [&](const Room& room) { return room.folder == folder; });
  if (found == rooms().end()) throw std::logic_error("an arrow at " + folder + ", which is no room");
  return *found;
}

void say(XmlWriter& xml, double x, double y, const std::string& text, const char* anchor,
         const char* weight = "normal") {
  xml.leaf("text", {{"x", x}, {"y", y}, {"text-anchor", anchor}, {"font-weight", weight}}, text);
}

void draw(XmlWriter& xml, const Room& room) {
  const double x = left_of(room), y = top_of(room);
  xml.empty("rect", {{"x", x},
                     {"y", y},
                     {"width", kWidth},
                     {"height", kHeight},
                     {"rx", 6.0},
                     {"fill", room.sandboxed ? "#fff1dc" : "#eef4fb"},
                     {"stroke", hair::plot::kText},
                     {"stroke-dasharray", room.sandboxed ? "6 3" : "none"}});
  say(xml, x + kWidth / 2, y + 20, room.folder + "/", "middle", "bold");
  for (std::size_t i = 0; i < room.lines.size(); ++i)
    say(xml, x + kWidth / 2, y + 20 + kLine * static_cast<double>(i + 1), room.lines[i], "middle");
}

// Draws a line from (x, y) to the right, or down; with heads at one end or both.
void draw_line(XmlWriter& xml, double x, double y, double to_x, double to_y, bool at_begin, bool at_end) {
  using hair::plot::pixels;
  xml.empty("path", {{"d", "M" + pixels(x) + " " + pixels(y) + "L" + pixels(to_x) + " " + pixels(to_y)},
                     {"stroke", hair::plot::kText}});
  const bool across = y == to_y;
  const auto head = [&](double tip_x, double tip_y, double way) {
    const double back_x = across ? tip_x - way * kTip : tip_x, back_y = across ? tip_y : tip_y - way * kTip;
    const double side_x = across ? 0 : kTip / 2, side_y = across ? kTip / 2 : 0;
    xml.empty("path", {{"d", "M" + pixels(tip_x) + " " + pixels(tip_y) + "L" + pixels(back_x + side_x) + " " +
                                 pixels(back_y + side_y) + "L" + pixels(back_x - side_x) + " " +
                                 pixels(back_y - side_y) + "Z"},
                       {"fill", hair::plot::kText}});
  };
  const double way = across ? (to_x > x ? 1 : -1) : (to_y > y ? 1 : -1);
  if (at_end) head(to_x, to_y, way);
  if (at_begin) head(x, y, -way);
}

void draw(XmlWriter& xml, const Arrow& arrow) {
  const Room &from = room_of(arrow.from), &to = room_of(arrow.to);
  if (from.row == to.row) {
    const double y = top_of(from) + kHeight / 2;
    draw_line(xml, left_of(from) + kWidth + 2, y, left_of(to) - 2, y, arrow.and_back, true);
    const double middle = (left_of(from) + kWidth + left_of(to)) / 2;
    say(xml, middle, y - 6, arrow.what, "middle");
  } else {
    if (from.column != to.column)
      throw std::logic_error("an arrow askew, from " + arrow.from + " to " + arrow.to);
    const bool down = to.row > from.row;
    const double x = left_of(from) + kWidth / 2, begin = top_of(from) + (down ? kHeight + 2 : -2),
                 end = top_of(to) + (down ? -2 : kHeight + 2);
    draw_line(xml, x, begin, x, end, arrow.and_back, true);
    say(xml, x + 7, (begin + end) / 2 + 4, arrow.what, "start");
  }
}

}  // namespace

const std::vector<Room>& rooms() {
  static const std::vector<Room> all = {
      {"grader/sandbox", {"namespaces, limits,", "system call filter"}, 1, 0},
      {"grader/class_folder", {"a class, in parallel,", "into one folder"}, 2, 0},
      {"grader/grading", {"one hand-in: starts", "all that it needs"}, 3, 0},
      {"grader/course", {"exercises, roles,", "points: a JSON file"}, 4, 0},
      {"grader/intake", {"reads archives,", "finds the owner", "of each file"}, 0, 1, true},
      {"grader/compile", {"a file becomes", "a shared object"}, 1, 1, true},
      {"grader/worker", {"student's object,", "and a server made", "of reference/*/calls.h"}, 2, 1, true},
      {"grader/judge", {"calls, compares with", "reference/, which has", "the cases, too"}, 3, 1},
      {"grader/result", {"points, costs, studies:", "fields declared once"}, 4, 1},
      {"grader/record", {"one SQLite file a class,", "from which all files", "are made"}, 5, 1},
      {"grader/report", {"pages, feedback,", "tables"}, 5, 0},
      {"grader/similar", {"code that several", "hand-ins share"}, 0, 2},
      {"grader/roster", {"expected people,", "owners of hand-ins"}, 4, 2},
      {"grader/gradebook", {"grades and feedback", "for learning systems"}, 5, 2},
      {"grader/judge/run", {"whole runs: a scene", "with one exercise", "run by the worker"}, 2, 2},
      {"grader/compare", {"the difference of", "two pictures"}, 3, 2},
      {"hair/scene", {"JSON becomes plain", "data, or an error", "of one line"}, 1, 3},
      {"hair/simulation", {"only the parts that", "the scene needs; uses", "solver/, particles/"}, 2, 3},
      {"hair/render", {"off screen, by OSMesa:", "strands, light, shadow"}, 3, 3},
      {"hair/io", {"files, PNG, figures,", "pages"}, 4, 3},
      {"hair/lab", {"hairlab: runs, studies,", "films, records"}, 5, 3},
  };
  return all;
}

const std::vector<Arrow>& arrows() {
  static const std::vector<Arrow> all = {
      {"grader/sandbox", "grader/compile", "isolates"},
      {"grader/class_folder", "grader/grading", "Submission"},
      {"grader/grading", "grader/judge", "SuiteJob"},
      {"grader/course", "grader/result", "weights"},
      {"grader/intake", "grader/compile", "Submission"},
      {"grader/compile", "grader/worker", "S1.so"},
      {"grader/worker", "grader/judge", "messages", true},
      {"grader/judge", "grader/result", "SuiteResult"},
      {"grader/result", "grader/record", "SubmissionResult"},
      {"grader/record", "grader/report", "Recorded"},
      {"grader/record", "grader/gradebook", "points"},
      {"grader/roster", "grader/gradebook", "people"},
      {"grader/intake", "grader/similar", "files"},
      {"grader/worker", "grader/judge/run", "calls, answers", true},
      {"grader/judge", "grader/compare", "pictures of both"},
      {"grader/judge/run", "hair/simulation", "runs"},
      {"grader/compare", "hair/render", "draws"},
      {"hair/scene", "hair/simulation", "Scene"},
      {"hair/simulation", "hair/render", "states"},
      {"hair/render", "hair/io", "Image"},
      {"hair/io", "hair/lab", "files"},
  };
  return all;
}

std::string architecture() {
  XmlWriter xml;
  xml.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox",
                    "0 0 " + hair::plot::pixels(kPictureWidth) + " " + hair::plot::pixels(kPictureHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"},
                   {"font-size", 13.0},
                   {"role", "img"}});
  xml.as_it_is("<!-- STAFF ONLY. Made by grader/tests/draw_architecture. -->");
  xml.leaf("title", {}, "The way of data: from an archive to a page, and from a scene to a picture");
  xml.empty("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
  say(xml, kLeft, 28, "From an archive to a page, above; from a scene to a picture, below", "start", "bold");
  say(xml, kLeft, 48, "Dashed: strangers' bytes and code, in a sandbox. The rest is ours.", "start");
  for (const Arrow& arrow : arrows()) draw(xml, arrow);
  for (const Room& room : rooms()) draw(xml, room);
  xml.close();
  return xml.take();
}

}  // namespace grader
