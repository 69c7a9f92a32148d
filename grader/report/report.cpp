// STAFF ONLY. Writes the files of students and of the class.
#include "grader/report/report.h"

#include <stdexcept>

#include "grader/course/input.h"
#include "grader/report/facts/picture_files.h"
#include "grader/report/pages/pages.h"
#include "grader/report/points_files.h"
#include "grader/report/results_json.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/read_file.h"

namespace grader::inline report {
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

// A file with the right content keeps its time.
void put_file(const fs::path& file, const std::string& text) {
  if (hair::bytes_of(file) != text) write_file(file, text);
}

std::string json_with_person(const SubmissionResult& result, const NamesForPeople& people) {
  SubmissionResult without_motions = result;  // those are in pages
  for (ExerciseResult& one : without_motions.exercises) one.motions = {};
  OrderedJson json = to_json_value(without_motions, {picture_name, {}});
  if (people.contains(result.name)) json["person"] = hair::valid_utf8(people.at(result.name));
  return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace

void write_submission_reports(const fs::path& dir, const SubmissionResult& result,
                              const NamesForPeople& people) {
  check_name(result.name);
  fs::create_directories(dir / "staff");
  fs::permissions(dir / "staff", fs::perms::owner_all);  // it has hidden inputs and expected values
  put_file(dir / result.name / "results.json", student_json(result));
  put_file(dir / result.name / "report.html", student_page(result, people));
  write_pictures(pictures_folder(dir), result);
  const fs::path runs = dir / "staff" / "runs" / result.name;
  fs::remove_all(runs);
  for (const ExerciseResult& one : result.exercises)
    if (!one.motions.student.empty()) put_file(runs / (one.id + ".html"), run_page(result, one, people));
  put_file(dir / "staff" / (result.name + ".html"), staff_page(result, people));
  put_file(dir / "staff" / (result.name + ".json"), json_with_person(result, people));
}

void write_study(const fs::path& dir, const SubmissionResult& result, const SubmissionStudy& study,
                 const NamesForPeople& people) {
  check_name(result.name);
  put_file(dir / result.name / "study.json", json_text(study, 1));
  put_file(dir / result.name / "study.html", study_page(result, study, people));
}

void remove_study(const fs::path& dir, const SubmissionResult& result) {
  check_name(result.name);
  std::error_code not_there;
  for (const char* file : {"study.html", "study.json"}) fs::remove(dir / result.name / file, not_there);
}

void write_class_reports(const fs::path& dir, const std::vector<SubmissionResult>& results,
                         const ClassFacts& facts, const NamesForPeople& people) {
  put_file(dir / "grades.csv", grades_csv(results, facts.people));
  fs::remove(dir / "junit.xml");  // that of an earlier run, which would be out of date
  put_file(dir / "index.html", class_page(results, facts, people));
}

void write_course_reports(const fs::path& dir, const CourseTable& course, const std::vector<ClassLine>& lines,
                          const NamesForPeople& people) {
  put_file(dir / "grades.csv", course_csv(course, lines));
  put_file(dir / "index.html", course_page(course, lines, people));
}

void remove_reports(const fs::path& dir, const std::string& name) {
  check_name(name);
  fs::remove_all(dir / name);
  fs::remove_all(dir / "staff" / "runs" / name);
  for (const char* ending : {".html", ".json"}) fs::remove(dir / "staff" / (name + ending));
}

}  // namespace grader::report
