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

constexpr int kStrands = 1'000, kQuickStrands = 80;
constexpr int kMostStrands = 200'000;
constexpr int kGuides[] = {50, 100, 300, 1'000, 3'000, 10'000};

struct HeadOptions : ShellOptions {
  std::vector<std::string> hairs;  // none: all
  int strands = 0;                 // 0: as many as usual
  bool no_pictures = false;
};

// The page, the table, and the pictures of all hairs.
std::vector<std::string> head_files() {
  std::vector<std::string> files = {"index.html", "head.csv"};
  for (const HeadHair& hair : head_hairs())
    for (const char* what : {"few", "many", "every"}) files.push_back(hair.id + "-" + what + ".png");
  return files;
}

int run(const HeadOptions& options, const Course& course) {
  if (!course.has("H10"))
    throw BadInput("study head: makes strands of guides with H10, which this course leaves out");
  std::vector<std::string> ids;
  for (const HeadHair& hair : chosen(head_hairs(), options.hairs, "--hair")) ids.push_back(hair.id);
  StudyShell shell(options, "hairlab study head", "head.json", head_files(), WhenInterrupted::loses);
  const auto bust = std::make_shared<Bust>();
  HeadStudy study{{}, {}, options.no_pictures ? "--no-pictures" : ""};
  std::unique_ptr<HeadPictures> pictures;
  try {
    if (!options.no_pictures) pictures = std::make_unique<HeadPictures>(*bust);
  } catch (const NoOpenGl& none) {
    study.no_pictures = none.what();
  }

  for (const HeadHair& hair : head_hairs()) {
    if (std::ranges::find(ids, hair.id) == ids.end()) continue;
    shell.say(hair.title + " grows");
    const GrownHead head = grow_head(*bust, hair,
                                     options.strands > 0 ? options.strands
                                     : options.quick     ? kQuickStrands
                                                         : kStrands);
    const int strands = static_cast<int>(head.strands.size());
    HeadStudySettings settings{true, {}};
    std::copy_if(std::begin(kGuides), std::end(kGuides), std::back_inserter(settings.guides),
                 [&](int guides) { return guides < strands; });
    if (pictures) pictures->begin();
    const SeeHead see = [&, drawn = pictured_guides(settings.guides)](int guides,
                                                                      std::span<const double> points) {
      const char* const name = guides == strands      ? "every"
                               : guides == drawn.few  ? "few"
                               : guides == drawn.many ? "many"
                                                      : nullptr;
      if (!name) return;
      const std::string file = hair.id + "-" + name + ".png";
      write_whole(shell.folder(), file, encode_png(pictures->draw(points, hair.points)));
      study.pictures.push_back({hair.id, file, guides});
    };
    for (const bool collides : {true, false}) {
      settings.collides = collides;
      auto one = study_head(bust, head, settings, shell.interrupted(), shell.teller(),
                            collides && pictures ? see : nullptr);
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
  app->add_option("--exercise-strands", options->strands, "Of hair that the exercises move (default: 1,000)")
      ->check(CLI::Range(1, kMostStrands));
  app->add_flag("--no-pictures", options->no_pictures, "None: without OpenGL");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
