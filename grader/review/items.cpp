// STAFF ONLY. Makes items of a class's results.
#include "grader/review/items.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "grader/compile/hash.h"
#include "grader/record/points/shown_number.h"
#include "grader/report/facts/alike.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "hair/io/plot/page.h"

namespace grader::inline review {
namespace {

constexpr int kLittleLate = 60;  // minutes
constexpr int kFewestCases = 5;  // all but one of fewer cases are not nearly all

struct KindWords {
  const char *word, *heading;
};
constexpr std::array<KindWords, kItemKinds> kWords{{{"not-taken", "could not be taken"},
                                                    {"broke-rules", "broke the rules"},
                                                    {"not-final", "not final"},
                                                    {"conflict", "decided for other points"},
                                                    {"request", "asks for another look"},
                                                    {"near-threshold", "near a threshold"},
                                                    {"blown-up", "blown up"},
                                                    {"far-in-pictures", "far in pictures"},
                                                    {"alike", "fail alike"},
                                                    {"changed", "new since last time"}}};

const KindWords& words_of(ItemKind kind) {
  return kWords.at(static_cast<std::size_t>(kind));
}

std::string short_hash(const std::string& text) {
  return sha256(text).substr(0, 16);
}

std::string lost_text(const LostCategory& lost) {
  return lost.number + " " + to_string(lost.one->status) + " " + shown_points(lost.one->points) + " " +
         in_words(size_of(*lost.one)) + "\n";
}

std::string look_of(const ExerciseResult& exercise) {
  std::string text = exercise.id + " " + to_string(exercise.status) + " " + shown_points(exercise.points) +
                     " of " + shown_points(exercise.max_points) + "\n";
  for (const LostCategory& lost : lost_categories(exercise)) text += lost_text(lost);
  return text;
}

std::string look_of(const SubmissionResult& result) {
  std::string text = result.note + "\n";
  for (const ExerciseResult& exercise : result.exercises) text += look_of(exercise);
  return text;
}

bool is_about(const Decision& decision, const Item& item) {
  return decision.place.empty() || item.exercise.empty() || decision.place == item.exercise ||
         decision.place.starts_with(item.exercise + ".") || decision.place.starts_with(item.exercise + ":");
}

// This is true for an error near its limit, and if all but one of the cases hold.
bool is_near(const LostCategory& lost) {
  return size_of(*lost.one) == ErrorSize::near ||
         (lost.one->cases >= kFewestCases && lost.one->held == lost.one->cases - 1);
}

bool is_blown_up(const LostCategory& lost) {
  return size_of(*lost.one) == ErrorSize::not_finite;
}

// Says how a category was lost, in numbers if there are any.
std::string how_lost(const LostCategory& lost) {
  std::string text = lost.number + " (" + lost.one->name + ")";
  const bool has_error = lost.one->error_in_limits != 0;
  if (has_error)
    text += is_blown_up(lost) ? ": no finite number"
                              : ": " + hair::to_text(lost.one->error_in_limits) + " times the limit";
  if (lost.one->cases > 0)
    text += (has_error ? ", " : ": ") + std::to_string(lost.one->held) + " of " +
            std::to_string(lost.one->cases) + " cases hold";
  if (!has_error && lost.one->cases == 0) text += ": " + to_string(lost.one->status);
  return text;
}

class Making {
 public:
  explicit Making(const ItemFacts& facts) : facts_(facts) {
    for (const auto& [row, kept] : facts.rows) had_first_look_ |= row.what == word_of(ItemKind::changed);
  }

  std::vector<Item> all() {
    groups();
    for (const auto& [name, person] : facts_.people) {
      whole(name, person);
      for (const ExerciseResult& exercise : person.computed.exercises) one(name, exercise);
    }
    requests();
    std::ranges::sort(items_, [](const Item& a, const Item& b) {
      const auto place = [](const Item& item) {
        return std::tuple(item.is_decided(), item.kind, -std::ssize(item.people), -item.lost, item.key());
      };
      return place(a) < place(b);
    });
    return std::move(items_);
  }

 private:
  // Adds an item that looks as `look`.
  void add(Item item, const std::string& look) {
    item.looks = short_hash(look);
    const auto kept = facts_.rows.find(item.row());
    const DeskRow row = kept == facts_.rows.end() ? DeskRow{} : kept->second;
    item.owner = row.owner;
    if (row.looks == item.looks) {
      item.decided_by = row.who;
      item.decided_at = row.at;
    }
    if (item.kind == ItemKind::changed && row.looks == item.looks && row.who.empty()) return;  // is known
    std::string now = look + item.decided_by + item.decided_at;
    for (const std::string& name : item.people)
      if (const auto person = facts_.people.find(name); person != facts_.people.end())
        for (const Decision& decision : person->second.decisions)
          if (is_about(decision, item))
            now += "\n" + name + decision_text(decision) + decision.who + decision.at;
    item.version = short_hash(now);
    items_.push_back(std::move(item));
  }

  void take(Item& item, const ExerciseResult& exercise, const std::vector<LostCategory>& lost) const {
    item.exercise = exercise.id;
    item.titles = exercise.title;
    double points = 0;
    for (const LostCategory& one : lost) {
      item.categories.push_back(one.number);
      item.titles += " " + one.one->name;
      points += one.one->max_points - one.one->points;
    }
    item.lost = points;
  }

  void groups() {
    std::vector<const SubmissionResult*> results;
    for (const auto& [name, person] : facts_.people) results.push_back(&person.computed);
    for (const FailAlike& group : who_fail_alike(results)) {
      const bool near =
          std::ranges::all_of(group.sizes, [](ErrorSize size) { return size == ErrorSize::near; });
      Item item{.kind = near ? ItemKind::near_threshold : ItemKind::alike,
                .people = group.people,
                .is_group = true};
      std::string look;
      for (std::size_t i = 0; i < group.categories.size(); ++i) {
        const std::string size = in_words(group.sizes[i]);
        item.place += (i > 0 ? ", " : "") + group.categories[i] + (size.empty() ? "" : " " + size);
      }
      std::vector<LostCategory> lost;
      for (const std::string& name : group.people) {
        const ExerciseResult& exercise = *find_exercise(facts_.people.at(name).computed, group.exercise);
        Item ones;
        take(ones, exercise, lost_categories(exercise));
        ones.lost = std::max(ones.lost, item.lost);
        std::tie(item.exercise, item.categories, item.titles, item.lost) =
            std::tie(ones.exercise, ones.categories, ones.titles, ones.lost);
        look += name + "\n" + look_of(exercise);
        grouped_.emplace(name, group.exercise);
      }
      item.why = std::to_string(group.people.size()) + " people lose " + item.place +
                 (near ? ": look at the limit first" : ": one misunderstanding, or one source");
      add(std::move(item), look);
    }
  }

  void whole(const std::string& name, const ItemPerson& person) {
    const SubmissionResult& result = person.computed;
    not_taken(name, result);
    if (const std::vector<std::string>& ended = result.ended_by_the_clock; !ended.empty()) {
      Item item{.kind = ItemKind::not_final, .people = {name}};
      if (ended.size() == 1) item.exercise = ended.front();
      item.why = in_a_row(ended) + " ended by the clock: grade again";
      add(std::move(item), in_a_row(ended));
    }
    std::map<std::string, std::string> lines;  // by the item's place: a place may have several comments
    for (const Decided& one : decided(result, person.decisions).decided)
      if (!one.conflict.empty()) {
        std::string& line = lines[place_of_conflict(one.place, one.kind)];
        line += (line.empty() ? "" : "; ") + one.conflict;
      }
    for (const auto& [place, line] : lines) {
      Item item{.kind = ItemKind::conflict, .place = place, .people = {name}, .why = line};
      at(item, place.substr(0, place.find(' ')));
      add(std::move(item), line);
    }
    HandInRules later = facts_.rules;
    later.grace_minutes += kLittleLate;
    if (late_days(facts_.rules, person.handed_in).value_or(0) > 0 && late_days(later, person.handed_in) == 0)
      add({.kind = ItemKind::near_threshold,
           .place = kLate,
           .people = {name},
           .why = "Late by less than an hour: handed in " + person.handed_in + ", due " + facts_.rules.due},
          person.handed_in + facts_.rules.due);
    if (!had_first_look_) return;
    const auto row = facts_.rows.find({word_of(ItemKind::changed), name});
    const bool known = row != facts_.rows.end() && !row->second.looks.empty();
    add({.kind = ItemKind::changed,
         .people = {name},
         .lost = max_points(result) - points(result),
         .why = (known ? "The result is another one than before: " : "The hand-in is new: ") +
                shown_total(points(result), max_points(result))},
        look_of(result));
  }

  void not_taken(const std::string& name, const SubmissionResult& result) {
    std::vector<std::string> said, exercises;
    for (const ExerciseResult& exercise : result.exercises)
      if (exercise.status == Status::not_taken || exercise.status == Status::unreadable) {
        exercises.push_back(exercise.id);
        const std::string text = exercise.feedback.empty() ? to_string(exercise.status) : exercise.feedback;
        if (std::ranges::count(said, text) == 0) said.push_back(text);
      }
    if (result.note.empty() && exercises.empty()) return;
    Item item{.kind = ItemKind::not_taken, .people = {name}};
    if (exercises.size() == 1) item.exercise = exercises.front();
    item.why = result.note;
    if (item.why.empty()) {
      item.why = in_a_row(exercises) + ":";
      for (const std::string& text : said) item.why += " " + text;
    }
    for (const ExerciseResult& exercise : result.exercises)
      if (std::ranges::count(exercises, exercise.id) > 0) item.lost += exercise.max_points;
    const std::string look = item.why;
    add(std::move(item), look);
  }

  // A person's exercise is one item: of the first kind that it is.
  void one(const std::string& name, const ExerciseResult& exercise) {
    std::vector<LostCategory> lost = lost_categories(exercise);
    const auto keep = [&](const auto& holds) {
      std::vector<LostCategory> some;
      std::ranges::copy_if(lost, std::back_inserter(some), holds);
      return some;
    };
    Item item{.place = exercise.id, .people = {name}};
    const auto put = [&](ItemKind kind, const std::vector<LostCategory>& here, const std::string& why) {
      item.kind = kind;
      take(item, exercise, here);
      if (here.empty()) item.lost = exercise.max_points - exercise.points;
      item.why = why;
      for (const LostCategory& category : here)
        item.why += (&category == &here.front() ? ": " : "; ") + how_lost(category);
      add(std::move(item), look_of(exercise));
    };
    const std::vector<LostCategory> broken =
        keep([](const LostCategory& category) { return category.one->status == Status::broke_rules; });
    if (exercise.status == Status::broke_rules || !broken.empty())
      return put(ItemKind::broke_rules, broken,
                 exercise.id + " broke the rules" +
                     (broken.empty() || broken.front().one->detail.empty()
                          ? ""
                          : " (" + broken.front().one->detail + ")"));
    if (grouped_.contains({name, exercise.id})) return;
    if (const std::vector<LostCategory> near = keep(is_near); !near.empty())
      return put(ItemKind::near_threshold, near, exercise.id + " is nearly right");
    const std::vector<LostCategory> blown = keep(is_blown_up);
    if (!blown.empty() || run_breaks_off(exercise))
      return put(ItemKind::blown_up, blown,
                 exercise.id + (blown.empty() ? ": its run breaks off" : " blows up"));
    far_in_pictures(exercise, lost, put);
  }

  // A picture that is far off needs a person where the categories don't say so.
  static void far_in_pictures(const ExerciseResult& exercise, const std::vector<LostCategory>& lost,
                              const auto& put) {
    if (exercise.pictures.empty() || exercise.points <= 0) return;
    const PictureResult& worst = *std::ranges::max_element(exercise.pictures, {}, &PictureResult::flip);
    const bool only_the_run = lost.size() == 1 && lost.front().one->name == kRunTitle;
    if (!only_the_run && std::ranges::none_of(exercise.pictures, &PictureResult::far_off)) return;
    put(ItemKind::far_in_pictures, lost,
        exercise.id + " reaches " + shown_points(exercise.points) + " of " +
            shown_points(exercise.max_points) + " points, and its picture at " + worst.name +
            " is off by FLIP " + shown_number(worst.flip));
  }

  // A person's requests about a place are one item. Answers decide it, and nothing else does.
  void requests() {
    std::map<std::pair<std::string, std::string>, std::vector<const Request*>> asked;
    for (const Request& request : facts_.requests) asked[{request.name, request.place}].push_back(&request);
    for (const auto& [where, all] : asked) {
      Item item{.kind = ItemKind::request, .place = where.second, .people = {where.first}};
      at(item, where.second);
      const bool is_open = std::ranges::any_of(all, &Request::is_open);
      std::string look;
      for (const Request* request : all) {
        look += request->text + request->answered + "\n";
        if (request->is_open() == is_open) item.why += (item.why.empty() ? "" : "\n") + request->text;
      }
      add(std::move(item), look);
      items_.back().decided_by = is_open ? "" : all.back()->answered_by;
      items_.back().decided_at = is_open ? "" : all.back()->answered;
    }
  }

  static void at(Item& item, const std::string& place) {
    item.exercise = place.substr(0, place.find_first_of(".:"));
    if (place.find('.') != std::string::npos) item.categories = {place};
  }

  const ItemFacts& facts_;
  bool had_first_look_ = false;
  std::vector<Item> items_;
  std::set<std::pair<std::string, std::string>> grouped_;  // people and exercises that are in a group
};

}  // namespace

std::string word_of(ItemKind kind) {
  return words_of(kind).word;
}

std::string heading_of(ItemKind kind) {
  return words_of(kind).heading;
}

std::string place_of_conflict(const std::string& place, const std::string& kind) {
  return place + (kind == to_string(DecisionKind::points) ? "" : " (" + kind + ")");
}

RowOfItem Item::row() const {
  return {word_of(kind) + (place.empty() ? "" : " " + place),
          is_group || people.empty() ? "" : people.front()};
}

std::string Item::key() const {
  return word_of(kind) + "/" + place + "/" + row().person;
}

std::vector<Item> items_of(const ItemFacts& facts) {
  return Making(facts).all();
}

std::map<RowOfItem, std::string> first_look(const ItemFacts& facts) {
  const std::string what = word_of(ItemKind::changed);
  std::map<RowOfItem, std::string> looks;
  for (const auto& [row, kept] : facts.rows)
    if (row.what == what) return {};
  for (const auto& [name, person] : facts.people) looks[{what, name}] = short_hash(look_of(person.computed));
  return looks;
}

}  // namespace grader::review
