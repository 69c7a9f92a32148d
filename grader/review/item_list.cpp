// STAFF ONLY. Keeps the items of a record.
#include "grader/review/item_list.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "grader/class_folder/blind.h"
#include "grader/course/input.h"

namespace grader::inline review {

ItemList::ItemList(Record& record, std::string who, std::function<std::int64_t()> clock)
    : record_(record), rows_(record), who_(std::move(who)), clock_(std::move(clock)) {
  record_.act_as(who_);
  refresh();
  if (const std::map<RowOfItem, std::string> looks = first_look(facts_); !looks.empty()) rows_.know(looks);
}

std::int64_t ItemList::seconds_now() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

void ItemList::refresh() {
  const auto state = rows_.state();
  if (state == state_) return;
  std::map<std::string, std::int64_t> versions = rows_.versions();
  std::erase_if(facts_.people, [&](const auto& one) { return !versions.contains(one.first); });
  for (const auto& [name, now] : versions) {
    if (versions_[name] == now) continue;
    facts_.people[name] = {record_.find_without_pictures(name).value_or(SubmissionResult{}),
                           record_.decisions(name), record_.handed_in(name)};
  }
  versions_ = std::move(versions);
  const std::optional<HiddenNames> hidden = record_.hidden_names();
  lines_ = lines_of(record_.class_list(), record_.hand_ins());
  if (hidden) lines_ = blind(lines_);
  facts_.requests = record_.requests();
  facts_.rules = record_.rules();
  facts_.rows = rows_.all();
  items_ = items_of(facts_);
  if (hidden)
    for (Item& item : items_) item.why = hidden->in(item.why);
  state_ = state;
}

std::vector<Item> ItemList::items() {
  refresh();
  return items_;
}

const Item* ItemList::found(const std::string& key) const {
  const auto item = std::ranges::find_if(items_, [&](const Item& one) { return one.key() == key; });
  return item == items_.end() ? nullptr : &*item;
}

std::optional<Item> ItemList::find(const std::string& key) {
  refresh();
  const Item* item = found(key);
  return item ? std::optional(*item) : std::nullopt;
}

std::vector<ProgressOfTa> ItemList::progress() {
  refresh();
  return grader::progress(items_, facts_.rows);
}

const Item& ItemList::as_shown(const std::string& key, const std::string& version) const {
  const Item* item = found(key);
  if (!item)
    throw ChangedMeanwhile(
        "This is not in the list any more: others have decided it, or it was graded again");
  if (item->version == version) return *item;
  throw ChangedMeanwhile(item->is_decided() ? item->decided_by + " has decided this meanwhile, at " +
                                                  item->decided_at + "; look at it again"
                                            : "This has changed meanwhile; look at it again");
}

// Accepting an item about a decision says that it holds for the present points, too. Where its place is gone,
// it goes.
void ItemList::keep_decision(const std::string& name, const Item& item) {
  const ItemPerson& person = facts_.people.at(name);
  for (const Decision& decision : person.decisions) {
    if (place_of_conflict(decision.place, to_string(decision.kind)) != item.place) continue;
    try {
      record_.decide(name, decision);
    } catch (const BadInput&) {
      if (points_at(person.computed, decision.place)) throw;
      record_.undo(name, decision.kind, decision.place, decision.comment);
    }
  }
}

void ItemList::save(const std::string& key, const std::string& version, const Change& change) {
  refresh();
  // Taking the decision back must not remove the item's row, with its owner.
  if (const Item* known = found(key); known && !facts_.rows.contains(known->row())) open(key);
  Item item;
  std::string changes = record_.in_one([&] {
    refresh();
    item = as_shown(key, version);
    for (const std::string& name : item.people)
      if (change)
        change(record_, name);
      else if (item.kind == ItemKind::conflict)
        keep_decision(name, item);
    rows_.accept(item.row(), item.looks, item.people, heading_of(item.kind) + ": " + item.why);
  });
  saved_.push_back({key, std::move(changes), item.people});
}

std::string ItemList::undo() {
  if (saved_.empty()) return "";
  const Saved last = std::move(saved_.back());
  saved_.pop_back();
  if (!record_.take_back(last.changes, last.people, last.key))
    throw ChangedMeanwhile("Others have changed this since, so that it was not taken back; look at it again");
  return last.key;
}

void ItemList::reopen(const std::string& key) {
  refresh();
  if (const Item* item = found(key)) rows_.accept(item->row(), "", item->people, heading_of(item->kind));
}

std::string ItemList::open(const std::string& key) {
  refresh();
  const Item* item = found(key);
  std::string other = item ? open_by_other(item->row(), facts_.rows, who_, clock_()) : "";
  const std::optional<RowOfItem> row = item && other.empty() ? std::optional(item->row()) : std::nullopt;
  rows_.open(row, clock_());
  // No item looks otherwise for that, so the list need not be made again.
  for (auto& [what, kept] : facts_.rows)
    if (kept.open_by == who_) kept.open_by.clear();
  if (row) std::tie(facts_.rows[*row].open_by, facts_.rows[*row].open_at) = std::tuple(who_, clock_());
  state_.second = rows_.state().second;
  return other;
}

void ItemList::share(const std::vector<std::string>& graders, ShareBy by) {
  refresh();
  rows_.give(shared_out(items_, graders, by, lines_));
}

}  // namespace grader::review
