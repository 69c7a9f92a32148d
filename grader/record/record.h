// STAFF ONLY. The record of a class: one file, class.sqlite, that holds what can't be made again or must
// agree: results, costs, hand-ins, what a student's inputs are drawn from, decisions of people, and who did
// what and when. Pages, CSV and JSON are made from it, and never read back.
//
// A course may have several hand-ins (hand_ins.h) in one record, which share people, roster and what inputs
// are drawn from. An object of this class is about one of them, but where a comment says otherwise.
//
// Several processes and threads may use it at once. Each change is one transaction: a process that is killed
// leaves all of it or nothing.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/accounted.h"
#include "grader/record/database.h"
#include "grader/record/decisions.h"
#include "grader/record/rules.h"
#include "grader/record/same_people.h"
#include "grader/result/costs.h"
#include "grader/result/result.h"
#include "grader/result/study.h"
#include "grader/roster/class_list.h"
#include "grader/roster/hidden_names.h"

namespace grader::inline record {

inline constexpr const char* kRecordFile = "class.sqlite";  // no submission is called so

struct StudyPair {
  SubmissionStudy own, beside_itself;  // the student's, and the reference's in the same run
};

struct Recorded {
  SubmissionResult result;
  std::optional<StudyPair> study = {};
  TimingByExercise costs = {};
  Lateness late = {};  // of find_decided
};

// A version that was handed in, as its download says it.
struct HandedIn {
  std::string time = {};     // grader/text/time_text.h; "": it has none; "-": a table says that there is none
  std::string files = {};    // their hash: others are another version; "": nobody knows it
  bool marked_late = false;  // by the learning system

  bool operator==(const HandedIn&) const = default;
};

struct LogEntry {
  std::string at, who, did, detail;  // "2025-03-04 10:15:22" (UTC), "ada", "graded"; detail: JSON
};

class Record {
 public:
  static bool is_in(const std::filesystem::path& folder);

  // Makes it if it is not there; the folder is. Throws BadInput as Database and migrate do.
  // `hand_in` is "" where the course has one without a name. One that is new is there from the first change
  // on.
  explicit Record(const std::filesystem::path& folder, Journal journal = Journal::best);
  Record(const std::filesystem::path& folder, std::string hand_in, Journal journal = Journal::best);

  const std::string& hand_in() const { return hand_in_; }
  std::filesystem::path pages() const;        // the folder of its pages: the record's, or one below
  std::vector<std::string> named_hand_ins();  // of the record, in the order of their due dates

  // JSON of tool/made_by.h; "": nothing was graded.
  std::string made_by();
  void set_made_by(const std::string& json);

  // The names of their rows, by whose they are (same_people.h).
  std::vector<RowName> row_names(const std::vector<HandIn>& hand_ins);

  // The name that a hand-in's inputs are drawn from is stored at first sight (same_people.h). put_people
  // comes first.
  std::string drawn_from(const std::string& name);

  // Replaces the earlier result of this student; the log has both. Without a time, one that these files had
  // before stays. Returns that earlier time, "" if there was none.
  std::string put(const Recorded& one, const HandedIn& handed_in = {});

  // Sets time and mark of the version that counts. Without a new time the old one stays. Returns the old one.
  std::string set_handed_in(const std::string& name, const HandedIn& handed_in);
  std::string handed_in(const std::string& name);  // the time; "": nobody knows it

  // Owners of hand-ins that were there before stay if they are not named again. A roster replaces the earlier
  // one. With `only` one owner is stored; all tell whose earlier hand-ins are.
  void put_people(const std::vector<HandIn>& hand_ins, const std::optional<std::vector<Person>>& roster = {},
                  const std::optional<std::string>& only = {});
  // By hand-in, of all that have an owner; nothing where grading is blind.
  NamesForPeople names_for_people();

  // Blind grading: names are codes from the first result on. set_blind throws BadInput if there are results
  // under names.
  bool is_blind();
  void set_blind();
  std::map<std::string, std::string> codes();  // by the name that intake found
  std::optional<HiddenNames> hidden_names();   // nothing if grading is not blind

  // With a result, by name. One without an owner, of an older record, has none here. Of the course: the owner
  // of the latest.
  enum class Of { hand_in, course };
  std::vector<HandIn> hand_ins(Of of = Of::hand_in);
  // Nothing if no roster was given so far.
  std::optional<std::vector<Person>> roster();
  // Likewise. Of the course: a group's row is of everybody who was in it.
  std::optional<ClassList> class_list(Of of = Of::hand_in);

  std::vector<std::string> names();  // of those with a result, sorted
  struct Row {
    std::string origin;  // intake/origin.h
    std::string files;   // the hash of those that it was graded for; "": nobody knows it
  };
  std::map<std::string, Row> rows();  // by name
  // As it was computed; and with the decisions of people, under the rules of the hand-in. Throw BadInput if
  // it is damaged.
  std::optional<Recorded> find(const std::string& name);
  std::optional<Recorded> find_decided(const std::string& name);

  // Under other rules; `change` may change points before these apply.
  using ChangePoints = std::function<void(SubmissionResult&)>;
  std::optional<SubmissionResult> find_under(const std::string& name, const HandInRules& rules,
                                             const ChangePoints& change);

  // Points as they count; of everybody with a result.
  struct Total {
    double points = 0, max_points = 0;
  };
  std::map<std::string, Total> totals();

  HandInRules rules();
  void set_rules(const HandInRules& rules);

  std::vector<Decision> decisions(const std::string& name);
  // Replaces an earlier one of this kind and place. Throws BadInput as check does, and for an unknown name;
  // undo does so, too, if there is no such decision.
  void decide(const std::string& name, Decision decision);
  void undo(const std::string& name, DecisionKind kind, const std::string& place);

  void set_run(const TimingByExercise& reference, const std::optional<LastRun>& run);
  ClassCosts costs();
  std::string now();  // "2025-03-04 10:15:22" (UTC)

  // Files of the last run's input that reached no hand-in, and notices. Replaces those of an earlier run;
  // leaves out those of people whom it does not know.
  void set_listed(const std::vector<Accounted>& listed);
  std::vector<Accounted> listed();

  // Cells that a learning system's table got of hand-ins: later ones that differ are a person's.
  void put_entered(const std::vector<std::pair<std::string, std::string>>& cells);
  std::vector<std::string> entered(const std::string& name);

  // Oldest first; throws BadInput for a name that the record does not have.
  std::vector<LogEntry> log(const std::string& name);

  // Removes all of a person, of all hand-ins, and on the roster, too. Throws BadInput for an unknown name.
  // Then shred() clears free pages and journal of all bytes that were deleted; it throws BadInput if another
  // process reads for a minute meanwhile.
  void forget(const std::string& name);
  void shred();

  std::string export_json();  // all that it holds, but for pictures' bytes

 private:
  struct Dated;  // another hand-in of the record, with a due date

  std::int64_t assignment();
  void make_assignment();
  std::int64_t person(const std::string& name, const std::string& drawn_from);  // makes it
  std::int64_t known_person(const std::string& name);
  std::optional<Recorded> read(const std::string& name, bool with_pictures = true);
  HandInRules stored_rules();
  HandInRules rules_from(const std::string& text) const;
  std::vector<Dated> dated();  // in the order of their due dates
  HandedIn handed_in(std::int64_t assignment, const std::string& name);
  double days_given(std::int64_t assignment, const std::string& name);
  int free_days_left(const HandInRules& rules, const std::string& name);
  SubmissionResult under_rules(SubmissionResult result, const HandInRules& rules, const ChangePoints& change,
                               Lateness* late = nullptr);
  std::vector<Decision> decisions_of(const std::string& name);
  HandIn hand_in_of(const DatabaseRow& row) const;
  std::vector<HandIn> read_hand_ins(Of of);
  std::vector<Drawn> read_drawn();
  void put_roster(const std::vector<Person>& roster);
  std::optional<std::vector<Person>> read_roster();
  std::optional<ClassList> read_class_list(const std::vector<HandIn>& hand_ins);
  std::vector<HandIn> read_owned();
  bool read_is_blind();
  void forget_on_roster(const std::string& hand_in);
  void add_to_log(std::optional<std::int64_t> person, const std::string& did, const std::string& detail);
  std::string picture(const std::string& digest);
  void remove_pictures_that_none_shows();

  std::string hand_in_;
  std::mutex one_at_a_time_;
  Database database_;
};

std::string user();  // who runs this process: for the log

// The result of `name` in the record of a folder, as it was computed; nothing without one.
std::optional<SubmissionResult> recorded_result(const std::filesystem::path& folder, const std::string& name);

}  // namespace grader::record
