// The command lines of hairlab's commands for grooms.
#include <memory>

#include "hair/lab/commands/command.h"
#include "hair/lab/commands/groom_commands.h"
#include "hair/lab/commands/hand_over.h"

namespace hair {

Command add_convert_command(CLI::App& program) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* app = program.add_subcommand(kConvert.name, kConvert.what);
  app->add_option("IN", options->in, "A groom: .hair or .ply")->required();
  app->add_option("OUT", options->out, "The file to write: .hair or .ply")->required();
  app->add_option("--scale", options->scale, "Makes all points and thicknesses so many times as large")
      ->check(CLI::Range(1e-9, 1e9));
  app->add_option("--every", options->every, "Keeps the first of every so many strands")
      ->check(CLI::Range(1L, 1'000'000'000L));
  app->add_option("--points", options->points, "So many points for each strand, at equal distances along it")
      ->check(CLI::Range(2, 1'000'000));
  return {app, [options](const Course&) { return convert_groom(*options); }};
}

Command add_info_command(CLI::App& program) {
  const auto file = std::make_shared<std::filesystem::path>();
  CLI::App* app = program.add_subcommand(kInfo.name, kInfo.what);
  app->add_option("FILE", *file, "A groom: .hair or .ply")->required();
  return {app, [file](const Course&) { return show_groom(*file); }};
}

// As in scenes: doubles hold all whole numbers up to here.
constexpr std::int64_t kMostSeed = std::int64_t{1} << 53;

Command add_groom_command(CLI::App& program) {
  const auto options = std::make_shared<GrowOptions>();
  CLI::App* app = program.add_subcommand(kGroom.name, kGroom.what);
  app->add_option("STYLE", options->style, "long-smooth, short-curly, wavy or ponytail")->required();
  app->add_option("--out", options->out, "The file to write: .hair or .ply")->required();
  app->add_option("--head", options->head, "What it grows on: bust (default) or ellipsoid")
      ->check(CLI::IsMember({"bust", "ellipsoid"}));
  app->add_option("--strands", options->strands, "How many (default: 10000)")
      ->check(CLI::Range(1, 1'000'000));
  app->add_option("--points", options->points, "So many points for each strand (default: the style's)")
      ->check(CLI::Range(2, 1'000'000));
  app->add_option("--seed", options->seed, "Another seed gives other strands of the same style (default: 1)")
      ->check(CLI::Range(std::int64_t{0}, kMostSeed));
  return {app, [options](const Course&) { return write_grown_groom(*options); }};
}

}  // namespace hair
