// STAFF ONLY. `hairgrade next`: the command that comes next in a course's own folder, and why.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "grader/class_folder/shared_plan.h"
#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/record/changes.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/record.h"
#include "grader/result/json_fields.h"
#include "grader/review/item_list.h"
#include "grader/text/shell_word.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"

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

// Counts those who were not told by this command, whom nobody holds.
std::size_t not_told(Record& record, const std::string& command) {
  return static_cast<std::size_t>(std::ranges::count_if(record.names(), [&](const std::string& name) {
    const auto told = [&](const LogEntry& entry) {
      return entry.did == "published" &&
             from_json_text<Published>(entry.detail, "the log").by.starts_with(command);
    };
    return std::ranges::none_of(record.log(name), told) &&
           std::ranges::count(record.decisions(name), DecisionKind::hold, &Decision::kind) == 0;
  }));
}

std::optional<Step> give_back(Record& record, const std::string& of_hand_in,
                              const std::optional<Download>& download) {
  const std::vector<HandIn> hand_ins = record.hand_ins();
  const std::string system = hand_ins.empty() ? "" : hand_ins.front().system;
  static const std::set<std::string> kFilled{"canvas", "moodle", "brightspace", "blackboard"};
  if (const std::size_t untold = not_told(record, "gradebook"); untold > 0) {
    const std::string why = amount(untold, "hand-in") + ": graded, and in no gradebook yet";
    if (kFilled.contains(system))
      return Step{"hairgrade gradebook " + system + " --fill EXPORTED.csv --out filled.csv" + of_hand_in,
                  why};
    return Step{"hairgrade gradebook gradescope --out grades.csv" + of_hand_in,
                why + "; each student's page is " + record.pages().string() + "/NAME/report.html"};
  }
  if (const std::size_t untold = not_told(record, "feedback"); untold > 0 && system == "canvas" && download)
    return Step{"hairgrade feedback canvas " + shell_word(download->path.string()) + " --out feedback.zip" +
                    of_hand_in,
                amount(untold, "hand-in") + ": without feedback yet"};
  return {};
}

// Counts what the desk has for a person to decide before points are told: from what could not be taken to
// requests.
std::string undecided(Record& record) {
  std::map<ItemKind, std::size_t> waiting;
  for (const Item& item : ItemList(record, "next").items())
    if (item.kind <= ItemKind::request && !item.is_decided()) ++waiting[item.kind];
  std::string all;
  for (const auto& [kind, count] : waiting)
    all += (all.empty() ? "" : ", ") + heading_of(kind) + ": " + std::to_string(count);
  return all;
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
  const ClassCosts costs = record.costs();
  if (download && costs.last_run && !costs.last_run->is_whole())
    return grade(" --resume", "the last run ended before all were graded");
  if (download && (!costs.last_run || download->since > costs.last_run->began))
    return grade(" --resume", "this download is newer than the grades");
  if (download && !costs.ended_by_the_clock.empty())
    return grade(" --resume", amount(costs.ended_by_the_clock.size(), "hand-in") + " ended by the clock");
  if (const std::string waiting = undecided(record); !waiting.empty())
    return Step{"hairgrade review" + of_hand_in, "a person must decide: " + waiting};
  if (const std::optional<Step> step = give_back(record, of_hand_in, download)) return step;
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
  if (!fs::exists(kHandout) && !Record::is_in(kGrades) && !download_of("")) {
    const bool is_unwritten = hair::bytes_of(kCourseFile) == unwritten_course_file();
    return say(
        {"hairgrade handout", std::string("students need the course's handout") +
                                  (is_unwritten ? "; course.json is still as new-course wrote it" : "")});
  }
  if (Record::is_in(kGrades) && SharedPlan::in(kGrades))
    return say({"hairgrade collect", "a cluster has hand-ins that are not in the grades yet"});
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
