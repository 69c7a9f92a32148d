// STAFF ONLY. Answers the requests of the desk's page.
#include "grader/review/desk.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "grader/class_folder/class_files.h"
#include "grader/course/input.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/picture_files.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/strict_json.h"

namespace grader::inline review {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostResults = 2;  // an item shows: two who wrote the same stand below one another
constexpr std::size_t kMostText = 4000;

// Takes the text up to the next slash.
std::string take(std::string& path) {
  const std::size_t end = std::min(path.find('/'), path.size());
  std::string first = path.substr(0, end);
  path.erase(0, end + 1);
  return first;
}

std::size_t number_in(const std::string& text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

double points_in(const nlohmann::json& fields) {
  const std::string text = fields.value("number", "");
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (!text.empty() && (error != std::errc() || end != text.data() + text.size()))
    throw BadInput("\"" + printable(text) + "\" is no number of points; write one such as 2 or 1.5");
  return number;
}

Decision decision_in(const nlohmann::json& fields, DecisionKind kind) {
  Decision decision;
  decision.kind = kind;
  decision.place = fields.value("place", "");
  if (const std::string line = fields.value("line", ""); !line.empty())
    decision.place = decision.place.substr(0, decision.place.find('.')) + ":" + line;
  decision.number = points_in(fields);
  decision.comment = fields.value("comment", std::int64_t{0});
  decision.why = fields.value("text", "");
  if (decision.why.size() > kMostText)
    throw BadInput("this text is longer than " + std::to_string(kMostText) + " bytes; write a shorter one");
  return decision;
}

// Returns the bytes of a picture file (picture_files.h); "" if there is none.
std::string picture(const std::filesystem::path& pages, const std::string& name) {
  const bool is_one =
      name.size() == 68 && name.find_first_not_of("0123456789abcdef") == 64 && name.ends_with(".png");
  return is_one ? hair::bytes_of(report::pictures_folder(pages) / name) : "";
}

}  // namespace

Desk::Desk(Record& record, std::string who, std::string where)
    : record_(record), who_(who), where_(std::move(where)), list_(record, std::move(who)) {}

void Desk::refresh() {
  items_ = list_.items();
  std::map<std::string, Row> now;
  for (const Item& item : items_) now[item.key()].html = row_of(item, people_).text;
  for (const auto& [key, row] : rows_) now.try_emplace(key);
  const std::size_t next = stamp_ + 1;
  for (auto& [key, row] : now) {
    const auto old = rows_.find(key);
    row.stamp = old != rows_.end() && old->second.html == row.html ? old->second.stamp : next;
    stamp_ = std::max(stamp_, row.stamp);
  }
  rows_ = std::move(now);
}

std::string Desk::first_of(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    const std::optional<Item> found = list_.find(key);
    if (found && !found->is_decided() && list_.open(key).empty()) return key;
  }
  return "";
}

Html Desk::part(const std::string& key) {
  const std::optional<Item> found = list_.find(key);
  if (!found) {
    list_.open("");
    return nothing_left();
  }
  OpenItem open{*found, {}, {}, record_.comments(), list_.open(key)};
  for (const std::string& name : found->people) {
    if (open.results.size() < kMostResults)
      if (std::optional<Recorded> one = class_folder::find_shown(record_, name, record_.hidden_names()))
        open.results.push_back(std::move(one->result));
    for (const Decision& decision : record_.decisions(name))
      if (found->people.size() == 1)
        open.decisions.push_back(decision.who + ", " + decision.at + " UTC: " + decision_text(decision));
  }
  if (!found->categories.empty()) {
    const std::string &name = found->people.front(), &place = found->categories.front();
    const bool is_named = !record_.hand_in().empty();
    const std::filesystem::path folder = is_named ? record_.pages().parent_path() : record_.pages();
    open.reproduce = "hairgrade reproduce " + name + " " + place + " --grades " + folder.string() +
                     (is_named ? " --hand-in \"" + record_.hand_in() + "\"" : "") + " --out " + name + "-" +
                     place;
  }
  return item_part(open, people_);
}

hair::WebAnswer Desk::shown(const Shown& what, std::size_t since) {
  Json rows = Json::array();
  for (const auto& [key, row] : rows_)
    if (row.stamp > since) rows.push_back({{"key", key}, {"html", row.html}});
  const std::optional<Item> item = list_.find(what.key);
  const Json answer = {{"stamp", stamp_},
                       {"rows", rows},
                       {"progress", progress_part(list_.progress()).text},
                       {"told", what.told},
                       {"version", item ? item->version : ""},
                       {"item", what.with_item ? part(what.key).text : ""}};
  return {what.status, answer.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json"};
}

std::string Desk::page() {
  people_ = {record_.names_for_people(), {}};
  if (!record_.is_blind())
    for (ClassLine& line : lines_of(record_.class_list(), record_.hand_ins()))
      people_.lines.try_emplace(line.hand_in, line);
  refresh();
  std::vector<std::string> mine, all;
  Html rows;
  for (const Item& item : items_) {
    rows += row_of(item, people_);
    (item.owner == who_ ? mine : all).push_back(item.key());
  }
  std::string key = first_of(mine);
  if (key.empty() && mine.empty()) key = first_of(all);
  return desk_page(who_, where_, rows, stamp_, list_.progress(), part(key));
}

hair::WebAnswer Desk::save(const std::string& body) {
  const nlohmann::json fields = hair::parse_json(body, "the page's request");
  const std::string key = fields.value("key", ""), what = fields.value("do", ""),
                    version = fields.value("version", "");
  const auto then = fields.value("then", std::vector<std::string>{});
  const auto since = fields.value("stamp", std::size_t{0});
  std::string told = what == "skip" ? "" : "Saved.", back = key;
  unsigned status = 200;
  try {
    if (what == "accept") {
      list_.save(key, version);
    } else if (what == "points" || what == "comment" || what == "excuse") {
      const Decision decision = decision_in(fields, *decision_kind_from(what));
      list_.save(key, version,
                 [&](Record& record, const std::string& name) { record.decide(name, decision); });
    } else if (what == "late_days") {
      list_.save(key, version, [&](Record& record, const std::string& name) {
        Decision day{DecisionKind::late_days, "", 1, 0, "You handed in less than an hour late."};
        for (const Decision& one : record.decisions(name))
          if (one.kind == day.kind) day.number += one.number;
        record.decide(name, day);
      });
    } else if (what == "answer") {
      const std::string text = decision_in(fields, DecisionKind::comment).why;
      const std::optional<Item> item = list_.find(key);
      list_.save(key, version, [&](Record& record, const std::string& name) {
        for (const Request& request : record.requests())
          if (request.is_open() && request.name == name && item && request.place == item->place)
            record.answer(request.id, text);
      });
    } else if (what == "unset") {
      const std::optional<Item> item = list_.find(key);
      list_.save(key, version, [&](Record& record, const std::string& name) {
        for (const Decision& one : record.decisions(name))
          if (item && place_of_conflict(one.place, to_string(one.kind)) == item->place)
            record.undo(name, one.kind, one.place, one.comment);
      });
    } else if (what == "reopen") {
      list_.reopen(key);
    } else if (what == "undo") {
      back = list_.undo();
      told = back.empty() ? "There is nothing of yours to undo." : "Undone.";
      if (back.empty()) back = key;
    } else if (what != "skip") {
      throw BadInput("\"" + printable(what) + "\" is nothing that the desk does");
    }
  } catch (const ChangedMeanwhile& changed) {
    told = changed.what();
    status = 409;
  } catch (const BadInput& error) {
    told = error.what();
    status = 400;
  }
  refresh();
  if (status != 200) return shown({key, told, status}, since);
  const std::string next = then.empty() ? back : first_of(then);
  if (next.empty()) {
    told = "Nothing undecided is left in this list.";
    if (what == "skip") return shown({key, told}, since);
  }
  return shown({next, told}, since);
}

hair::WebAnswer Desk::page_of_class(const std::string& path) {
  std::string rest = path.ends_with('/') ? "" : path;
  const std::string first = take(rest), second = take(rest);
  const NamesForPeople people = record_.names_for_people();
  const auto recorded = [&](const std::string& name) {
    return class_folder::find_shown(record_, name, record_.hidden_names());
  };
  if (first == "index.html" && second.empty())
    return {200, class_folder::class_page_of(record_), hair::kHtmlType};
  if (first == "staff" && second.ends_with(".html") && rest.empty()) {
    if (const auto one = recorded(second.substr(0, second.size() - 5)))
      return {200, report::staff_page(one->result, people), hair::kHtmlType};
  } else if (first == "staff" && second == "runs") {
    const std::string name = take(rest);
    if (const auto one = rest.ends_with(".html") ? recorded(name) : std::nullopt)
      if (const ExerciseResult* exercise = find_exercise(one->result, rest.substr(0, rest.size() - 5));
          exercise && !exercise->motions.student.empty())
        return {200, report::run_page(one->result, *exercise, people), hair::kHtmlType};
  } else if (first == "staff" && second == "pictures") {
    if (const std::string png = picture(record_.pages(), rest); !png.empty()) return {200, png, "image/png"};
  } else if (rest.empty() && second == "report.html") {
    if (const auto one = recorded(first))
      return {200, report::student_page(one->result, people), hair::kHtmlType};
  } else if (rest.empty() && second == "study.html") {
    if (const auto one = recorded(first); one && one->study)
      return {200, report::study_page(one->result, *one->study, people), hair::kHtmlType};
  }
  return {404, "the desk has no such page; files are written when it ends\n"};
}

hair::WebAnswer Desk::answer(const hair::WebRequest& request) {
  const std::lock_guard lock(one_at_a_time_);
  try {
    std::string path = request.path;
    const std::string first = take(path);
    if (request.changes) {
      if (request.path != "save") return {404};
      return save(request.body);
    }
    if (request.path.empty()) return {200, page(), hair::kHtmlType};
    if (first == "class") return page_of_class(path);
    if (first != "item" && first != "news") return {404};
    const std::size_t since = number_in(take(path));
    if (first == "news" && !path.empty()) list_.open(path);
    refresh();
    return shown({path, "", 200, first == "item"}, since);
  } catch (const nlohmann::json::exception&) {
    return {400, "this is not what the desk's page sends\n"};
  } catch (const BadInput& error) {
    return {400, std::string(error.what()) + "\n"};
  } catch (const std::exception& error) {
    return {500, std::string(error.what()) + "\n"};
  }
}

}  // namespace grader::review
