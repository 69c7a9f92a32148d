// STAFF ONLY. Tests the desk over its server: strangers get nothing, and a decision is in the record when its
// answer comes.
#include "grader/review/desk.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "grader/review/made_class.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/serve/test_client.h"

namespace grader::inline review {
namespace {

using nlohmann::json;

constexpr std::size_t kPeople = 30;

std::filesystem::path class_in(const std::filesystem::path& folder) {
  Record record(folder);
  put_made_class(record, kPeople);
  return folder;
}

// A TA's desk, as a process of its own has it.
struct Ta {
  explicit Ta(const std::filesystem::path& folder, const std::string& who)
      : record(folder), desk(record, who, "The class") {}

  std::string get(const std::string& path) const {
    return client.answer("GET " + client.base + path, client.own());
  }
  std::string save(const json& fields) const { return save_text(fields.dump()); }
  std::string save_text(const std::string& body) const {
    return client.answer("POST " + client.base + "save", client.own(), body);
  }
  // Returns undecided items of one person and exercise each.
  std::vector<Item> some() {
    std::vector<Item> all = desk.list().items();
    std::erase_if(all, [](const Item& one) {
      return one.people.size() != 1 || one.exercise.empty() || one.is_decided() ||
             one.kind == ItemKind::request;
    });
    EXPECT_GT(all.size(), 2U);
    return all;
  }

  Record record;
  Desk desk;
  hair::LocalServer server{0, kMostSavedBytes,
                           [this](const hair::WebRequest& request) { return desk.answer(request); }};
  hair::TestClient client = hair::TestClient::at(server.address().url());
};

int status_of(const std::string& answer) {
  return answer.size() > 12 ? std::atoi(answer.c_str() + 9) : -1;
}

json body_of(const std::string& answer) {
  return json::parse(answer.substr(answer.find("\r\n\r\n") + 4), nullptr, false);
}

json fields_of(const Item& item, const std::string& action, const std::string& number = "",
               const std::string& text = "why") {
  return {{"do", action},           {"key", item.key()}, {"version", item.version},
          {"place", item.exercise}, {"number", number},  {"text", text}};
}

class DeskTest : public testing::Test {
 protected:
  hair::TemporaryFolder temporary_{"desk"};
  const std::filesystem::path folder_ = class_in(temporary_.path());
};

TEST_F(DeskTest, ShowsItsPagesAndNoOtherFile) {
  Ta ada(folder_, "ada");
  hair::write_file(folder_ / "grades.csv", "planted");
  std::filesystem::create_directories(folder_ / "staff/pictures");
  for (const char* path : {"", "class/index.html", "class/staff/p001.html", "class/p002/report.html"})
    EXPECT_EQ(status_of(ada.get(path)), 200) << path;
  for (const char* path :
       {"class/class.sqlite", "class/../class.sqlite", "class/staff/../../class.sqlite", "../class.sqlite",
        "class/%2e%2e/grades.csv", "class/staff/pictures/../../grades.csv", "class/grades.csv",
        "class/staff/pictures/..%2f..%2fgrades.csv", "class/staff/pictures/%00.png",
        "class/staff/nobody.html", "class/staff/p001.html/", "class/p001/study.html", "class//etc/passwd",
        "item", "save", "news/", "item/9999999999999999999999/x", "x"}) {
    const std::string answer = ada.get(path);
    const bool is_list = status_of(answer) == 200 && body_of(answer).contains("rows");
    EXPECT_TRUE(is_list || status_of(answer) / 100 == 4) << path << answer.substr(0, 200);
    EXPECT_EQ(answer.find("SQLite"), std::string::npos) << path;
    EXPECT_EQ(answer.find("planted"), std::string::npos) << path;
  }
}

TEST_F(DeskTest, TakesOnlyWhatItsPageSends) {
  Ta ada(folder_, "ada");
  const Item item = ada.some().front();
  const std::string name = item.people.front();
  const auto with = [&](const std::string& field, const json& value) {
    json fields = fields_of(item, "points", "1");
    fields[field] = value;
    return fields.dump();
  };
  for (const std::string& body : {std::string(),
                                  std::string("{"),
                                  std::string("[]"),
                                  std::string("null"),
                                  std::string(1000, '['),
                                  std::string("\0\xff", 2),
                                  with("do", "drop"),
                                  with("do", 3),
                                  with("number", "1e999"),
                                  with("number", "nan"),
                                  with("number", "-1"),
                                  with("number", "1e6"),
                                  with("number", "1 2"),
                                  with("place", "S9"),
                                  with("place", "../.."),
                                  with("text", ""),
                                  with("text", std::string(5000, 'a')),
                                  with("then", "x"),
                                  with("key", "no/such/item"),
                                  with("version", "old"),
                                  std::string(kMostSavedBytes + 1, ' ')}) {
    const std::string answer = ada.save_text(body);
    EXPECT_EQ(status_of(answer) / 100, 4) << body.substr(0, 80) << "\n" << answer.substr(0, 300);
  }
  EXPECT_TRUE(Record(folder_).decisions(name).empty());
  EXPECT_FALSE(ada.desk.list().find(item.key())->is_decided());
}

TEST_F(DeskTest, HasSavedWhenItAnswers) {
  Ta ada(folder_, "ada");
  const auto kinds = [&](const std::string& name) {
    std::string all;
    for (const Decision& one : Record(folder_).decisions(name))
      all += to_string(one.kind) + " " + one.who + " " + one.why + ";";
    return all;
  };
  for (const auto& [action, wanted] : {std::pair("accept", ""),
                                       {"points", "points ada why;"},
                                       {"comment", "comment ada why;"},
                                       {"excuse", "excuse ada why;"}}) {
    const Item item = ada.some().front();
    const std::string name = item.people.front();
    const std::string before = kinds(name),
                      answer = ada.save(fields_of(item, action, std::string(action) == "points" ? "1" : ""));
    EXPECT_EQ(status_of(answer), 200) << answer;
    EXPECT_EQ(kinds(name), before + wanted);
    const std::optional<Item> now = Ta(folder_, "ben").desk.list().find(item.key());
    EXPECT_TRUE(!now || now->decided_by == "ada") << "another TA sees it";
    EXPECT_EQ(status_of(ada.save({{"do", "undo"}})), 200);
    EXPECT_EQ(kinds(name), before);
  }
}

TEST_F(DeskTest, GivesADayToWhoIsALittleLate) {
  Record record(folder_);
  record.set_rules({.due = "2025-03-04 23:59", .late_per_cent_a_day = 10});
  Ta ada(folder_, "ada");
  const std::vector<Item> items = ada.desk.list().items();
  const auto late = std::ranges::find(items, kLate, &Item::place);
  ASSERT_NE(late, items.end());
  const std::string name = late->people.front();
  record.decide(name, {DecisionKind::late_days, "", 2, 0, "ill"});
  Item now = *ada.desk.list().find(late->key());
  EXPECT_EQ(status_of(ada.save(fields_of(now, "late_days"))), 200);
  EXPECT_EQ(record.decisions(name).back().number, 3) << "one more than before";
}

TEST_F(DeskTest, AnswersARequestOnce) {
  Record(folder_).ask("p001", "S1", "Please look at <b>line 3</b>");
  Ta ada(folder_, "ada");
  const std::vector<Item> items = ada.desk.list().items();
  const auto item = std::ranges::find_if(
      items, [](const Item& one) { return one.kind == ItemKind::request && one.people.front() == "p001"; });
  ASSERT_NE(item, items.end());
  const json fields = fields_of(*item, "answer", "", "It is wrong there.");
  EXPECT_NE(ada.get("item/0/" + item->key()).find("&lt;b&gt;line 3"), std::string::npos);
  EXPECT_EQ(status_of(ada.save(fields)), 200);
  EXPECT_EQ(Record(folder_).requests().back().answer, "It is wrong there.");
  EXPECT_EQ(status_of(ada.save(fields)), 409) << "it is answered";
}

TEST_F(DeskTest, TellsTheSecondOfTwoWhoSaveAtOnce) {
  Ta ada(folder_, "ada"), ben(folder_, "ben");
  const Item item = ada.some().front();
  const std::string name = item.people.front();
  std::string answers[2];
  {
    const auto saves = [&](const Ta& ta, const char* points, std::string& answer) {
      return std::jthread(
          [&ta, &answer, fields = fields_of(item, "points", points)] { answer = ta.save(fields); });
    };
    const std::jthread one = saves(ada, "1", answers[0]), two = saves(ben, "2", answers[1]);
  }
  const int first = status_of(answers[0]) == 200 ? 0 : 1;
  EXPECT_EQ(status_of(answers[first]), 200) << answers[first];
  EXPECT_EQ(status_of(answers[1 - first]), 409) << answers[1 - first];
  const json told = body_of(answers[1 - first]);
  EXPECT_NE(std::string(told["told"]).find(first == 0 ? "ada" : "ben"), std::string::npos) << told["told"];
  const std::vector<Decision> decisions = Record(folder_).decisions(name);
  ASSERT_EQ(decisions.size(), 1U);
  EXPECT_EQ(decisions.front().who, first == 0 ? "ada" : "ben");
  // The second one knows now, and may save over it.
  json fields = fields_of(item, "points", "3", "both of us looked");
  fields["version"] = told["version"];
  EXPECT_EQ(status_of((first == 0 ? ben : ada).save(fields)), 200);
}

TEST_F(DeskTest, GoesOnWithOneThatNobodyElseHasOpen) {
  Ta ada(folder_, "ada"), ben(folder_, "ben");
  const std::vector<Item> some = ada.some();
  const Item &item = some[0], &taken = some[1], &next = some[2];
  EXPECT_EQ(status_of(ben.get("item/0/" + taken.key())), 200);
  json fields = fields_of(item, "accept");
  fields["then"] = {taken.key(), next.key()};
  const std::string shown = body_of(ada.save(fields))["item"];
  EXPECT_NE(shown.find("data-key=\"" + next.key() + "\""), std::string::npos) << shown.substr(0, 200);
  EXPECT_NE(std::string(body_of(ada.get("item/0/" + taken.key()))["item"]).find("ben has this open"),
            std::string::npos);
}

}  // namespace
}  // namespace grader::review
