// STAFF ONLY. Writes a record as JSON, for other programs.
#include "grader/record/record.h"
#include "grader/result/json_fields.h"

namespace grader::inline record {
namespace {

// Texts that students shape may hold any bytes.
std::string text(const DatabaseRow& row, int column) {
  return hair::valid_utf8(row.text(column));
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
  const std::lock_guard lock(one_at_a_time_);
  const Transaction one_state(database_, Transaction::reads);
  const std::int64_t assignment = this->assignment();
  OrderedJson people = OrderedJson::object();
  const bool blind = read_is_blind();
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
      "person "
      "WHERE assignment = ? ORDER BY hand_ins.id",
      {assignment}, [&](const DatabaseRow& row) {
        people[text(row, 0)]["hand_ins"].push_back({{"origin", text(row, 1)},
                                                    {"fingerprint", text(row, 2)},
                                                    {"handed_in", text(row, 3)},
                                                    {"marked_late", row.number(4) != 0}});
      });
  database_.each(
      "SELECT name, result, costs FROM results JOIN people ON people.id = person WHERE assignment = ?",
      {assignment}, [&](const DatabaseRow& row) {
        people[text(row, 0)]["result"] = json_or_null(row.text(1));
        people[text(row, 0)]["costs"] = json_or_null(row.text(2));
      });
  for (auto& [name, one] : people.items()) {
    for (const Decision& decision : decisions_of(name)) {
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
    for (const Request& request : read_requests(name))
      one["requests"].push_back({{"place", request.place},
                                 {"code", request.code},
                                 {"text", request.text},
                                 {"who", request.who},
                                 {"at", request.at},
                                 {"answer", request.answer},
                                 {"answered_by", request.answered_by},
                                 {"answered", request.answered}});
  }
  database_.each(
      "SELECT name, at, who, did, detail FROM log JOIN people ON people.id = person ORDER BY log.id", {},
      [&](const DatabaseRow& row) {
        people[text(row, 0)]["log"].push_back(
            {{"at", text(row, 1)}, {"who", text(row, 2)}, {"did", text(row, 3)}, {"detail", text(row, 4)}});
      });
  if (blind) {
    const std::vector<HandIn> all = read_owned();
    const HiddenNames names(all, read_class_list(all));
    for (auto& [name, one] : people.items()) hide(names, one, name);
  }
  OrderedJson files = OrderedJson::array();
  database_.each(
      "SELECT listed_as, path, reason, coalesce(name, '') FROM listed_files LEFT JOIN people ON people.id = "
      "person "
      "WHERE assignment = ? ORDER BY place",
      {assignment}, [&](const DatabaseRow& row) {
        files.push_back({{"as", text(row, 0)},
                         {"path", text(row, 1)},
                         {"reason", text(row, 2)},
                         {"whose", text(row, 3)}});
      });
  OrderedJson desk = OrderedJson::array();
  database_.each(
      "SELECT what, coalesce(name, ''), who, at, owner FROM desk_items LEFT JOIN people ON people.id = "
      "person "
      "WHERE assignment = ? ORDER BY desk_items.id",
      {assignment}, [&](const DatabaseRow& row) {
        desk.push_back({{"item", text(row, 0)},
                        {"whose", text(row, 1)},
                        {"accepted_by", text(row, 2)},
                        {"at", text(row, 3)},
                        {"owner", text(row, 4)}});
      });
  OrderedJson comments = OrderedJson::array();
  for (const Comment& one : read_comments())
    comments.push_back({{"id", one.id}, {"text", one.text}, {"points", one.points}});
  OrderedJson all = {{"version", database_.number("PRAGMA user_version")}};
  if (!hand_in_.empty()) all["hand_in"] = hand_in_;
  all["made_by"] = json_or_null(database_.text("SELECT made_by FROM assignments WHERE id = ?", {assignment}));
  all["people"] = people;
  all["comments"] = comments;
  all["listed_files"] = files;
  all["desk"] = desk;
  return all.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace grader::record
