// STAFF ONLY. `hairgrade site`: writes pages for people who build nothing: a start page, views of scenes, and
// a class as its students may see it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "grader/compare/compare.h"
#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/package/handout.h"
#include "grader/report/facts/alike.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/student_view.h"
#include "grader/report/pages/pages.h"
#include "grader/report/pages/pictures.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"
#include "hair/view/view_page.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct SiteOptions {
  fs::path grades, bugs, out;
  std::vector<fs::path> motions;
};

constexpr std::size_t kBugs = 5, kMostLost = 3;  // categories
constexpr std::size_t kMostBytes = 6'000'000;

// Shows a bug a picture: runs that are far from the reference's, each of another exercise, farthest first.
Html bugs(const std::vector<SubmissionResult>& results) {
  struct Far {
    double flip;
    const ExerciseResult* exercise;
  };
  std::map<std::string, Far> by_exercise;
  for (const SubmissionResult& result : results)
    for (const ExerciseResult& exercise : result.exercises) {
      if (const std::size_t lost = lost_categories(exercise).size(); lost == 0 || lost > kMostLost) continue;
      for (const PictureResult& picture : exercise.pictures)
        if (Far& far = by_exercise[exercise.id]; picture.flip > far.flip) far = {picture.flip, &exercise};
    }
  std::vector<Far> all;
  for (const auto& [id, far] : by_exercise)
    if (far.flip > kFlip) all.push_back(far);
  std::ranges::sort(all, std::greater(), &Far::flip);
  if (all.size() > kBugs) all.resize(kBugs);
  Html shown;
  for (const Far& far : all) {
    std::vector<std::string> lost;
    for (const LostCategory& one : lost_categories(*far.exercise)) lost.push_back(one.one->name);
    const std::string what = far.exercise->id + " " + far.exercise->title + ", lost in " + in_a_row(lost);
    shown += moments(*far.exercise, what, RunEnding::whole, "Theirs", {.is_for_student = true});
  }
  return shown;
}

// Reads all results of a record as their students may see them.
std::vector<SubmissionResult> results_in(const fs::path& grades) {
  const std::unique_ptr<Record> record = open_record(grades, "");
  std::vector<SubmissionResult> results;
  for (const std::string& name : record->names())
    if (const std::optional<Recorded> one = record->find_decided(name))
      results.push_back(for_student(one->result));
  return results;
}

std::string start_page(const std::vector<SubmissionResult>& results, const std::vector<fs::path>& motions,
                       const Html& shown) {
  Html body = html(
      "<header>\n<h1>Hair: a course assignment, and the machine that grades it</h1>\n<p>Students write the "
      "parts of a hair simulation, from conjugate gradients up to whole strands. Each submission is built in "
      "a sandbox and compared with a reference solution.</p>\n</header>\n<main>\n<section>\n<h2>Hair that "
      "moves</h2>\n<p>Turn it with the mouse.</p>\n<ul>\n");
  for (const fs::path& motion : motions)
    body += html("<li><a href=\"{}.html\">{}</a></li>\n", {motion.stem().string(), motion.stem().string()});
  body += html(
      "</ul>\n</section>\n<section>\n<h2>A class</h2>\n<p><a href=\"class/index.html\">Grades of a class of "
      "{} samples</a>. Each row leads to the report that its student gets.</p>\n",
      {results.size()});
  for (const SubmissionResult& result : results)
    if (result.studied)
      body += html("<p><a href=\"class/{}/study.html\">Error against run time</a> of {}.</p>\n",
                   {result.name, result.name});
  if (!shown.text.empty()) body += html("<h2>A bug a picture</h2>\n{}", {shown});
  return html_page("Hair", body += html("</section>\n</main>\n"), {{hair::viewer_script()}});
}

int site(const SiteOptions& options) {
  if (fs::exists(options.out) && !fs::is_empty(options.out))
    throw BadInput(printable(options.out.string(), 4096) + ": is not empty; name a new folder with --out");
  const std::unique_ptr<Record> record = open_record(options.grades, "");
  Files pages;
  std::vector<SubmissionResult> results;
  for (const std::string& name : record->names()) {
    const std::optional<Recorded> one = record->find_decided(name);
    if (!one) continue;
    results.push_back(for_student(one->result));
    pages["class/" + name + "/report.html"] = student_page(one->result);
    if (!one->study) continue;
    pages["class/" + name + "/study.html"] = study_page(results.back(), *one->study);
    pages["class/" + name + "/study.json"] = json_text(*one->study, 1);
  }
  pages["class/index.html"] = class_page(results, {.is_public = true});
  for (const fs::path& motion : options.motions) {
    const std::string scene = motion.stem().string();
    pages[scene + ".html"] = hair::view_page({{scene, hair::bytes_of(motion)}});
  }
  pages["index.html"] =
      start_page(results, options.motions, options.bugs.empty() ? Html() : bugs(results_in(options.bugs)));
  check_pages(pages, {HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR}, read_course(HAIR_EXERCISES_JSON, {}));
  std::size_t bytes = 0;
  for (const auto& [path, text] : pages) bytes += text.size();
  if (bytes > kMostBytes)
    throw BadInput("the pages have " + std::to_string(bytes / 1'000'000) + " MB of at most " +
                   std::to_string(kMostBytes / 1'000'000) + "; name fewer motions, or a smaller class");
  for (const auto& [path, text] : pages) {
    fs::create_directories((options.out / path).parent_path());
    write_file(options.out / path, text);
  }
  std::cout << (options.out / "index.html").string() << ": " << pages.size() << " pages, "
            << bytes / 1'000'000 << " MB\n";
  return 0;
}

}  // namespace

Command add_site(CLI::App& hairgrade) {
  const auto options = std::make_shared<SiteOptions>();
  CLI::App* command = hairgrade.add_subcommand(
      "site", "Write pages for everybody: a start page, views, and a class as its students see it");
  command->add_option("GRADES", options->grades, "A folder of grades")->required();
  command->add_option("--bugs", options->bugs,
                      "A folder of grades: five of its runs that are far off become pictures");
  command->add_option("--motion", options->motions, "motion.json of a run, to be looked at")
      ->check(CLI::ExistingFile);
  command->add_option("--out", options->out, "A new folder")->required();
  return {command, [options] { return site(*options); }};
}

}  // namespace grader::tool
