#include "hair/groom/ply_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>

#include "hair/groom/groom_bytes.h"
#include "hair/groom/ply_rows.h"

namespace hair {

namespace {

// The content of a file, before it is put together.
struct Parts {
  std::vector<double> points;  // 3 for each vertex
  GroomLook look;
  std::vector<std::uint32_t> segments;
};

// The number that means 1 in a colour's properties; 0 if this type can't store colours.
float whole_colour(const PlyType& type) {
  if (!type.whole) return 1;
  return type.least == 0 && type.size <= 2 ? static_cast<float>(type.most) : 0;
}

// Properties of each vertex that go to one array, one after the other.
struct Column {
  std::vector<float>* to;
  float whole;  // the number that means 1
  std::vector<std::size_t> from;
};

// The columns of the look's properties that the element has.
std::vector<Column> look_columns(const PlyElement& element, GroomLook& look) {
  std::vector<Column> columns;
  const auto add = [&](std::vector<float>& to, std::initializer_list<const char*> names, bool colour) {
    Column column{&to, 1, {}};
    for (const char* const name : names) {
      const int at = element.find(name);
      if (at < 0) return;
      column.from.push_back(static_cast<std::size_t>(at));
      const float whole = colour ? whole_colour(*element.properties[column.from.back()].type) : 1;
      if (whole == 0 || (column.from.size() > 1 && whole != column.whole)) return;
      column.whole = whole;
    }
    to.reserve(column.from.size() * element.count);
    columns.push_back(std::move(column));
  };
  add(look.colours, {"red", "green", "blue"}, true);
  add(look.transparencies, {"alpha"}, true);
  add(look.thicknesses, {"thickness"}, false);
  return columns;
}

void read_vertices(PlyRows& rows, const PlyElement& element, Numbers numbers, Parts& parts) {
  const std::array at = {element.find("x"), element.find("y"), element.find("z")};
  if (std::find(at.begin(), at.end(), -1) != at.end()) rows.fail("its vertices lack x, y or z");
  if (element.count > static_cast<std::size_t>(kMostGroomPoints))
    rows.fail("has " + std::to_string(element.count) + " vertices; at most " +
              std::to_string(kMostGroomPoints) + " are read");
  parts.points.reserve(3 * element.count);
  const std::vector<Column> columns = look_columns(element, parts.look);
  std::vector<std::size_t> read(at.begin(), at.end());
  for (const Column& column : columns) read.insert(read.end(), column.from.begin(), column.from.end());
  std::vector<double> row;
  for (std::size_t i = 0; i < element.count; ++i) {
    rows.read(element, row);
    for (const std::size_t k : read)
      if (numbers == Numbers::finite && !fits_float(row[k]))
        rows.fail_here("vertex " + std::to_string(i) + " has a number that is not finite");
    for (const int k : at) parts.points.push_back(row[static_cast<std::size_t>(k)]);
    for (const Column& column : columns)
      for (const std::size_t k : column.from) column.to->push_back(static_cast<float>(row[k]) / column.whole);
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
    if (!(segments >= 0 && segments < kMostGroomPoints && segments == std::floor(segments)))
      rows.fail_here("strand " + std::to_string(i) + " has a number of segments that is not 0, 1, 2, ...");
    points += static_cast<std::uint64_t>(segments) + 1;
    if (points > static_cast<std::uint64_t>(kMostGroomPoints))
      rows.fail_here("with strand " + std::to_string(i) + " there are more than " +
                     std::to_string(kMostGroomPoints) + " points; no more are read");
    parts.segments.push_back(static_cast<std::uint32_t>(segments));
  }
}

std::uint32_t in_u8(float value) {
  return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

// A part of the look as properties of each vertex.
struct Look {
  LookPart part;
  std::vector<const char*> names;
  bool is_u8;

  std::span<const float> at(std::size_t vertex) const {
    return part.of_each.empty() ? part.of_all : part.of_each.subspan(part.size * vertex, part.size);
  }
};

std::vector<Look> looks_of(const GroomLook& look) {
  const auto fits_u8 = [](float value) { return static_cast<float>(in_u8(value)) / 255 == value; };
  const auto [thickness, transparency, colour] = parts_of(look);
  std::vector<Look> looks;
  const auto add = [&](const LookPart& part, std::vector<const char*> names, bool as_colour) {
    const std::span<const float> all = part.numbers();
    const bool is_u8 = as_colour && std::all_of(all.begin(), all.end(), fits_u8);
    if (part.is_known()) looks.push_back({part, std::move(names), is_u8});
  };
  add(colour, {"red", "green", "blue"}, true);
  // Some programs do not show hair with an alpha of 0: opaque hair gets no alpha.
  if (look.transparency != 0.0F || !look.transparencies.empty()) add(transparency, {"alpha"}, true);
  add(thickness, {"thickness"}, false);
  return looks;
}

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
  groom.look = std::move(parts.look);
  return groom;
}

std::string ply_file_of(const Groom& groom) {
  check_writable(groom);
  const std::vector<Look> looks = looks_of(groom.look);
  const auto points = static_cast<std::uint32_t>(points_of(groom));
  const auto strands = static_cast<std::uint32_t>(groom.strands.size());
  Eigen::Index longest = 0;
  for (const Eigen::VectorXd& x : groom.strands) longest = std::max(longest, points_of(x) - 1);
  const bool is_short = longest <= std::numeric_limits<std::uint16_t>::max();

  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points);
  out += "\nproperty float x\nproperty float y\nproperty float z\n";
  for (const Look& look : looks)
    for (const char* const name : look.names)
      out += std::string("property ") + (look.is_u8 ? "uchar " : "float ") + name + "\n";
  out += "element strand " + std::to_string(strands) + "\nproperty " + (is_short ? "ushort" : "uint") +
         " nsegs\n";
  out += "element edge " + std::to_string(points - strands);
  out += "\nproperty int vertex1\nproperty int vertex2\nend_header\n";

  std::size_t vertex = 0;
  for (const Eigen::VectorXd& x : groom.strands)
    for (Eigen::Index k = 0; k < x.size(); k += 3, ++vertex) {
      for (Eigen::Index i = 0; i < 3; ++i) put_real(out, static_cast<float>(x[k + i]));
      for (const Look& look : looks)
        for (const float value : look.at(vertex))
          look.is_u8 ? put_number(out, in_u8(value), 1) : put_real(out, value);
    }
  for (const Eigen::VectorXd& x : groom.strands)
    put_number(out, static_cast<std::uint32_t>(points_of(x) - 1), is_short ? 2 : 4);
  std::uint32_t first = 0;
  for (const Eigen::VectorXd& x : groom.strands) {
    for (Eigen::Index k = 1; k < points_of(x); ++k, ++first) {
      put_number(out, first);
      put_number(out, first + 1);
    }
    ++first;
  }
  return out;
}

}  // namespace hair
