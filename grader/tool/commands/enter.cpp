// STAFF ONLY. `hairgrade enter`: takes points by hand, more days and requests from a table of people.
#include <algorithm>
#include <iostream>

#include "grader/course/input.h"
#include "grader/roster/roster.h"
#include "grader/text/letters.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct EnterOptions : OfARecord {
  std::filesystem::path table;
};

// This is a column of numbers; `place` is that of points by hand.
struct NumberColumn {
  std::size_t column;
  DecisionKind kind;
  std::string place;
};

struct EnteredTable {
  Csv csv;
  std::vector<NumberColumn> numbers;
  std::size_t request, place, why;
};

EnteredTable read_table(const std::filesystem::path& file, const HandInRules& rules) {
  EnteredTable table{read_csv(file), {}, 0, 0, 0};
  const auto add = [&](const std::string& title, DecisionKind kind, const std::string& place) {
    const std::size_t column = column_of(table.csv, title);
    if (column != kNoColumn) table.numbers.push_back({column, kind, place});
    return column != kNoColumn;
  };
  std::string titles = "\"late days\", \"request\"";
  for (const auto& [id, one] : rules.by_hand) {
    if (!add(id, DecisionKind::points, id) && !one.title.empty()) add(one.title, DecisionKind::points, id);
    titles += ", \"" + id + "\"";
  }
  add("late days", DecisionKind::late_days, "");
  table.request = column_of(table.csv, "request");
  table.place = column_of(table.csv, "place");
  table.why = column_of(table.csv, "why");
  if (table.numbers.empty() && table.request == kNoColumn)
    throw BadInput(place_of(table.csv, table.csv.rows.front()) + ": no title is one of " + titles +
                   "; points by hand have the ids of \"by_hand\" in the course file");
  return table;
}

// Enters a table. Lines name the cells that were not entered.
class Entering {
 public:
  Entering(Record& record, EnteredTable table)
      : record_(record), table_(std::move(table)), people_(table_.csv) {
    std::optional<Roster> roster;
    if (std::optional<std::vector<Person>> people = record.roster()) roster.emplace(std::move(*people));
    std::vector<std::string> said;
    for (const HandIn& one : record.hand_ins())
      for (const std::size_t person :
           people_.find_all(one.owner, one.system, roster ? &*roster : nullptr, said))
        hand_ins_[person].push_back(one.name);
    for (std::size_t i = 1; i < table_.csv.rows.size(); ++i) enter_row(table_.csv.rows[i]);
    for (const auto& [whose, wanted] : wanted_) decide(whose.first, wanted);
  }

  const std::vector<std::string>& not_entered() const { return not_entered_; }
  std::size_t entered() const { return entered_; }

 private:
  struct Wanted {
    const Csv::Row* row;
    Decision decision;
    bool is_clear = true;  // false: rows of a group's members differ
  };

  void leave(const Csv::Row& row, const std::string& why) {
    not_entered_.push_back(place_of(table_.csv, row) + ": " + why);
  }

  void enter_row(const Csv::Row& row) {
    const std::optional<std::size_t> person = people_.at_line(row.line);
    if (!person) return;
    const std::vector<std::string>& names = hand_ins_[*person];
    const Person& who = people_.people()[*person];
    const std::string called = legible(who.name.empty() ? who.shown_id() : who.name);
    const auto cell = [&](std::size_t column) {
      const std::string text = composed(row.at(column));
      return text == "-" ? "" : text;
    };
    const std::string request = cell(table_.request), place = cell(table_.place);
    std::vector<std::pair<const NumberColumn*, std::string>> numbers;
    for (const NumberColumn& one : table_.numbers)
      if (const std::string text = cell(one.column); !text.empty()) numbers.emplace_back(&one, text);
    if (request.empty() && numbers.empty()) return;
    if (names.size() != 1)
      return leave(row, called + (names.empty() ? " has no hand-in here" : " has several hand-ins"));
    for (const auto& [column, text] : numbers)
      if (const std::optional<double> number = number_in(text))
        want(names.front(), {&row, {column->kind, column->place, *number, 0, cell(table_.why)}});
      else
        leave(row, called + ": \"" + legible(text, 40) + "\" is no number");
    if (!request.empty())
      try_to(row, [&] {
        return record_.ask(names.front(), place == kWhole ? "" : place, row.at(table_.request)) != 0;
      });
  }

  void want(const std::string& name, Wanted wanted) {
    const auto [there, is_new] = wanted_.emplace(std::pair(name, wanted.decision.place), wanted);
    if (!is_new && there->second.decision.number != wanted.decision.number) there->second.is_clear = false;
  }

  void decide(const std::string& name, const Wanted& wanted) {
    const Decision& decision = wanted.decision;
    if (!wanted.is_clear) return leave(*wanted.row, name + ": other rows have another number for this group");
    try_to(*wanted.row, [&] {
      for (const Decision& one : record_.decisions(name))
        if (one.kind == decision.kind && one.place == decision.place && one.number == decision.number &&
            one.why == decision.why)
          return false;
      record_.decide(name, decision);
      return true;
    });
  }

  void try_to(const Csv::Row& row, const std::function<bool()>& change) {
    try {
      entered_ += change();
    } catch (const BadInput& problem) {
      leave(row, problem.what());
    }
  }

  Record& record_;
  const EnteredTable table_;
  Roster people_;
  std::map<std::size_t, std::vector<std::string>> hand_ins_;      // by person
  std::map<std::pair<std::string, std::string>, Wanted> wanted_;  // by hand-in and place
  std::vector<std::string> not_entered_;
  std::size_t entered_ = 0;
};

int enter(const EnterOptions& options) {
  bool all = true;
  const int code = change_record(options, [&](Record& record, const std::string&) {
    const Entering entering(record, read_table(options.table, record.rules()));
    for (const std::string& line : entering.not_entered())
      std::cerr << "hairgrade: not entered: " << line << "\n";
    std::cout << entering.entered() << " entered\n";
    all = entering.not_entered().empty();
  });
  return code == 0 && !all ? 3 : code;
}

}  // namespace

Command add_enter(CLI::App& hairgrade) {
  const auto options = std::make_shared<EnterOptions>();
  CLI::App* command =
      hairgrade.add_subcommand("enter", "Take points by hand, more days and requests from a table of people");
  command
      ->add_option("TABLE", options->table,
                   "A CSV of people as in a roster, with columns such as oral, late days and why, or request "
                   "and place")
      ->required();
  add_folder(*command, *options);
  return {command, [options] { return enter(*options); }};
}

}  // namespace grader::tool
