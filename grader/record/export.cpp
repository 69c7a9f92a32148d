// STAFF ONLY. Writes a record as JSON, for other programs.
#include "grader/record/record.h"
#include "grader/result/json_fields.h"

namespace grader::inline record {
namespace {

// Texts that students shape may hold any bytes.
std::string text(const DatabaseRow& row, int column) {
  return hair::valid_utf8(row.text(column));
}

// Gives the columns from `first` on these keys.
OrderedJson texts(const DatabaseRow& row, int first, std::initializer_list<const char*> keys) {
  OrderedJson all = OrderedJson::object();
  for (const char* key : keys) all[key] = text(row, first++);
  return all;
}

OrderedJson json_or_null(const std::string& stored) {
  return stored.empty() ? OrderedJson() : OrderedJson::parse(stored);
}

// Changes all texts of a hand-in that may say whose it is.
void hide(const HiddenNames& names, OrderedJson& json, const std::string& hand_in) {
  if (json.is_string()) json = names.in_own(json.get<std::string>(), hand_in);
  if (json.is_structured())
    for (OrderedJson& part : json) hide(names, part, hand_in);
}

}  // namespace

std::string Record::export_json() {
  const Transaction one_state(database_, Transaction::reads);
  const std::int64_t assignment = this->assignment();
  OrderedJson people = OrderedJson::object();
  const bool blind = is_blind();
  database_.each(
      "SELECT name, drawn_from, system, owner FROM people LEFT JOIN owners ON owners.person = people.id AND "
      "owners.assignment = ? ORDER BY name",
      {assignment}, [&](const DatabaseRow& row) {
        people[text(row, 0)] = {{"drawn_from", blind ? OrderedJson() : OrderedJson(text(row, 1))},
                                {"system", text(row, 2)},
                                {"owner", blind ? OrderedJson() : json_or_null(row.text(3))},
                                {"hand_ins", OrderedJson::array()},
                                {"result", OrderedJson()},
                                {"costs", OrderedJson()},
                                {"decisions", OrderedJson::array()},
                                {"requests", OrderedJson::array()},
                                {"log", OrderedJson::array()}};
      });
  database_.each(
      "SELECT name, origin, fingerprint, handed_in, marked_late FROM hand_ins JOIN people ON people.id = "
      "person WHERE assignment = ? ORDER BY hand_ins.id",
      {assignment}, [&](const DatabaseRow& row) {
        OrderedJson& all = people[text(row, 0)]["hand_ins"];
        all.push_back(texts(row, 1, {"origin", "fingerprint", "handed_in"}));
        all.back()["marked_late"] = row.number(4) != 0;
      });
  database_.each(
      "SELECT name, result, costs FROM results JOIN people ON people.id = person WHERE assignment = ?",
      {assignment}, [&](const DatabaseRow& row) {
        people[text(row, 0)]["result"] = json_or_null(row.text(1));
        people[text(row, 0)]["costs"] = json_or_null(row.text(2));
      });
  for (auto& [name, one] : people.items())
    for (const Decision& decision : decisions(name)) {
      OrderedJson json = {{"kind", to_string(decision.kind)},
                          {"place", decision.place},
                          {"number", decision.number},
                          {"computed", decision.computed},
                          {"why", decision.why},
                          {"who", decision.who},
                          {"at", decision.at},
                          {"title", decision.title}};
      if (decision.comment != 0) json["comment"] = decision.comment;
      if (!decision.code.empty()) json["code"] = decision.code;
      one["decisions"].push_back(std::move(json));
    }
  database_.each(
      "SELECT name, place, code, text, who, at, answer, answered_by, answered FROM requests JOIN people ON "
      "people.id = person WHERE assignment = ? ORDER BY requests.id",
      {assignment}, [&](const DatabaseRow& row) {
        people[text(row, 0)]["requests"].push_back(
            texts(row, 1, {"place", "code", "text", "who", "at", "answer", "answered_by", "answered"}));
      });
  database_.each(
      "SELECT name, at, who, did, detail FROM log JOIN people ON people.id = person ORDER BY log.id", {},
      [&](const DatabaseRow& row) {
        people[text(row, 0)]["log"].push_back(texts(row, 1, {"at", "who", "did", "detail"}));
      });
  if (blind) {
    const std::vector<HandIn> all = read_owned();
    const HiddenNames names(all, read_class_list(all));
    for (auto& [name, one] : people.items()) hide(names, one, name);
  }
  const auto list_of = [&](std::string_view sql, std::initializer_list<const char*> keys) {
    OrderedJson list = OrderedJson::array();
    database_.each(sql, {assignment}, [&](const DatabaseRow& row) { list.push_back(texts(row, 0, keys)); });
    return list;
  };
  OrderedJson all = {{"version", database_.number("PRAGMA user_version")}};
  if (!hand_in_.empty()) all["hand_in"] = hand_in_;
  all["made_by"] = json_or_null(database_.text("SELECT made_by FROM assignments WHERE id = ?", {assignment}));
  all["people"] = people;
  all["comments"] = OrderedJson::array();
  for (const Comment& one : comments())
    all["comments"].push_back({{"id", one.id}, {"text", one.text}, {"points", one.points}});
  all["listed_files"] = list_of(
      "SELECT listed_as, path, reason, coalesce(name, '') FROM listed_files LEFT JOIN people ON people.id = "
      "person WHERE assignment = ? ORDER BY place",
      {"as", "path", "reason", "whose"});
  all["desk"] = list_of(
      "SELECT what, coalesce(name, ''), who, at, owner FROM desk_items LEFT JOIN people ON people.id = "
      "person WHERE assignment = ? ORDER BY desk_items.id",
      {"item", "whose", "accepted_by", "at", "owner"});
  return all.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace grader::record
