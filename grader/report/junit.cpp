// STAFF ONLY. Writes results as JUnit's XML.
#include <map>

#include "grader/report/points_files.h"
#include "hair/io/plot/readable.h"

namespace grader::inline report {
namespace {

using hair::escaped;

// Counts test cases by element; "" are those that passed.
using Counts = std::map<std::string, std::size_t>;

// Names the element of a test case; "" if it passed.
std::string element_of(Status status) {
  switch (status) {
    case Status::passed:
    case Status::given:
      return "";
    case Status::missing:
    case Status::not_implemented:
    case Status::excused:
    case Status::not_given:
      return "skipped";
    case Status::partly:
    case Status::wrong:
    case Status::does_not_compile:
      return "failure";
    default:
      return "error";
  }
}

std::string test_case(Counts& counts, const std::string& suite, const std::string& name, Status status,
                      const std::string& message) {
  const std::string element = element_of(status);
  ++counts[element];
  const std::string head =
      "    <testcase classname=\"" + escaped(suite) + "\" name=\"" + escaped(name) + "\"";
  if (element.empty()) return head + "/>\n";
  const std::string type = element == "skipped" ? "" : "\" type=\"" + to_string(status);
  return head + ">\n      <" + element + " message=\"" +
         escaped(message.empty() ? to_string(status) : message) + type + "\"/>\n    </testcase>\n";
}

std::string suite_of(const SubmissionResult& result) {
  Counts counts;
  std::string cases;
  for (const ExerciseResult& exercise : result.exercises) {
    if (exercise.cases.empty()) {
      cases += test_case(counts, result.name, exercise.id + " " + exercise.title, exercise.status,
                         exercise.feedback);
    }
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      const CaseResult& one = exercise.cases[i];
      cases += test_case(counts, result.name, exercise.id + "." + std::to_string(i + 1) + " " + one.name,
                         one.status, one.feedback);
    }
  }
  std::size_t tests = 0;
  for (const auto& [element, count] : counts) tests += count;
  return "  <testsuite name=\"" + escaped(result.name) + "\" tests=\"" + std::to_string(tests) +
         "\" failures=\"" + std::to_string(counts["failure"]) + "\" errors=\"" +
         std::to_string(counts["error"]) + "\" skipped=\"" + std::to_string(counts["skipped"]) + "\">\n" +
         cases + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::vector<SubmissionResult>& results) {
  std::string suites;
  for (const SubmissionResult& result : results) suites += suite_of(result);
  const std::string said = said_of(least_isolation(results));
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + std::string("hairgrade") +
         (said.empty() ? "" : " (" + said + ")") +
         (all_with_images(results) ? "" : " (graded without pictures)") + "\">\n" + suites +
         "</testsuites>\n";
}

}  // namespace grader::report
