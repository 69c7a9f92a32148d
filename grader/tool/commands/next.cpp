// STAFF ONLY. `hairgrade next`: the command that comes next in a course's own folder, and why.
#include <sys/stat.h>

#include <algorithm>
#include <array>
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
#include "grader/text/time_text.h"
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
  fs::path newest, all;  // all: the folder, if it has several
  time_t since;          // the newest is here
};

bool is_named(const std::string& file, const std::string& hand_in) {
  if (!file.starts_with(hand_in)) return false;
  const std::string rest = file.substr(hand_in.size());  // " (1).zip": a browser's second copy
  return rest.starts_with(" (") || std::ranges::count(kEndings, rest) > 0;
}

// A file that is moved here keeps its own time of change, so this is the time of its entry.
time_t here_since(const fs::path& file) {
  struct stat status = {};
  return stat(file.c_str(), &status) == 0 ? status.st_ctime : 0;
}

// Returns the downloads of this name that came after this time; the newest alone counts of a name's copies.
std::optional<Download> download_of(const std::string& hand_in, time_t after = 0) {
  std::optional<Download> newest;
  if (!fs::is_directory(kDownloads)) return newest;
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kDownloads)) {
    const std::string name = entry.path().filename().string();
    const time_t since = here_since(entry.path());
    if (name.starts_with(".") || since <= after || !(hand_in.empty() || is_named(name, hand_in))) continue;
    ++files;
    if (!newest || since > newest->since) newest = {entry.path(), entry.path(), since};
  }
  if (files > 1 && hand_in.empty()) newest->all = kDownloads;
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

std::optional<Step> give_back(Record& record, const std::string& due, const std::string& of_hand_in,
                              const std::optional<Download>& download) {
  const std::vector<HandIn> hand_ins = record.hand_ins();
  const std::string system = hand_ins.empty() ? "" : hand_ins.front().system;
  static const std::set<std::string> kFilled{"canvas", "moodle", "brightspace", "blackboard"};
  if (const std::size_t untold = not_told(record, "gradebook"); untold > 0) {
    std::string why = amount(untold, "hand-in") + ": graded, and in no gradebook yet";
    if (const std::string unknown = without_time(record, record.names()); !due.empty() && !unknown.empty())
      why += "; nobody knows whether these are late: " + unknown +
             " (before that grade again, with --resume --times TABLE)";
    if (kFilled.contains(system))
      return Step{"hairgrade gradebook " + system + " --fill EXPORTED.csv --out filled.csv" + of_hand_in,
                  why};
    return Step{"hairgrade gradebook gradescope --out grades.csv" + of_hand_in,
                why + "; each student's page is " + record.pages().string() + "/NAME/report.html"};
  }
  const std::string of = system == "moodle"               ? "EXPORTED.csv"
                         : system == "canvas" && download ? shell_word(download->newest.string())
                                                          : "";
  if (const std::size_t untold = not_told(record, "feedback"); untold > 0 && !of.empty())
    return Step{"hairgrade feedback " + system + " " + of + " --out feedback.zip" + of_hand_in,
                amount(untold, "hand-in") + ": without feedback yet"};
  return {};
}

// This is true if a person has set the points that the item is about, at a shell, since it was graded.
bool has_points(Record& record, const Item& item) {
  return item.kind < ItemKind::conflict && std::ranges::all_of(item.people, [&](const std::string& name) {
           std::string graded;
           for (const LogEntry& entry : record.log(name))
             if (entry.did == "graded") graded = std::max(graded, entry.at);
           return std::ranges::any_of(record.decisions(name), [&](const Decision& one) {
             return one.kind == DecisionKind::points && (one.place.empty() || one.place == item.exercise) &&
                    one.at >= graded;
           });
         });
}

// Counts what the desk has for a person to decide before points are told: from what could not be taken to
// requests.
std::string undecided(Record& record) {
  std::map<ItemKind, std::size_t> waiting;
  for (const Item& item : ItemList(record, "next").items())
    if (item.kind <= ItemKind::request && !item.is_decided() && !has_points(record, item))
      ++waiting[item.kind];
  std::string all;
  for (const auto& [kind, count] : waiting)
    all += (all.empty() ? "" : ", ") + heading_of(kind) + ": " + std::to_string(count);
  return all;
}

std::optional<Step> step_of(const CourseHandIn& hand_in, bool several) {
  const std::string of_hand_in = several ? " --hand-in " + shell_word(hand_in.name) : "";
  const std::optional<Download> download = download_of(hand_in.name);
  const auto grade = [&](const Download& which, const std::string& more, const std::string& why) {
    return Step{"hairgrade grade " + shell_word(which.all.string()) + of_hand_in + more, why};
  };
  bool is_recorded = Record::is_in(kGrades);
  if (is_recorded && several) {
    const std::vector<std::string> recorded = Record(kGrades).named_hand_ins();
    is_recorded = std::ranges::count(recorded, hand_in.name) > 0;
  }
  if (!is_recorded)
    return download ? std::optional(grade(*download, "", "a download lies here that is not graded"))
                    : std::nullopt;
  Record record(kGrades, hand_in.name);
  const ClassCosts costs = record.costs();
  if (download && costs.last_run && !costs.last_run->is_whole())
    return grade(*download, " --resume", "the last run ended before all were graded");
  const std::optional<TimeText> began = read_time(costs.last_run ? costs.last_run->began : "");
  if (const auto later = download_of(hand_in.name, began ? began->clock.count() : 0))
    return grade(*later, " --resume", "this download is newer than the grades");
  if (download && !costs.ended_by_the_clock.empty())
    return grade(*download, " --resume",
                 amount(costs.ended_by_the_clock.size(), "hand-in") + " ended by the clock");
  if (const std::string waiting = undecided(record); !waiting.empty())
    return Step{"hairgrade review" + of_hand_in, "a person must decide: " + waiting};
  if (const std::optional<Step> step = give_back(record, hand_in.rules.due, of_hand_in, download))
    return step;
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
            << (hand_ins.front().name.empty() ? "" : ", named after its hand-in")
            << (fs::exists(kRoster) ? "" : ", and a list of people into roster.csv") << ".\n";
  return 0;
}

}  // namespace

Command add_next(CLI::App& hairgrade) {
  return {hairgrade.add_subcommand("next", "Print the command that comes next in a course's folder"), next};
}

}  // namespace grader::tool
