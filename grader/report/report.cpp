// STAFF ONLY.
#include "grader/report/report.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "grader/course/input.h"
#include "grader/report/gradebook.h"
#include "grader/report/pages.h"
#include "grader/report/picture_files.h"
#include "grader/report/results_json.h"
#include "grader/report/study_json.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// A name becomes a part of paths: it must not lead elsewhere.
void check_name(const std::string& name) {
  if (name.empty() || name.front() == '.' || name == "staff" ||
      name.find_first_of(std::string("/\\\0", 3)) != name.npos) {
    throw std::invalid_argument("\"" + printable(name) + "\" can't name a submission's folder");
  }
}

}  // namespace

void write_submission_reports(const fs::path& dir, const SubmissionResult& result) {
  check_name(result.name);
  const fs::path record = dir / "staff" / (result.name + ".json");
  // The record comes last and goes first: where it is, all the others belong to it.
  std::error_code not_there;
  fs::remove(record, not_there);
  write_file(dir / result.name / "results.json", student_json(result));
  write_file(dir / result.name / "report.html", student_page(result));
  write_pictures(pictures_folder(dir), result);
  write_file(dir / "staff" / (result.name + ".html"), staff_page(result));
  fs::permissions(dir / "staff", fs::perms::owner_all);  // hidden inputs and expected values
  write_file(record, staff_json(result));
}

void write_study(const fs::path& dir, const SubmissionResult& result, const SubmissionStudy& study,
                 const SubmissionStudy& beside_itself) {
  check_name(result.name);
  write_file(dir / result.name / "study.json", study_json(study));
  write_file(dir / result.name / "study.html", study_page(result, study, beside_itself));
}

void remove_study(const fs::path& dir, const SubmissionResult& result) {
  check_name(result.name);
  std::error_code not_there;
  for (const char* file : {"study.html", "study.json"}) fs::remove(dir / result.name / file, not_there);
}

void write_class_reports(const fs::path& dir, const std::vector<SubmissionResult>& results) {
  write_file(dir / "grades.csv", grades_csv(results));
  write_file(dir / "junit.xml", junit_xml(results));
  write_file(dir / "index.html", class_page(results));
}

std::optional<SubmissionResult> read_results(const fs::path& dir, const std::string& name) {
  check_name(name);
  std::error_code error;
  const bool whole = fs::exists(dir / name / "results.json", error) &&
                     fs::exists(dir / name / "report.html", error) &&
                     fs::exists(dir / "staff" / (name + ".html"), error);
  std::ifstream in(dir / "staff" / (name + ".json"), std::ios::binary);
  if (!whole || !in) return {};
  std::ostringstream text;
  text << in.rdbuf();
  std::optional<SubmissionResult> result =
      result_from_staff_json(std::move(text).str(), pictures_folder(dir));
  if (result && result->name != name) return {};
  return result;
}

}  // namespace grader
