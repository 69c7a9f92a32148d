// STAFF ONLY. `hairgrade compare`: compares two pictures, or two folders of frames, and writes their page. It
// draws nothing, runs no student code and needs no secret.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <set>

#include "grader/class_folder/progress.h"
#include "grader/compare/compare.h"
#include "grader/compare/montage.h"
#include "grader/course/input.h"
#include "grader/report/pages/pages.h"
#include "grader/tool/commands/command.h"
#include "hair/io/image/read_png.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;
using hair::Image;

constexpr std::size_t kMostShown = 12;    // bounds the pairs whose pictures are in the page
constexpr int kHeatWidth = 480;           // is the width of their heat maps in the page, px
constexpr int kMostPixels = 4096 * 4096;  // FLIP needs some 70 bytes for each

struct CompareSettings {
  std::filesystem::path reference, test;
  std::optional<std::filesystem::path> out;  // is a folder for NAME-heat.png, NAME-side.png, index.html
  bool json = false;                         // instead of the table
};

// Collects files in a folder beside `out`; they move to `out` once all of them are complete.
class Staging {
 public:
  explicit Staging(const fs::path& out) : out_(out), made_out_(!fs::exists(out)) {
    std::error_code error;
    fs::create_directories(out_, error);
    folder_ = out_ / (".compare." + std::to_string(getpid()) + ".part");
    if (!error) fs::create_directory(folder_, error);
    if (error)
      throw BadInput(printable(out.string(), 4096) + ": can't be written (" + error.message() +
                     "); give a folder that can be written, with room in it");
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    if (made_out_) fs::remove(out_, ignored);  // if it is empty
  }

  void write(const std::string& name, std::string_view bytes) {
    write_file(folder_ / name, bytes);
    names_.insert(name);
  }
  void finish() {
    for (const std::string& name : names_) {
      std::error_code error;
      fs::rename(folder_ / name, out_ / name, error);
      if (error)
        throw BadInput(printable((out_ / name).string(), 4096) + ": can't be written (" + error.message() +
                       "); remove what is in its place");
    }
  }

 private:
  fs::path out_, folder_;
  bool made_out_;
  std::set<std::string> names_;
};

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

// Reads both pictures of a pair that can be compared.
std::pair<Image, Image> read_pair(const PicturePair& pair) {
  std::pair<Image, Image> both{hair::read_png(pair.reference), hair::read_png(pair.test)};
  const auto& [reference, test] = both;
  const auto shown = [](const fs::path& path) { return printable(path.string(), 4096); };
  if (reference.width != test.width || reference.height != test.height)
    throw BadInput(shown(pair.reference) + " is " + size_of(reference) + " pixels and " + shown(pair.test) +
                   " " + size_of(test) + "; pictures that are compared have one size");
  if (reference.width > kMostPixels / reference.height)
    throw BadInput(shown(pair.reference) + " is " + size_of(reference) +
                   " pixels; pictures that are compared have at most 4096 x 4096");
  // Black is black, opaque or not; over white the two differ.
  if (reference == test) both = {hair::read_png(pair.reference, 255), hair::read_png(pair.test, 255)};
  return both;
}

void check_out(const CompareSettings& settings) {
  std::error_code error;
  for (const fs::path& folder : {settings.reference, settings.test})
    if (fs::equivalent(folder, *settings.out, error))
      throw BadInput("--out " + printable(settings.out->string(), 4096) +
                     ": is what is compared; give another folder");
}

// Returns the exit code: 0, or 130 after an interruption. In two folders, unreadable pictures, pictures of
// different sizes and a picture that one folder lacks are named, ranked worst, and give 3. Throws BadInput
// before writing to `out`: as find_pairs does, for two pictures that can't be compared, and for a folder that
// can't be written.
int compare(const CompareSettings& settings) {
  const std::atomic<bool>& interrupted = note_interruptions();
  PicturePairs found = find_pairs(settings.reference, settings.test);
  if (settings.out) check_out(settings);
  std::optional<Staging> staging;
  if (settings.out) staging.emplace(*settings.out);

  Comparison comparison{settings.reference.string(),
                        settings.test.string(),
                        {},
                        std::move(found.only_in_reference),
                        std::move(found.only_in_test)};
  const bool folders = fs::is_directory(settings.reference);
  std::vector<ShownPair> worst;
  {
    Progress progress(found.pairs.size());
    for (const PicturePair& pair : found.pairs) {
      if (interrupted) return kInterrupted;
      std::pair<Image, Image> both;
      try {
        both = read_pair(pair);
      } catch (const BadInput& error) {
        if (!folders) throw;
        comparison.pairs.push_back({.name = pair.name, .distance = {}, .obstacle = error.what()});
        progress.step(printable(pair.name));
        continue;
      }
      const auto& [reference, test] = both;
      const ErrorMap map = flip(reference, test);
      const ComparedPair compared{pair.name, reference.width, reference.height,
                                  compare_pictures(reference, test, map)};
      comparison.pairs.push_back(compared);
      if (staging) {
        const Image heat = heat_map(map);
        staging->write(side_file(pair.name), hair::encode_png(side_by_side({reference, test, heat})));
        if (!compared.distance.identical) {
          staging->write(heat_file(pair.name), hair::encode_png(heat));
          worst.push_back({compared, hair::encode_png(reference), hair::encode_png(test),
                           hair::encode_png(shrunk(heat, kHeatWidth))});
          std::sort(worst.begin(), worst.end(),
                    [](const ShownPair& a, const ShownPair& b) { return is_worse(a.pair, b.pair); });
          if (worst.size() > kMostShown) worst.pop_back();
        }
      }
      progress.step(printable(pair.name));
    }
  }
  std::sort(comparison.pairs.begin(), comparison.pairs.end(), is_worse);
  if (staging) {
    staging->write("index.html", comparison_page(comparison, worst));
    staging->finish();
  }
  std::cout << (settings.json ? comparison_json(comparison) : comparison_table(comparison));
  if (settings.out && !settings.json)
    std::cout << fs::absolute(*settings.out / "index.html").lexically_normal().string() << "\n";
  return is_complete(comparison) ? 0 : 3;
}

}  // namespace

Command add_compare(CLI::App& hairgrade) {
  const auto settings = std::make_shared<CompareSettings>();
  CLI::App* command =
      hairgrade.add_subcommand("compare", "Compare two pictures, or two folders of frames, worst first");
  command->add_option("A", settings->reference, "A PNG picture, or a folder of them")->required();
  command->add_option("B", settings->test, "What is compared with it: a picture, or a folder")->required();
  command->add_option("--out", settings->out,
                      "A folder for heat maps, pictures side by side and a page of the worst");
  command->add_flag("--json", settings->json, "Print JSON in place of a table");
  return {command, [settings] {
            const int code = compare(*settings);
            if (code == kInterrupted) std::cerr << "hairgrade: interrupted; nothing was written\n";
            return code;
          }};
}

}  // namespace grader::tool
