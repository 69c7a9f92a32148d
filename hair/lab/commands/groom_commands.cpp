#include "hair/lab/commands/groom_commands.h"

#include <iostream>
#include <memory>
#include <stdexcept>

#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/groom_edit.h"
#include "hair/head/groom_file.h"
#include "hair/head/grow.h"
#include "hair/head/resample.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/commands/groom_info.h"

namespace hair {

namespace {

// The command line refuses all but what is not a number.
void check_number(const std::string& option, double number) {
  if (!(number > 0)) throw BadInput(option + ": is not a number from 1e-09 to 1e+09");
}

void print_list(const std::string& name, const std::vector<std::string>& all) {
  for (const std::string& one : all) std::cout << (&one == all.data() ? name + ": " : ", ") << printable(one);
  if (!all.empty()) std::cout << "\n";
}

}  // namespace

int convert_groom(const ConvertOptions& options) {
  check_number("--scale", options.scale);
  check_number("--unit", options.unit);
  const bool bald_roots = can_write_bald_roots(options.out);
  check_folder_of(options.out);
  Groom groom = read_groom(options.in);
  keep_every(groom, options.every);
  const std::vector<std::string> lost = lost_in(options.out, groom);
  const long dropped = bald_roots ? 0 : drop_bald_roots(groom);
  if (groom.strands.empty())
    throw BadInput(printable(options.in.string(), 4096) +
                   ": has bald roots only among the strands that are taken; .usda files hold none");
  if (options.points > 0) {
    const auto strands = static_cast<long>(groom.strands.size());
    if (strands > kMostGroomPoints / options.points)
      throw BadInput("--points: " + in_groups(strands) + " strands of " + std::to_string(options.points) +
                     " points are more than the " + in_groups(kMostGroomPoints) +
                     " that a groom has at most");
    resample(groom, options.points);
  }
  if (options.scale != 1) scale(groom, options.scale);
  write_groom(groom, options.out,
              {.ascii = options.ascii,
               .usda = {.cubic = options.cubic, .unit = options.unit, .z_is_up = !options.y_is_up}});
  std::cout << printable(options.out.string(), 4096) << ": " << counts_of(groom) << "\n";
  if (dropped > 0)
    std::cout << "left out: " << counted_with_groups(dropped, "bald root") << "; .usda files have none\n";
  print_list("left out", lost);
  print_list("not known", unknown_in(options.out, groom));
  return 0;
}

int show_groom(const InfoOptions& options) {
  const Groom groom = read_groom(options.file, Numbers::any);
  const GroomMeasures measures = measure_groom(groom);
  const std::string name = options.file.string();
  std::cout << (options.json ? groom_info_json(name, groom, measures) : groom_info(name, groom, measures));
  return 0;
}

int write_grown_groom(const GrowOptions& options) {
  const HairStyle* const style = find_hair_style(options.style);
  if (!style) {
    std::string known;
    for (const HairStyle& one : hair_styles()) known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw BadInput("there is no style \"" + printable(options.style) + "\"; there are " + known);
  }
  can_write_bald_roots(options.out);  // refuses the name before there is work
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
