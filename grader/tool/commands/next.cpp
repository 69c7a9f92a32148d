// STAFF ONLY. `hairgrade next`: the command that comes next in a course's own folder, and why.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/published.h"
#include "grader/record/record.h"
#include "grader/text/shell_word.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/course_folder.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kEndings{"", ".zip", ".tar.gz", ".tgz", ".tar"};

struct Step {
  std::string command, why;
};

std::string amount(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

struct Download {
  fs::path path;
  std::string since;  // it is here, UTC, as the record writes times
};

bool is_named(const std::string& file, const std::string& hand_in) {
  if (!file.starts_with(hand_in)) return false;
  const std::string rest = file.substr(hand_in.size());  // " (1).zip": a browser's second copy
  return rest.starts_with(" (") || std::ranges::count(kEndings, rest) > 0;
}

std::string here_since(const fs::path& file) {
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0) return "";
  struct tm utc = {};
  std::array<char, 32> text;
  gmtime_r(&status.st_ctime, &utc);  // a file that is moved here keeps its own time of change
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &utc)};
}

// Returns the newest download of this name; without a name, all that lies in the folder.
std::optional<Download> download_of(const std::string& hand_in) {
  std::optional<Download> newest;
  if (!fs::is_directory(kDownloads)) return newest;
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kDownloads)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || !(hand_in.empty() || is_named(name, hand_in))) continue;
    ++files;
    if (const std::string since = here_since(entry.path()); !newest || since > newest->since)
      newest = {entry.path(), since};
  }
  if (files > 1 && hand_in.empty()) newest->path = kDownloads;
  return newest;
}

Step give_back(Record& record, const std::string& of_hand_in, const std::optional<Download>& download,
               const std::string& why) {
  const std::vector<HandIn> hand_ins = record.hand_ins();
  const std::string system = hand_ins.empty() ? "" : hand_ins.front().system;
  static const std::set<std::string> kFilled{"canvas", "moodle", "brightspace", "blackboard"};
  if (kFilled.contains(system))
    return {"hairgrade gradebook " + system + " --fill EXPORTED.csv --out filled.csv" + of_hand_in,
            why + (system == "canvas" && download
                       ? "; then hairgrade feedback canvas " + shell_word(download->path.string()) +
                             " --out feedback.zip" + of_hand_in
                       : std::string())};
  return {"hairgrade gradebook gradescope --out grades.csv" + of_hand_in,
          why + "; each student's page is " + record.pages().string() + "/NAME/report.html"};
}

std::optional<Step> step_of(const CourseHandIn& hand_in, bool several) {
  const std::string of_hand_in = several ? " --hand-in " + shell_word(hand_in.name) : "";
  const std::optional<Download> download = download_of(hand_in.name);
  const auto grade = [&](const std::string& more, const std::string& why) {
    return Step{"hairgrade grade " + shell_word(download->path.string()) + of_hand_in + more, why};
  };
  bool is_recorded = Record::is_in(kGrades);
  if (is_recorded && several) {
    const std::vector<std::string> recorded = Record(kGrades).named_hand_ins();
    is_recorded = std::ranges::count(recorded, hand_in.name) > 0;
  }
  if (!is_recorded)
    return download ? std::optional(grade("", "a download lies here that is not graded")) : std::nullopt;
  Record record(kGrades, hand_in.name);
  const std::vector<std::string> names = record.names();
  const ClassCosts costs = record.costs();
  if (download && costs.last_run && !costs.last_run->is_whole())
    return grade(" --resume", "the last run ended before all were graded");
  if (download && (!costs.last_run || download->since > costs.last_run->began))
    return grade(" --resume", "this download is newer than the grades");
  if (download && !costs.ended_by_the_clock.empty())
    return grade(" --resume", amount(costs.ended_by_the_clock.size(), "hand-in") + " ended by the clock");
  std::size_t conflicts = 0, untold = 0;
  for (const std::string& name : names) {
    conflicts += record.conflicts(name).size();
    const std::vector<Decision> decisions = record.decisions(name);
    untold +=
        !record.published(name) && std::ranges::count(decisions, DecisionKind::hold, &Decision::kind) == 0;
  }
  const std::vector<Request> requests = record.requests();
  const auto open = static_cast<std::size_t>(std::ranges::count_if(requests, &Request::is_open));
  if (conflicts > 0 || open > 0)
    return Step{"hairgrade review" + of_hand_in,
                amount(conflicts, "conflict") + " and " + amount(open, "request") + " wait for a decision"};
  if (untold > 0)
    return give_back(record, of_hand_in, download, amount(untold, "hand-in") + ": graded, and not told yet");
  if (const std::size_t changed = published_changes(record).students; changed > 0)
    return Step{
        "hairgrade diff --published changed.csv" + of_hand_in,
        "told another total than now: " + amount(changed, "student") + "; give back again after that"};
  return {};
}

int next() {
  if (!in_course_folder())
    throw BadInput(
        "this is no course's folder: it has no course.json; hairgrade new-course FOLDER makes one");
  const std::vector<CourseHandIn> hand_ins =
      read_hand_ins(read_course(HAIR_EXERCISES_JSON, kCourseFile), kCourseFile);
  const auto say = [](const Step& step) {
    std::cout << step.command << "\n  # " << step.why << "\n";
    return 0;
  };
  if (!fs::exists(kHandout)) return say({"hairgrade handout", "students need the course's handout"});
  for (const CourseHandIn& hand_in : hand_ins)
    if (const std::optional<Step> step = step_of(hand_in, !hand_in.name.empty())) return say(*step);
  std::cout << "Nothing waits. Put the next download into " << kDownloads << "/"
            << (fs::exists(kRoster) ? "" : ", and a list of people into roster.csv") << ".\n";
  return 0;
}

}  // namespace

Command add_next(CLI::App& hairgrade) {
  return {hairgrade.add_subcommand("next", "Print the command that comes next in a course's folder"), next};
}

}  // namespace grader::tool
