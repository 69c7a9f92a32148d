// STAFF ONLY. The record of a class: one file, class.sqlite, that holds data that can't be made again or must
// agree: results, costs, hand-ins, the names that students' inputs are drawn from, decisions of people, and
// a log of all changes. Pages, CSV and JSON are made from it, and never read back.
//
// A course may have several hand-ins (hand_ins.h) in one record, which share people, roster and these
// names. An object of this class is about one of them, unless a comment says otherwise.
//
// Several processes and threads may use it at once. Each change is one transaction: a process that is killed
// leaves all of it or nothing.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/archives/accounted.h"
#include "grader/record/comments.h"
#include "grader/record/database.h"
#include "grader/record/points/decisions.h"
#include "grader/record/points/rules.h"
#include "grader/record/same_people.h"
#include "grader/result/costs.h"
#include "grader/result/result.h"
#include "grader/result/study.h"
#include "grader/roster/class_list.h"
#include "grader/roster/hidden_names.h"

namespace grader::inline record {

inline constexpr const char* kRecordFile = "class.sqlite";  // no submission has this name

// Follows a hand-in's name in the name of its stage, where a regrade gathers results until all are there. A
// stage is a hand-in that only its own Record sees. No hand-in of a course file has a line break.
inline constexpr const char* kStage = "\nstage";

struct Recorded {
  SubmissionResult result;
  std::optional<SubmissionStudy> study = {};
  TimingByExercise costs = {};
  Lateness late = {};  // set by find_decided
};

// Holds a version that was handed in, as its download describes it.
struct HandedIn {
  std::string time = {};     // see grader/text/time_text.h; "": it has none; "-": a table has an empty cell
  std::string files = {};    // is their hash: another hash is another version; "": unknown
  bool marked_late = false;  // by the learning system

  bool operator==(const HandedIn&) const = default;
};

struct LogEntry {
  std::string at, who, did, detail;  // "2025-03-04 10:15:22" (UTC), "ada", "graded"; detail: JSON
};

struct Published;  // changes.h

class Record {
 public:
  static bool is_in(const std::filesystem::path& folder);

  // Makes the record if it is missing; the folder must exist. Throws BadInput as Database and migrate do.
  // `hand_in` is "" if the course has one without a name. A new hand-in is stored with the first change.
  explicit Record(const std::filesystem::path& folder, Journal journal = Journal::best);
  Record(const std::filesystem::path& folder, std::string hand_in, Journal journal = Journal::best);

  // Names who changes it from now on, in place of this process's user.
  void act_as(std::string who) { who_ = std::move(who); }
  // Makes all changes of `changes` one transaction: nothing is changed if it throws. Returns them for
  // take_back, which returns false, and changes nothing, if others have changed the same rows since.
  std::string in_one(const std::function<void()>& changes);
  bool take_back(const std::string& changes, const std::vector<std::string>& people, const std::string& what);

  const std::string& hand_in() const { return hand_in_; }
  std::filesystem::path pages() const;        // is the folder of its pages: the record's, or one below
  std::vector<std::string> named_hand_ins();  // lists the record's, in the order of their due dates

  // This is JSON of grading/made_by.h; "": nothing was graded.
  std::string made_by();
  void set_made_by(const std::string& json);

  // Returns the names of their rows, found by their owners (same_people.h).
  std::vector<RowName> row_names(const std::vector<HandIn>& hand_ins);

  // Returns the name that seeds a hand-in's inputs, and stores it at first (same_people.h). Call put_people
  // first.
  std::string drawn_from(const std::string& name);

  // Replaces the earlier result of this student; the log has both. If the new one has no time, the earlier
  // time of the same files stays. Returns that earlier time, "" if there was none.
  std::string put(const Recorded& one, const HandedIn& handed_in = {});

  // Removes the results of a stage if they were made otherwise.
  void begin_stage(const std::string& made_by);
  // Puts all results of this hand-in's stage, and how they were made, in the place of its own; decisions
  // follow their categories. Returns hand-ins that are not in the stage yet: then nothing changes.
  std::vector<std::string> take_stage();

  // Sets time and mark of the version that counts. Without a new time the old one stays. Returns the old one.
  std::string set_handed_in(const std::string& name, const HandedIn& handed_in);
  std::string handed_in(const std::string& name);  // returns the time; "": unknown

  // Earlier owners of hand-ins stay if they are not named again. A roster replaces the earlier one. With
  // `only` one owner is stored; all of them identify earlier hand-ins.
  void put_people(const std::vector<HandIn>& hand_ins, const std::optional<std::vector<Person>>& roster = {},
                  const std::optional<std::string>& only = {});
  // Returns names by hand-in, for all that have an owner; nothing in blind grading.
  NamesForPeople names_for_people();

  // In blind grading names are codes from the first result on. set_blind throws BadInput if there are results
  // under names.
  bool is_blind();
  void set_blind();
  std::map<std::string, std::string> codes();  // by the name from intake
  std::optional<HiddenNames> hidden_names();   // returns nothing if grading is not blind

  // Lists hand-ins with a result, by name; one without an owner, from an older record, is left out. For the
  // course it has the latest owner.
  enum class Of { hand_in, course };
  std::vector<HandIn> hand_ins(Of of = Of::hand_in);
  // Returns nothing if no roster was given so far.
  std::optional<std::vector<Person>> roster();
  // Returns nothing without a roster, too. For the course, a group's row belongs to all its members so far.
  std::optional<ClassList> class_list(Of of = Of::hand_in);

  std::vector<std::string> names();  // have a result, sorted
  struct Row {
    std::string origin;  // see intake/submission.h
    std::string files;   // is the hash of the graded files; "": unknown
  };
  std::map<std::string, Row> rows();  // by name
  // Return the computed result; and the one with people's decisions, under the rules of the hand-in. Throw
  // BadInput if it is damaged.
  std::optional<Recorded> find(const std::string& name);
  std::optional<Recorded> find_decided(const std::string& name);
  // Does as find, without the bytes of pictures.
  std::optional<SubmissionResult> find_without_pictures(const std::string& name);

  // Uses other rules; `change` may change points before these apply.
  using ChangePoints = std::function<void(SubmissionResult&)>;
  std::optional<SubmissionResult> find_under(const std::string& name, const HandInRules& rules,
                                             const ChangePoints& change);

  // Holds the points that count, for each person with a result.
  struct Total {
    double points = 0, max_points = 0;
    double extra_credit = 0;  // among the points
  };
  std::map<std::string, Total> totals();

  HandInRules rules();  // with the record's share of extra credit, if they have none
  void set_rules(const HandInRules& rules);

  std::vector<Decision> decisions(const std::string& name);
  std::vector<std::string> conflicts(const std::string& name);  // see decisions.h
  // Replaces an earlier decision of this kind and place, but adds a comment (comments.h). Throws BadInput as
  // check does, and for an unknown name; undo does so, too, if there is no such decision. undo takes back all
  // comments of a place, or one.
  void decide(const std::string& name, Decision decision);
  void undo(const std::string& name, DecisionKind kind, const std::string& place, std::int64_t comment = 0);

  std::vector<Comment> comments();   // by id; also those that nobody has any more
  Comment comment(std::int64_t id);  // throws BadInput for an unknown id, as the others do
  // Changes it for all who have it, and returns it as it was. Throws BadInput for an unknown id, no text, and
  // points where it is not at a place.
  Comment change_comment(std::int64_t id, const std::string& text, double points);

  std::vector<Request> requests(const std::string& name = "");  // by id; "": everybody's
  // Throws BadInput for an unknown name or place, and for no text. Returns 0 if the same was asked before.
  std::int64_t ask(const std::string& name, const std::string& place, const std::string& text);
  // Throws BadInput if it is answered, or unknown; and for no text. Returns the request.
  Request answer(std::int64_t id, const std::string& text);

  void set_run(const TimingByExercise& reference, const std::optional<LastRun>& run);
  ClassCosts costs();
  std::string now();  // "2025-03-04 10:15:22" (UTC)

  // Stores files of the last run's input that reached no hand-in, and notices. Replaces those of an earlier
  // run; leaves out those of unknown people.
  void set_listed(const std::vector<Accounted>& listed);
  std::vector<Accounted> listed();

  // Remembers in the log what students were told, and returns the last of it.
  void put_published(const std::map<std::string, Published>& by_name);
  std::optional<Published> published(const std::string& name);

  // Stores cells that went into a learning system's table: if they differ later, a person changed them.
  void put_entered(const std::vector<std::pair<std::string, std::string>>& cells);
  std::vector<std::string> entered(const std::string& name);

  // Returns the oldest first; throws BadInput for a name that the record does not have.
  std::vector<LogEntry> log(const std::string& name);

  // Removes all data of a person, in all hand-ins, and on the roster, too. Throws BadInput for an unknown
  // name. Then shred() clears free pages and journal of all bytes that were deleted; it throws BadInput if
  // another process reads for a minute meanwhile.
  void forget(const std::string& name);
  void shred();

  std::string export_json();  // returns all data except pictures' bytes

 private:
  friend class DeskRows;
  struct Dated;  // another hand-in of the record, with a due date

  std::int64_t assignment();
  std::int64_t make_assignment();
  std::int64_t person(const std::string& name, const std::string& drawn_from);  // makes it
  std::int64_t known_person(const std::string& name);
  std::optional<Recorded> read(const std::string& name, bool with_pictures = true);
  HandInRules stored_rules();
  HandInRules with_share(HandInRules rules);
  HandInRules rules_from(const std::string& text) const;
  std::vector<Dated> dated();  // in the order of their due dates
  HandedIn handed_in(std::int64_t assignment, const std::string& name);
  double days_given(std::int64_t assignment, const std::string& name);
  int free_days_left(const HandInRules& rules, const std::string& name);
  SubmissionResult under_rules(SubmissionResult result, HandInRules rules, const ChangePoints& change,
                               Lateness* late = nullptr);
  SubmissionResult computed(const std::string& name);  // with places for points by hand
  void put_comment(std::int64_t person, Decision& decision);
  HandIn hand_in_of(const DatabaseRow& row) const;
  std::vector<HandIn> read_hand_ins(Of of);
  std::vector<Drawn> read_drawn();
  void put_roster(const std::vector<Person>& roster);
  std::optional<ClassList> read_class_list(const std::vector<HandIn>& hand_ins);
  std::vector<HandIn> read_owned();
  std::int64_t stage_of_this();
  void leave_stage(std::int64_t person);
  void follow_categories(std::int64_t assignment, std::int64_t person = 0);  // 0: everybody
  void forget_on_roster(const std::string& hand_in);
  void add_to_log(std::optional<std::int64_t> person, const std::string& did, const std::string& detail);
  std::string picture(const std::string& digest);
  void remove_pictures_that_none_shows();

  std::string hand_in_, who_;
  Database database_;
};

std::string user();  // returns this process's user, for the log

// Returns the computed result of `name` in the record of a folder; nothing if there is none.
std::optional<SubmissionResult> recorded_result(const std::filesystem::path& folder, const std::string& name);

}  // namespace grader::record
