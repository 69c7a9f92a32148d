#include "hair/lab/commands/groom_commands.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "hair/groom/groom_file.h"
#include "hair/groom/groom_measures.h"
#include "hair/groom/resample.h"
#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/grow.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"

namespace hair {

namespace {

std::string four_digits(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

std::string left(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

constexpr std::size_t kName = 20, kColumn = 12;

std::string row(const std::string& name, const Spread& spread) {
  std::string line = "  " + left(name, kName);
  for (const double number : {spread.min, spread.median, spread.mean, spread.most, spread.max})
    line += right(four_digits(number), kColumn);
  return line + "\n";
}

std::string line_of(const std::string& name, const std::string& what) {
  return "  " + left(name, kName) + what + "\n";
}

std::string of_box(const Eigen::AlignedBox3d& box) {
  std::string text;
  for (int k = 0; k < 3; ++k)
    text += std::string(k > 0 ? ", " : "") + "xyz"[k] + " " + four_digits(box.min()[k]) + " to " +
            four_digits(box.max()[k]);
  return text;
}

// The text of a .hair file, up to its first zero.
std::string info_of(const GroomLook& look) {
  const std::string all(look.info.begin(), look.info.end());
  return printable(all.substr(0, all.find('\0')));
}

std::string of_look(const GroomLook& look) {
  std::string text;
  for (const LookPart& part : parts_of(look)) {
    std::string numbers;
    for (const float number : part.of_all)
      numbers += (numbers.empty() ? "" : ", ") + four_digits(static_cast<double>(number));
    text += (text.empty() ? "" : ", ") + std::string(part.name) + " " +
            (!part.is_known()          ? "not known"
             : !part.of_each.empty()   ? "of each point"
             : part.of_all.size() == 1 ? numbers
                                       : "(" + numbers + ")");
  }
  return text;
}

std::string of_unit(const GroomMeasures& measures) {
  const double unit = measures.unit_guess;
  if (unit == 0) return "can't be guessed: too few roots";
  const std::string length = unit >= 0.5     ? four_digits(unit) + " m"
                             : unit >= 0.005 ? four_digits(100 * unit) + " cm"
                                             : four_digits(1000 * unit) + " mm";
  return "about " + length + ", if the roots span a scalp of 20 cm";
}

std::string of_sphere(const std::optional<RootSphere>& sphere) {
  if (!sphere) return "none: they are few, or on a plane";
  const Vector3d& at = sphere->centre;
  return "centre (" + four_digits(at.x()) + ", " + four_digits(at.y()) + ", " + four_digits(at.z()) +
         "), radius " + four_digits(sphere->radius);
}

std::string in_groups(long number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string counted_with_groups(long count, const std::string& singular) {
  return in_groups(count) + " " + singular + (count == 1 ? "" : "s");
}

std::string counts_of(const Groom& groom) {
  return counted_with_groups(static_cast<long>(groom.strands.size()), "strand") + ", " +
         counted_with_groups(points_of(groom), "point");
}

// Some lines; the last one names oddities.
std::string groom_info(const std::string& name, const Groom& groom, const GroomMeasures& measures) {
  std::string text = printable(name, 4096) + ": " + counts_of(groom) + "\n\n  " + left("", kName);
  for (const char* const column : {"min", "median", "mean", "90 % below", "max"})
    text += right(column, kColumn);
  text += "\n";
  text += row("points of a strand", measures.points_of_strand);
  text += row("length", measures.length);
  text += row("segment", measures.segment);
  text += row("curvature, 1/length", measures.curvature);
  text += row("bend, degrees", measures.bend) + "\n";
  text += line_of("box", of_box(measures.box));
  text += line_of("box of the roots", of_box(measures.roots));
  text += line_of("sphere of the roots", of_sphere(measures.root_sphere));
  text += line_of("unit", of_unit(measures));
  text += line_of("look", of_look(groom.look));
  if (const std::string info = info_of(groom.look); !info.empty())
    text += line_of("text", "\"" + info + "\"");
  text += "\n";
  if (measures.odd.empty()) text += line_of("odd", "nothing");
  for (const Oddity& one : measures.odd)
    text += line_of(&one == measures.odd.data() ? "odd" : "", in_groups(one.count) + " " + one.what +
                                                                  " (strand " + std::to_string(one.strand) +
                                                                  (one.count > 1 ? " first)" : ")"));
  return text;
}

}  // namespace

int convert_groom(const ConvertOptions& options) {
  // The command line accepts nan.
  if (!(options.scale > 0)) throw BadInput("--scale: is not a number from 1e-09 to 1e+09");
  check_groom_name(options.out);
  check_folder_of(options.out);
  Groom groom = read_groom(options.in);
  keep_every(groom, options.every);
  if (options.points > 0) {
    const auto strands = static_cast<long>(groom.strands.size());
    if (strands > kMostGroomPoints / options.points)
      throw BadInput("--points: " + in_groups(strands) + " strands of " + std::to_string(options.points) +
                     " points are more than the " + in_groups(kMostGroomPoints) +
                     " that a groom has at most");
    resample(groom, options.points);
  }
  if (options.scale != 1) scale(groom, options.scale);
  write_groom(groom, options.out);
  std::cout << printable(options.out.string(), 4096) << ": " << counts_of(groom) << "\n";
  return 0;
}

int show_groom(const std::filesystem::path& file) {
  const Groom groom = read_groom(file, Numbers::any);
  std::cout << groom_info(file.string(), groom, measure_groom(groom));
  return 0;
}

int write_grown_groom(const GrowOptions& options) {
  const HairStyle* const style = find_hair_style(options.style);
  if (!style) {
    std::string known;
    for (const HairStyle& one : hair_styles()) known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw BadInput("there is no style \"" + printable(options.style) + "\"; there are " + known);
  }
  check_groom_name(options.out);  // refuses the name before the work starts
  check_folder_of(options.out);
  Groom groom;
  try {
    const std::unique_ptr<Head> head = options.head == "ellipsoid"
                                           ? std::unique_ptr<Head>(std::make_unique<EllipsoidHead>())
                                           : std::make_unique<Bust>();
    groom = grow_groom(*head, *style, {options.strands, options.points, options.seed});
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
  write_groom(groom, options.out);
  std::cout << printable(options.out.string(), 4096) << ": " << counts_of(groom) << ", in metres\n";
  return 0;
}

}  // namespace hair
