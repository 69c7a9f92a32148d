#include "hair/lab/commands/groom_commands.h"

#include <iostream>
#include <memory>
#include <stdexcept>

#include "hair/groom/groom_edit.h"
#include "hair/groom/groom_file.h"
#include "hair/groom/resample.h"
#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/head/grow.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/commands/groom_info.h"

namespace hair {

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
