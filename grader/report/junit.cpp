// STAFF ONLY. Writes results as JUnit's XML.
#include "grader/report/points_files.h"
#include "hair/io/plot/readable.h"

namespace grader::inline report {
namespace {

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
};

// Line breaks and tabs would become spaces in an attribute.
std::string attribute(const std::string& bytes) {
  std::string text;
  for (const char c : hair::escaped(bytes)) {
    if (c == '\n')
      text += "&#10;";
    else if (c == '\t')
      text += "&#9;";
    else
      text += c;
  }
  return text;
}

std::string test_case(Counts& counts, const std::string& suite, const std::string& name, Status status,
                      const std::string& message) {
  ++counts.tests;
  const std::string head =
      "    <testcase classname=\"" + attribute(suite) + "\" name=\"" + attribute(name) + "\"";
  std::string element;
  switch (status) {
    case Status::passed:
    case Status::given:
      return head + "/>\n";
    case Status::missing:
    case Status::not_implemented:
    case Status::not_given:
      element = "skipped";
      ++counts.skipped;
      break;
    case Status::partly:
    case Status::wrong:
    case Status::does_not_compile:
      element = "failure";
      ++counts.failures;
      break;
    case Status::crashed:
    case Status::timed_out:
    case Status::out_of_memory:
    case Status::broke_rules:
    case Status::not_taken:
    case Status::unreadable:
      element = "error";
      ++counts.errors;
      break;
  }
  const std::string type = element == "skipped" ? "" : "\" type=\"" + to_string(status);
  return head + ">\n      <" + element + " message=\"" +
         attribute(message.empty() ? to_string(status) : message) + type + "\"/>\n    </testcase>\n";
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
  return "  <testsuite name=\"" + attribute(result.name) + "\" tests=\"" + std::to_string(counts.tests) +
         "\" failures=\"" + std::to_string(counts.failures) + "\" errors=\"" + std::to_string(counts.errors) +
         "\" skipped=\"" + std::to_string(counts.skipped) + "\">\n" + cases + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::vector<SubmissionResult>& results) {
  std::string suites;
  bool images = true;
  for (const SubmissionResult& result : results) {
    suites += suite_of(result);
    images = images && result.images;
  }
  const std::string said = said_of(least_isolation(results));
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + std::string("hairgrade") +
         (said.empty() ? "" : " (" + said + ")") + (images ? "" : " (graded without pictures)") + "\">\n" +
         suites + "</testsuites>\n";
}

}  // namespace grader::report
