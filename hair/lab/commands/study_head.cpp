#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/image/png.h"
#include "hair/io/machine.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/head/head_page.h"
#include "hair/lab/head/head_pictures.h"
#include "hair/lab/head/head_record.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_file.h"
#include "hair/lab/run/output_folder.h"

namespace hair {

namespace {

using namespace head_study;

// Of strands that the engine moves, and of those that the exercises move.
constexpr int kFast = 20'000, kGiven = 1'000, kQuickFast = 2'000, kQuickGiven = 80;
constexpr int kMostStrands = 200'000;
constexpr int kGuides[] = {50, 100, 300, 1'000, 3'000, 10'000};

struct HeadOptions {
  std::filesystem::path out;
  std::vector<std::string> hairs;      // none: all
  int strands = 0, given_strands = 0;  // 0: as many as usual
  int threads = 1;
  bool quick = false, no_pictures = false;
};

std::vector<const HeadHair*> chosen(const HeadOptions& options) {
  std::vector<const HeadHair*> all;
  std::string known;
  for (const HeadHair& one : head_hairs()) {
    known += (known.empty() ? "" : ", ") + one.id;
    if (options.hairs.empty() ||
        std::find(options.hairs.begin(), options.hairs.end(), one.id) != options.hairs.end())
      all.push_back(&one);
  }
  for (const std::string& id : options.hairs)
    if (std::none_of(head_hairs().begin(), head_hairs().end(), [&](const auto& one) { return one.id == id; }))
      throw BadInput("--hair: there is no \"" + printable(id) + "\"; there are " + known);
  return all;
}

int strands_of(const HeadOptions& options, const HeadHair& hair) {
  if (has_fast_head() && !hair.curved)
    return options.strands > 0 ? options.strands : options.quick ? kQuickFast : kFast;
  return options.given_strands > 0 ? options.given_strands : options.quick ? kQuickGiven : kGiven;
}

const OutputKind& head_output() {
  static const OutputKind kind = {
      "hairlab study head",
      "head.json",
      kHeadRecordBegin,
      {"index.html", "head.csv", "straight-few.png", "straight-many.png", "straight-every.png",
       "combed-few.png", "combed-many.png", "combed-every.png", "wavy-few.png", "wavy-many.png",
       "wavy-every.png", "curly-few.png", "curly-many.png", "curly-every.png"}};
  return kind;
}

// Pictures of one hair, into the folder, as the study sees them.
class Pictured {
 public:
  Pictured(HeadPictures* draws, const HeadHair& hair, PicturedGuides guides, const OutputFolder& folder,
           std::vector<HeadPicture>& pictures)
      : draws_(draws), hair_(hair), guides_(guides), folder_(folder), pictures_(pictures) {
    if (draws_) draws_->begin();
  }

  SeeHead see(int strands) {
    if (!draws_) return nullptr;
    return [this, strands](int guides, std::span<const double> points) {
      const char* const name = guides == strands        ? "every"
                               : guides == guides_.few  ? "few"
                               : guides == guides_.many ? "many"
                                                        : nullptr;
      if (!name) return;
      const std::string file = hair_.id + "-" + name + ".png";
      write_whole(folder_, file, encode_png(draws_->draw(points, hair_.points)));
      pictures_.push_back({hair_.id, file, guides});
    };
  }

 private:
  HeadPictures* draws_;
  const HeadHair& hair_;
  PicturedGuides guides_;
  const OutputFolder& folder_;
  std::vector<HeadPicture>& pictures_;
};

int run(const HeadOptions& options, const Course& course) {
  if (!course.has("H10"))
    throw BadInput("study head: makes strands of guides with H10, which this course leaves out");
  const std::vector<const HeadHair*> hairs = chosen(options);
  const std::atomic<bool>& interrupted = catch_interruption("\nhairlab: stopping; once more ends at once\n");
  OutputFolder folder(options.out, head_output());
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto say = [&](const std::string& what) {
    if (terminal) std::cerr << "\r\x1b[K" << what << std::flush;
  };
  const auto bust = std::make_shared<Bust>();
  HeadStudy study{options.quick, options.threads, {}, {}, options.no_pictures ? "--no-pictures" : ""};
  std::unique_ptr<HeadPictures> pictures;
  try {
    if (!options.no_pictures) pictures = std::make_unique<HeadPictures>(*bust);
  } catch (const NoOpenGl& none) {
    study.no_pictures = none.what();
  }

  for (const HeadHair* hair : hairs) {
    say(hair->title + " grows");
    const GrownHead head = grow_head(*bust, *hair, strands_of(options, *hair));
    const int strands = static_cast<int>(head.strands.size());
    HeadStudySettings settings{true, options.threads, {}};
    std::copy_if(std::begin(kGuides), std::end(kGuides), std::back_inserter(settings.guides),
                 [&](int guides) { return guides < strands; });
    Pictured pictured(pictures.get(), *hair, pictured_guides(settings.guides), folder, study.pictures);
    for (const bool collides : {true, false}) {
      settings.collides = collides;
      auto one =
          study_head(bust, head, settings, interrupted, say, collides ? pictured.see(strands) : nullptr);
      if (!one) {
        say("");
        std::cerr << "hairlab: interrupted; nothing is written\n";
        return kInterrupted;
      }
      study.cases.push_back(std::move(*one));
    }
  }
  say("");
  const std::string machine = measured_on(this_machine(), options.threads);
  write_whole(folder, "head.json", head_json(study, machine));
  write_whole(folder, "head.csv", to_csv(table_of_runs(study)));
  write_whole(folder, "index.html", to_html(head_page(study, machine)));
  folder.keep();
  if (!study.no_pictures.empty() && !options.no_pictures)
    std::cerr << "hairlab: there are no pictures: " << study.no_pictures << "\n";
  std::cout << (folder.path() / "index.html").string() << "\n";
  return 0;
}

}  // namespace

Command add_study_head_command(CLI::App& study) {
  const auto options = std::make_shared<HeadOptions>();
  CLI::App* app = study.add_subcommand(
      "head", "Every strand of a head, or some with the others made by synthesis: error against run time");
  app->add_option("--out", options->out, "The folder for page, pictures, JSON and CSV")->required();
  app->add_option("--hair", options->hairs, "Which: straight, combed, wavy, curly (default: all)");
  if (has_fast_head())
    app->add_option("--strands", options->strands, "Of hair that the engine moves (default: 20,000)")
        ->check(CLI::Range(1, kMostStrands));
  app->add_option("--exercise-strands", options->given_strands,
                  "Of hair that the exercises move (default: 1,000)")
      ->check(CLI::Range(1, kMostStrands));
  app->add_option("--threads", options->threads,
                  "How many move hair (default: 1); exercises must not use globals then")
      ->check(CLI::Range(1, 64));
  app->add_flag("--quick", options->quick, "Fewer strands");
  app->add_flag("--no-pictures", options->no_pictures, "None: without OpenGL");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
