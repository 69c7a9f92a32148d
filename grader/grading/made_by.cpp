// STAFF ONLY. Writes, reads and compares the settings of a folder of grades.
#include "grader/grading/made_by.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "grader/compile/hash.h"
#include "grader/grading/secret.h"
#include "grader/report/facts/text.h"

namespace grader::inline grading {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::optional<Role> role_from(const std::string& name) {
  for (const Role role : {Role::assigned, Role::optional, Role::given, Role::absent})
    if (to_string(role) == name) return role;
  return {};
}

std::string in_words(Role role) {
  return role == Role::absent ? "left out" : to_string(role);
}

// An exercise that a version of the project does not know counts as left out.
MadeBy::Rule rule_for(const MadeBy& made_by, const std::string& id) {
  for (const MadeBy::Rule& rule : made_by.exercises)
    if (rule.id == id) return rule;
  return {id, Role::absent, 0};
}

std::vector<std::string> ids_of(const MadeBy& there, const MadeBy& here) {
  std::vector<std::string> ids;
  for (const MadeBy* one : {&there, &here})
    for (const MadeBy::Rule& rule : one->exercises)
      if (std::find(ids.begin(), ids.end(), rule.id) == ids.end()) ids.push_back(rule.id);
  return ids;
}

std::string there_and_here(const std::string& subject, const std::string& there, const std::string& here) {
  return subject + " is " + there + " there and " + here + " here";
}

std::string course_difference(const MadeBy& there, const MadeBy& here) {
  std::string all;
  const auto add = [&](const std::string& one) { all += (all.empty() ? "" : ", ") + one; };
  for (const std::string& id : ids_of(there, here)) {
    const MadeBy::Rule a = rule_for(there, id), b = rule_for(here, id);
    if (a.role != b.role)
      add(there_and_here(id, in_words(a.role), in_words(b.role)));
    else if (a.points != b.points)
      add(there_and_here(id, "worth " + shown_points(a.points) + " points", shown_points(b.points)));
  }
  std::set<std::string> limits;
  for (const MadeBy* one : {&there, &here})
    for (const auto& [name, value] : one->budget) limits.insert(name);
  const auto limit = [](const MadeBy& one, const std::string& name) {
    const auto found = one.budget.find(name);
    return found == one.budget.end() ? "not set" : found->second;
  };
  if (there.partial != here.partial)
    add(there_and_here("\"partial\"", there.partial ? "true" : "false", here.partial ? "true" : "false"));
  for (const std::string& name : limits)
    if (limit(there, name) != limit(here, name))
      add(there_and_here("the budget's " + name, limit(there, name), limit(here, name)));
  return all;
}

std::string way_from(Isolation here, Isolation there) {
  if (there == Isolation::none) return "add --unsafe-no-sandbox";
  if (here == Isolation::none) return "leave out --unsafe-no-sandbox";
  return std::string("grade with --isolation ") + to_string(there);
}

}  // namespace

MadeBy made_by(const GradingSettings& settings) {
  MadeBy made;
  for (const Exercise& exercise : settings.course.exercises) {
    const bool elsewhere =
        is_asked_for(exercise.role) && !settings.course.asks_for(exercise);  // belongs to another hand-in
    const Role role = elsewhere ? Role::absent : exercise.role;
    made.exercises.push_back({exercise.id, role, is_asked_for(role) ? exercise.points : 0});
  }
  for (const BudgetField& field : budget_fields())
    made.budget[field.key] = shown_points(settings.course.budget.*field.value);
  made.suite = sha256(sha256_of(settings.kit) + sha256_of(settings.suite) + sha256_of(settings.scenes));
  made.secret = fingerprint(settings.secret);
  made.isolation = settings.isolation;
  made.images = settings.images;
  made.partial = settings.course.partial;
  return made;
}

std::string to_json(const MadeBy& made_by) {
  OrderedJson exercises = OrderedJson::object();
  for (const MadeBy::Rule& rule : made_by.exercises) {
    exercises[rule.id]["role"] = to_string(rule.role);
    if (is_asked_for(rule.role)) exercises[rule.id]["points"] = rule.points;
  }
  const OrderedJson all = {
      {"exercises", exercises},    {"budget", OrderedJson(made_by.budget)},     {"suite", made_by.suite},
      {"secret", made_by.secret},  {"isolation", to_string(made_by.isolation)}, {"images", made_by.images},
      {"partial", made_by.partial}};
  return all.dump(1) + "\n";
}

std::optional<MadeBy> made_by_from_json(const std::string& text) {
  try {
    const OrderedJson all = OrderedJson::parse(text);
    MadeBy made;
    for (const auto& [id, rule] : all.at("exercises").items()) {
      const std::optional<Role> role = role_from(rule.at("role"));
      if (!role) return {};
      made.exercises.push_back({id, *role, is_asked_for(*role) ? rule.at("points").get<double>() : 0});
    }
    made.budget = all.at("budget").get<std::map<std::string, std::string>>();
    made.suite = all.at("suite");
    made.secret = all.at("secret");
    const std::optional<Isolation> isolation = isolation_from(all.at("isolation").get<std::string>());
    if (!isolation) return {};
    made.isolation = *isolation;
    made.images = all.at("images");
    made.partial = all.at("partial");
    return made;
  } catch (const OrderedJson::exception&) {
    return {};
  }
}

std::vector<Difference> differences(const MadeBy& there, const MadeBy& here) {
  std::vector<Difference> all;
  if (const std::string course = course_difference(there, here); !course.empty())
    all.push_back({"another course file: " + course, "use the course file that made it"});
  if (there.suite != here.suite)
    all.push_back({"another suite: other hidden cases or another build of the grader",
                   "use the hairgrade that made it"});
  if (there.secret != here.secret)
    all.push_back(
        {"another secret: its fingerprint is " + there.secret + " there and " + here.secret + " here",
         "use the secret that made it, with --secret or by hairgrade secret import"});
  if (there.isolation != here.isolation)
    all.push_back({std::string("another sandbox: ") + to_string(there.isolation) + " there and " +
                       to_string(here.isolation) + " here",
                   way_from(here.isolation, there.isolation)});
  if (there.images != here.images)
    all.push_back(there.images ? Difference{"pictures, and here are none", "leave out --no-images"}
                               : Difference{"no pictures, and here are some", "add --no-images"});
  return all;
}

}  // namespace grader::grading
