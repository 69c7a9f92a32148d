// STAFF ONLY.
#include "grader/report/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "grader/course/input.h"
#include "grader/report/gradebook.h"
#include "grader/report/pages.h"
#include "grader/report/picture_files.h"
#include "grader/report/results_json.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// A name becomes a part of paths: it must not lead elsewhere.
bool can_name_a_folder(const std::string& name) {
  return !name.empty() && name.front() != '.' && name != "staff" &&
         name.find_first_of(std::string("/\\\0", 3)) == name.npos;
}

void check_name(const std::string& name) {
  if (!can_name_a_folder(name)) {
    throw std::invalid_argument("\"" + printable(name) + "\" can't name a submission's folder");
  }
}

fs::path record_of(const fs::path& dir, const std::string& name) {
  return dir / "staff" / (name + ".json");
}

// The record names the pictures' files.
PictureText pictures_in(const fs::path& dir) {
  return {picture_name,
          [folder = pictures_folder(dir)](const std::string& name) { return read_picture(folder, name); }};
}

// The record comes last and goes first: where it is, all other files belong to it. So a grader that is killed
// leaves either a whole result or none.
void remove_record(const fs::path& dir, const std::string& name) {
  std::error_code not_there;
  fs::remove(record_of(dir, name), not_there);
}

}  // namespace

void write_submission_reports(const fs::path& dir, const SubmissionResult& result) {
  check_name(result.name);
  remove_record(dir, result.name);
  fs::create_directories(dir / "staff");
  fs::permissions(dir / "staff", fs::perms::owner_all);  // hidden inputs and expected values
  write_file(dir / result.name / "results.json", student_json(result));
  write_file(dir / result.name / "report.html", student_page(result));
  write_pictures(pictures_folder(dir), result);
  write_file(dir / "staff" / (result.name + ".html"), staff_page(result));
  write_file(record_of(dir, result.name), json_text(result, 1, pictures_in(dir)));
}

void write_study(const fs::path& dir, const SubmissionResult& result, const SubmissionStudy& study,
                 const SubmissionStudy& beside_itself) {
  check_name(result.name);
  remove_record(dir, result.name);
  write_file(dir / result.name / "study.json", json_text(study, 1));
  write_file(dir / result.name / "study.html", study_page(result, study, beside_itself));
}

void remove_study(const fs::path& dir, const SubmissionResult& result) {
  check_name(result.name);
  remove_record(dir, result.name);
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
  const std::string text = whole ? hair::bytes_of(record_of(dir, name)) : "";
  if (text.empty()) return {};
  try {
    SubmissionResult result = from_json_text<SubmissionResult>(text, name, pictures_in(dir));
    if (result.name == name) return result;
  } catch (const BadInput&) {  // damaged, or one of its pictures
  }
  return {};
}

std::string read_origin(const fs::path& dir, const std::string& name) {
  check_name(name);
  const auto record = nlohmann::json::parse(hair::bytes_of(record_of(dir, name)), nullptr, false);
  const auto found = record.find("origin");
  return found != record.end() && found->is_string() ? found->get<std::string>() : "";
}

std::vector<std::string> submissions_in(const fs::path& dir) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(dir, none))
    if (const std::string name = entry.path().filename().string();
        can_name_a_folder(name) && fs::exists(entry.path() / "results.json", none))
      names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace grader
