#include "hair/head/ply_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "hair/head/groom_bytes.h"
#include "hair/head/ply_rows.h"

namespace hair {

namespace {

// What a file says, before it is put together.
struct Parts {
  std::vector<double> points;  // 3 for each vertex
  std::vector<float> colours;  // 3 for each, or none
  std::vector<std::uint32_t> segments;
};

void read_vertices(PlyRows& rows, const PlyElement& element, Numbers numbers, Parts& parts) {
  const std::array at = {element.find("x"), element.find("y"), element.find("z")};
  if (std::find(at.begin(), at.end(), -1) != at.end()) rows.fail("its vertices lack x, y or z");
  const std::array colour = {element.find("red"), element.find("green"), element.find("blue")};
  const bool coloured = std::find(colour.begin(), colour.end(), -1) == colour.end() &&
                        std::all_of(colour.begin(), colour.end(), [&](int i) {
                          return element.properties[static_cast<std::size_t>(i)].type == PlyType::u8;
                        });
  if (element.count > static_cast<std::size_t>(kMostGroomPoints))
    rows.fail("has " + std::to_string(element.count) + " vertices; at most " +
              std::to_string(kMostGroomPoints) + " are read");
  parts.points.reserve(3 * element.count);
  if (coloured) parts.colours.reserve(3 * element.count);
  std::vector<double> row;
  for (std::size_t i = 0; i < element.count; ++i) {
    rows.read(element, row);
    for (const int k : at) {
      const double value = row[static_cast<std::size_t>(k)];
      if (numbers == Numbers::finite && !fits_float(value))
        rows.fail_here("vertex " + std::to_string(i) + " has a number that is not finite");
      parts.points.push_back(value);
    }
    if (coloured)
      for (const int k : colour)
        parts.colours.push_back(static_cast<float>(row[static_cast<std::size_t>(k)] / 255));
  }
}

void read_strands(PlyRows& rows, const PlyElement& element, Parts& parts) {
  const int at = element.find("nsegs");
  if (at < 0) rows.fail("its strands lack nsegs, the number of their segments");
  parts.segments.reserve(element.count);
  std::vector<double> row;
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < element.count; ++i) {
    rows.read(element, row);
    const double segments = row[static_cast<std::size_t>(at)];
    if (!(segments >= 1 && segments < kMostGroomPoints && segments == std::floor(segments)))
      rows.fail_here("strand " + std::to_string(i) +
                     " has a number of segments that is not 1, 2, ...; a strand has two points at least");
    points += static_cast<std::uint64_t>(segments) + 1;
    if (points > static_cast<std::uint64_t>(kMostGroomPoints))
      rows.fail_here("with strand " + std::to_string(i) + " there are more than " +
                     std::to_string(kMostGroomPoints) + " points; no more are read");
    parts.segments.push_back(static_cast<std::uint32_t>(segments));
  }
}

void put_text(std::string& text, auto number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

// Numbers of a row, as text or in binary.
class RowsOut {
 public:
  RowsOut(std::string& out, bool ascii) : out_(out), ascii_(ascii) {}
  void real(double number) {
    const auto value = static_cast<float>(number);
    ascii_ ? word(value) : put_real(out_, value);
  }
  void whole(std::uint32_t number, int size) { ascii_ ? word(number) : put_number(out_, number, size); }
  void end_row() {
    if (ascii_) out_.back() = '\n';
  }

 private:
  void word(auto number) {
    put_text(out_, number);
    out_ += ' ';
  }
  std::string& out_;
  bool ascii_;
};

}  // namespace

Groom parse_ply_file(std::string_view bytes, const std::string& name, Numbers numbers) {
  PlyRows rows(bytes, name);
  const auto count = [&](std::string_view element) {
    return std::count_if(rows.elements().begin(), rows.elements().end(),
                         [&](const PlyElement& one) { return one.name == element; });
  };
  if (count("strand") != 1 || count("vertex") != 1)
    rows.fail("does not have one element \"vertex\" and one \"strand\": it is no groom" +
              std::string(count("face") > 0 ? ", but a mesh" : ""));
  Parts parts;
  std::vector<double> row;
  for (const PlyElement& element : rows.elements()) {
    if (element.name == "vertex")
      read_vertices(rows, element, numbers, parts);
    else if (element.name == "strand")
      read_strands(rows, element, parts);
    else
      for (std::size_t i = 0; i < element.count; ++i) rows.read(element, row);
  }
  rows.expect_end();
  if (parts.segments.empty()) rows.fail("has no strands; a groom has one at least");
  std::uint64_t sum = 0;
  for (const std::uint32_t segments : parts.segments) sum += std::uint64_t{segments} + 1;
  if (3 * sum != parts.points.size())
    rows.fail("has " + std::to_string(parts.points.size() / 3) + " vertices, and its strands have " +
              std::to_string(sum) + "; it is damaged");
  Groom groom;
  groom.strands.reserve(parts.segments.size());
  const double* at = parts.points.data();
  for (const std::uint32_t segments : parts.segments) {
    const Eigen::Index size = 3 * (static_cast<Eigen::Index>(segments) + 1);
    groom.strands.emplace_back(Eigen::Map<const Eigen::VectorXd>(at, size));
    at += size;
  }
  groom.look.colours = std::move(parts.colours);
  return groom;
}

std::string ply_file_of(const Groom& groom, bool ascii) {
  check_writable(groom, 2);
  const std::vector<float>& colours = groom.look.colours;
  const auto points = static_cast<std::uint32_t>(points_of(groom));
  const auto strands = static_cast<std::uint32_t>(groom.strands.size());
  Eigen::Index longest = 0;
  for (const Eigen::VectorXd& x : groom.strands) longest = std::max(longest, points_of(x) - 1);
  const bool is_short = longest <= std::numeric_limits<std::uint16_t>::max();

  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
  out += "element vertex " + std::to_string(points);
  out += "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!colours.empty()) out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out += "element strand " + std::to_string(strands) + "\nproperty " + (is_short ? "ushort" : "uint") +
         " nsegs\n";
  out += "element edge " + std::to_string(points - strands);
  out += "\nproperty int vertex1\nproperty int vertex2\nend_header\n";

  RowsOut rows(out, ascii);
  std::size_t vertex = 0;
  for (const Eigen::VectorXd& x : groom.strands)
    for (Eigen::Index k = 0; k < x.size(); k += 3, ++vertex) {
      for (Eigen::Index i = 0; i < 3; ++i) rows.real(x[k + i]);
      if (!colours.empty())
        for (std::size_t i = 0; i < 3; ++i)
          rows.whole(
              static_cast<std::uint32_t>(std::lround(255 * std::clamp(colours[3 * vertex + i], 0.0F, 1.0F))),
              1);
      rows.end_row();
    }
  for (const Eigen::VectorXd& x : groom.strands) {
    rows.whole(static_cast<std::uint32_t>(points_of(x) - 1), is_short ? 2 : 4);
    rows.end_row();
  }
  std::uint32_t first = 0;
  for (const Eigen::VectorXd& x : groom.strands) {
    for (Eigen::Index k = 1; k < points_of(x); ++k, ++first) {
      rows.whole(first, 4);
      rows.whole(first + 1, 4);
      rows.end_row();
    }
    ++first;
  }
  return out;
}

}  // namespace hair
