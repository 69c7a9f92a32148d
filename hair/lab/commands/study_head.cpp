#include <iostream>
#include <iterator>
#include <memory>

#include "hair/io/image/png.h"
#include "hair/lab/commands/study_shell.h"
#include "hair/lab/head/head_pictures.h"
#include "hair/lab/head/head_record.h"

namespace hair {

namespace {

using namespace head_study;

// Numbers of strands for the engine, and for the exercises.
constexpr int kFast = 20'000, kGiven = 1'000, kQuickFast = 2'000, kQuickGiven = 80;
constexpr int kMostStrands = 200'000;
constexpr int kGuides[] = {50, 100, 300, 1'000, 3'000, 10'000};

struct HeadOptions : ShellOptions {
  std::vector<std::string> hairs;      // none: all
  int strands = 0, given_strands = 0;  // 0: as many as usual
  bool no_pictures = false;
};

int strands_of(const HeadOptions& options, const HeadHair& hair) {
  if (has_fast_head() && !hair.curved)
    return options.strands > 0 ? options.strands : options.quick ? kQuickFast : kFast;
  return options.given_strands > 0 ? options.given_strands : options.quick ? kQuickGiven : kGiven;
}

// The page, the table, and the pictures of all hairs.
std::vector<std::string> head_files() {
  std::vector<std::string> files = {"index.html", "head.csv"};
  for (const HeadHair& hair : head_hairs())
    for (const char* what : {"few", "many", "every"}) files.push_back(hair.id + "-" + what + ".png");
  return files;
}

// Writes pictures of one hair into the folder, as the study calls it.
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
  std::vector<std::string> ids;
  for (const HeadHair& hair : chosen(head_hairs(), options.hairs, "--hair")) ids.push_back(hair.id);
  StudyShell shell(options, "hairlab study head", "head.json", head_files(), WhenInterrupted::loses);
  const auto bust = std::make_shared<Bust>();
  HeadStudy study{options.threads, {}, {}, options.no_pictures ? "--no-pictures" : ""};
  std::unique_ptr<HeadPictures> pictures;
  try {
    if (!options.no_pictures) pictures = std::make_unique<HeadPictures>(*bust);
  } catch (const NoOpenGl& none) {
    study.no_pictures = none.what();
  }

  for (const HeadHair& hair : head_hairs()) {
    if (std::find(ids.begin(), ids.end(), hair.id) == ids.end()) continue;
    shell.say(hair.title + " grows");
    const GrownHead head = grow_head(*bust, hair, strands_of(options, hair));
    const int strands = static_cast<int>(head.strands.size());
    HeadStudySettings settings{true, options.threads, {}};
    std::copy_if(std::begin(kGuides), std::end(kGuides), std::back_inserter(settings.guides),
                 [&](int guides) { return guides < strands; });
    Pictured pictured(pictures.get(), hair, pictured_guides(settings.guides), shell.folder(), study.pictures);
    for (const bool collides : {true, false}) {
      settings.collides = collides;
      auto one = study_head(bust, head, settings, shell.interrupted(), shell.teller(),
                            collides ? pictured.see(strands) : nullptr);
      if (!one) return shell.end(false);
      study.cases.push_back(std::move(*one));
    }
  }
  shell.say("");
  shell.keep(head_json(study), head_page(study), {{"head.csv", head_rows(study)}});
  if (!study.no_pictures.empty() && !options.no_pictures)
    std::cerr << "hairlab: there are no pictures: " << study.no_pictures << "\n";
  return shell.end(true);
}

}  // namespace

Command add_study_head_command(CLI::App& study) {
  const auto options = std::make_shared<HeadOptions>();
  const OtherCommand command = {
      "head", "Every strand of a head, or some with the others made by synthesis: error against run time",
      kStudies};
  CLI::App* app = add_study(study, command, *options, "fewer strands");
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
  app->add_flag("--no-pictures", options->no_pictures, "None: without OpenGL");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
