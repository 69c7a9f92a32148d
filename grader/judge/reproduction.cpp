// STAFF ONLY. Asks a category's cases once more, and writes the one that fails.
#include "grader/judge/reproduction.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "grader/calls/in_words.h"
#include "grader/judge/calls_as_code.h"
#include "grader/judge/cases/suite_table.h"
#include "grader/result/suite_result.h"
#include "hair/io/files/read_file.h"

namespace grader::inline judge {
namespace {

Declared::Parameter parameter_of(std::string text) {
  const bool is_array = text.ends_with("[]");
  if (is_array) text.resize(text.size() - 2);
  const std::size_t name = text.find_last_of(" *&\n") + 1;
  return {text.substr(name), is_array || text.substr(0, name).find('*') != std::string::npos};
}

// Returns the functions in the exercise's order; `headers` is the folder that students have.
std::vector<Declared> declared(const Exercise& exercise, const std::filesystem::path& headers) {
  const std::string header = hair::bytes_of(headers / exercise.header);
  std::vector<Declared> all;
  for (const std::string& signature : exercise.functions) {
    Declared& one = all.emplace_back();
    one.name = signature.substr(0, signature.find('('));
    const std::string start = " " + hair::plain_name(signature) + "(";
    std::size_t at = header.find(start), begin = header.rfind('\n', at) + 1;
    for (; at != std::string::npos && header.compare(begin, 2, "//") == 0; begin = header.rfind('\n', at) + 1)
      at = header.find(start, at + 1);
    const std::size_t end = header.find(");", at);
    if (end == std::string::npos) throw NotWritable(exercise.header + " does not declare " + one.name);
    one.text = header.substr(begin, end + 1 - begin);
    std::string next;
    int depth = 0;
    for (const char c : header.substr(at + start.size(), end - at - start.size()) + ",") {
      depth += (c == '<') - (c == '>');
      if (c != ',' || depth > 0)
        next += c;
      else
        one.parameters.push_back(parameter_of(std::exchange(next, "")));
    }
  }
  return all;
}

constexpr std::size_t kMostText = std::size_t{12} << 20;

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Returns the place of the check's numbers among those that the calls returned; the last one counts.
std::ptrdiff_t place_in(const std::vector<double>& seen, const Eigen::VectorXd& actual) {
  const auto same = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  const auto found = std::find_end(seen.begin(), seen.end(), actual.begin(), actual.end(), same);
  return actual.size() == 0 || found == seen.end() ? -1 : found - seen.begin();
}

std::map<std::string, std::string> files_of(const CallsAsCode& code, const Course& course,
                                            const Exercise& exercise, const std::string& category,
                                            const CaseFailed& failure, const Compared& compared) {
  const std::string mark =
      "// STAFF ONLY. A case of grading that fails: " + exercise.id + ", " + category + ".\n";
  const auto list = [](const auto& numbers) { return joined(numbers, number_literal); };
  std::map<std::string, std::string> files;
  files["inputs.h"] = mark + "#pragma once\n\n#include \"" + exercise.header +
                      "\"\n#include \"replay.h\"\n\nnamespace {\n\nusing namespace replay;\n\n" +
                      code.inputs + "// These are the numbers of grading.\nconst Check kCheck{\n    " +
                      quoted(failure.feedback + "\n" + failure.detail) + ",\n    " + list(code.seen) +
                      ",\n    " + list(compared.actual) + ",\n    " + list(compared.expected) + ",\n    " +
                      std::to_string(place_in(code.seen, compared.actual)) + "};\n\n}  // namespace\n";
  files["main.cpp"] =
      mark +
      "// The student's code runs here as any program of yours: read it first.\n"
      "#include \"inputs.h\"\n\nextern \"C\" const char* __asan_default_options() {\n"
      "  return \"detect_leaks=0\";\n}\n\nint main() {\n  std::cout.precision(17);\n  Seen seen;\n" +
      code.statements + "\n  return seen.compare(kCheck);\n}\n";
  std::string includes;
  for (const std::string& id : exercise.prerequisites)
    includes += "#include \"" + course.find(id)->header + "\"\n";
  files["given.cpp"] = "// STAFF ONLY. Given functions: they return what they returned in grading.\n" +
                       includes + "#include \"replay.h\"\n\nusing namespace replay;\n" + code.given;
  files["answers.txt"] = code.answers;
  return files;
}

}  // namespace

std::map<std::string, std::string> reproduce(const SuiteJob& job, Student& student) {
  const auto refuse = [](const std::string& why) {
    return std::map<std::string, std::string>{{kNotReproduced, why}};
  };
  const Course course = read_course(job.exercises);
  const Exercise& exercise = *course.find(job.exercise);
  const std::vector<Category> all = categories(job.exercise);
  const auto category = std::ranges::find(all, job.reproduce, &Category::title);
  if (category == all.end()) return refuse("it has no cases with inputs of their own: it judges a whole run");
  Recording recording(Recording::Keeps::last_case);
  student.record(&recording);
  Trial trial(student, Random(job.seed, category->name));
  std::optional<CaseFailed> failure;
  try {
    category->run(trial);
  } catch (const CaseFailed& failed) {
    failure = failed;
  } catch (const MalformedMessage& error) {
    failure = {Status::broke_rules, "the code sent the grader a message that does not fit", error.what()};
  }
  if (!failure) return refuse("no case of it fails this time");
  constexpr const char* kTooLarge = "its first failing case has too many numbers to be written";
  if (recording.is_cut()) return refuse(kTooLarge);
  try {
    std::map<std::string, std::vector<Declared>> functions;
    functions[exercise.id] = declared(exercise, job.kit / "handout");
    for (const std::string& id : exercise.prerequisites)
      functions[id] = declared(*course.find(id), job.kit / "handout");
    const CallsAsCode code = as_code(recording.requests(), exercise.id, functions);
    std::map<std::string, std::string> files =
        files_of(code, course, exercise, category->title, *failure, trial.compared());
    std::size_t size = 0;
    for (const auto& [name, text] : files) size += text.size();
    return size <= kMostText ? files : refuse(kTooLarge);
  } catch (const NotWritable& error) {
    return refuse(error.what());
  }
}

}  // namespace grader::judge
