#include "hair/io/plot/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/plot/columns.h"
#include "hair/io/plot/test_parsed.h"
#include "hair/io/plot/test_samples.h"

namespace hair::plot {
namespace {

Page sample_page() {
  const Table table = {"Errors", {"method", "error, m"}, {{"RK4", "1.2e-5"}, {"H4", "0.01"}}};
  return {"A study",
          {"On this machine."},
          {{"Errors", {"Read it so."}, {to_svg(sample_figure())}, {table}},
           {"Maps", {}, {to_svg(sample_map())}, {}},
           {"Orders", {}, {}, {table}}}};
}

// An independent reader of RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      records.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      records.back().emplace_back();
    else if (!quoted && c == '\n')
      records.push_back({""});
    else
      records.back().back() += c;
  }
  records.pop_back();  // the last line ends, too
  return records;
}

TEST(PageTest, ItHasALanguageATitleAndHeadingsInOrder) {
  const Element html = parse(to_html(sample_page()));
  EXPECT_EQ(html["lang"], "en");
  EXPECT_EQ(html.named("head").at(0).named("title").at(0).text, "A study");
  std::string headings;
  for (const Element& heading : html.all([](const Element& element) {
         return element.name.size() == 2 && element.name[0] == 'h' && std::isdigit(element.name[1]);
       }))
    headings += heading.name + " " + heading.text + "\n";
  EXPECT_EQ(headings, "h1 A study\nh2 Errors\nh2 Maps\nh2 Orders\n");
  const auto metas = html.named("meta");
  EXPECT_EQ(metas.at(0)["charset"], "utf-8");
  EXPECT_TRUE(
      std::any_of(metas.begin(), metas.end(), [](const Element& m) { return m.has("name", "viewport"); }));
}

TEST(PageTest, IdsAreUniqueAndLinksLeadSomewhere) {
  const Element html = parse(to_html(sample_page()));
  std::set<std::string> ids;
  for (const Element& element : html.all([](const Element& e) { return e.attributes.count("id") > 0; }))
    EXPECT_TRUE(ids.insert(element["id"]).second) << element["id"] << " comes twice";
  const auto links = html.named("a");
  EXPECT_EQ(links.size(), 3);
  for (const Element& link : links) EXPECT_TRUE(ids.count(link["href"].substr(1))) << link["href"];

  Page page = sample_page();
  page.sections[2].figures = page.sections[0].figures;
  EXPECT_THROW(to_html(page), std::invalid_argument) << "the same figure twice";
}

TEST(PageTest, TablesSayWhichCellsAreHeadingsAndFoldBeneathFigures) {
  const Element html = parse(to_html(sample_page()));
  const auto tables = html.named("table");
  ASSERT_EQ(tables.size(), 2);
  EXPECT_EQ(tables[0].named("caption").at(0).text, "Errors");
  for (const Element& heading : tables[0].named("thead").at(0).named("th"))
    EXPECT_EQ(heading["scope"], "col");
  for (const Element& row : tables[0].named("tbody").at(0).named("tr"))
    EXPECT_EQ(row.elements.at(0)["scope"], "row");
  EXPECT_EQ(html.named("details").size(), 1) << "the one beneath a figure";
  EXPECT_EQ(html.named("details").at(0).named("table").size(), 1);
  EXPECT_EQ(tables[0].named("td").at(0)["class"], "number");
  EXPECT_EQ(tables[0].named("tbody").at(0).named("th").at(0)["class"], "text");
}

TEST(PageTest, HostileTextsStayTexts) {
  for (const std::string& text : hostile_texts()) {
    const Page page = {text, {text}, {{text, {text}, {}, {{text, {text, text}, {{text, text}}}}}}};
    Element html;
    ASSERT_NO_THROW(html = parse(to_html(page))) << text;
    EXPECT_TRUE(html.named("script").empty());
    EXPECT_EQ(html.named("td").size(), 1);
  }
}

TEST(PageTest, TablesWhoseRowsDoNotFitAreRefused) {
  for (const Table& table : {Table{"t", {}, {}}, Table{"t", {"a", "b"}, {{"1", "2"}, {"3"}}}}) {
    EXPECT_THROW(to_csv(table), std::invalid_argument);
    EXPECT_THROW(to_html({"p", {}, {{"s", {}, {}, {table}}}}), std::invalid_argument);
  }
}

TEST(CsvTest, AReaderGetsBackWhatWasWritten) {
  Table table = {"t", {"plain", "with, comma", "with \"quotes\""}, {}};
  for (const std::string& text : hostile_texts()) table.rows.push_back({text, "x", text});
  table.rows.push_back({"line\nfeed", "\r\n", ",,\"\","});
  auto expected = table.rows;
  expected.insert(expected.begin(), table.header);
  EXPECT_EQ(read_csv(to_csv(table)), expected);

  const Table narrow = {"t", {"one"}, {{""}, {"a"}, {""}}};
  EXPECT_EQ(to_csv(narrow), "one\n\"\"\na\n\"\"\n") << "an empty line would be no record";
}

TEST(ToText, HasEnoughDigitsAndNoMore) {
  const std::vector<std::pair<double, const char*>> cases = {
      {0, "0"},
      {1, "1"},
      {-1, "-1"},
      {0.1, "0.1"},
      {0.012345, "0.0123"},
      {1.23456, "1.23"},
      {12.3456, "12.3"},
      {999.4, "999"},
      {999.6, "1000"},
      {1234.5, "1234"},
      {99999.4, "99999"},
      {123456, "123456"},
      {1e6, "1e6"},
      {1.5e7, "1.5e7"},
      {1e-3, "0.001"},
      {1.23e-5, "1.23e-5"},
      {-4.567e-12, "-4.57e-12"},
      {1e300, "1e300"},
      {std::nan(""), "nan"},
      {std::numeric_limits<double>::infinity(), "inf"},
      {-std::numeric_limits<double>::infinity(), "-inf"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(to_text(value), text);
}

TEST(ToText, IsWithinHalfAPercentOfTheValue) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::pow(10, exponent(random));
    EXPECT_NEAR(std::stod(to_text(value)) / value, 1, 0.005 + 1e-12) << value;
    EXPECT_EQ(std::stod(to_exact_text(value)), value);
  }
}

// --- JSON, CSV and tables of pages follow from declared columns.

std::string inverse(double value) {
  return "1/" + to_text(1 / value);
}

Row row_of(int elements, double step, std::optional<double> error, const std::string& trouble,
           std::vector<double> lengths) {
  return {{"elements", "", elements},
          {"step", "s", step, {"h", 1, inverse}},
          {"error.at_end", "m", error, {.heading = "error, mm", .scale = 1e3}},
          {"error.name", "", "rms", In::json},
          {"trouble", "", if_any(trouble)},
          {"stopped", "", !trouble.empty(), In::files},
          {"lengths", "", lengths, In::json},
          {"size_of.it", "kg", 0.5, In::page},
          {"remark", "", "all, of it", In::csv}};
}

const std::vector<Row> kRows = {row_of(5, 0.25, 1.0 / 3, "", {}), row_of(10, 0.125, {}, "broke", {1, NAN})};

TEST(Columns, AreKeysInJsonAndDotsObjects) {
  EXPECT_EQ(
      json_of(kRows).dump(),
      R"([{"elements":5,"step":0.25,"error":{"at_end":0.3333333333333333,"name":"rms"},"trouble":null,)"
      R"("stopped":false,"lengths":[]},{"elements":10,"step":0.125,"error":{"at_end":null,"name":"rms"},)"
      R"("trouble":"broke","stopped":true,"lengths":[1.0,null]}])");
}

TEST(Columns, OfCsvHaveNameAndUnitAndAllDigits) {
  EXPECT_EQ(
      csv_of(kRows),
      "elements,step_s,error_at_end_m,trouble,stopped,remark\n5,0.25,0.3333333333333333,,no,\"all, of it\"\n"
      "10,0.125,,broke,yes,\"all, of it\"\n");
  EXPECT_EQ(csv_of({}), "");
}

TEST(Columns, OfPagesHaveHeadingsScalesAndWaysToWriteNumbers) {
  const Table table = table_of(kRows, "Runs");
  EXPECT_EQ(table.caption, "Runs");
  EXPECT_EQ(table.header,
            (std::vector<std::string>{"elements", "h", "error, mm", "trouble", "size of it, kg"}));
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"5", "1/4", "333", "", "0.5"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"10", "1/8", "", "broke", "0.5"}));
}

TEST(Columns, OfHostileTextsAreARecordAllTheSame) {
  EXPECT_EQ(record_text({{"a", "\xff"}}), "{\n  \"a\": \"\xef\xbf\xbd\"\n}\n");
}

// --- In a browser: headless Chromium, if it is installed ---

std::string browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (std::system(("command -v " + std::string(name) + " >/dev/null 2>&1").c_str()) == 0) return name;
  return "";
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

struct Opened {
  int status = 0;
  std::string document;  // as the browser parsed it
  std::string console;   // its complaints
};

class ChromiumTest : public testing::Test {
 protected:
  void SetUp() override {
    browser_ = browser();
    if (browser_.empty()) GTEST_SKIP() << "no chromium on PATH: pages are not opened in a browser";
  }

  Opened open(const std::string& html) const {
    const std::string path = folder_.string();
    std::ofstream(folder_ / "page.html", std::ios::binary) << html;
    const std::string command =
        "HOME=" + path + " timeout -k 2 600 " + browser_ +
        " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --no-first-run"
        " --disable-background-networking --enable-logging=stderr --user-data-dir=" +
        path + "/profile --dump-dom file://" + path + "/page.html >" + path + "/document 2>" + path +
        "/log </dev/null";
    Opened opened;
    opened.status = std::system(command.c_str());
    opened.document = bytes_of(folder_ / "document");
    std::istringstream log(bytes_of(folder_ / "log"));
    for (std::string line; std::getline(log, line);)
      if (line.find("CONSOLE") != std::string::npos) opened.console += line + "\n";
    return opened;
  }

 private:
  TemporaryFolder temporary_{"hair-plot"};
  std::filesystem::path folder_ = temporary_.path();
  std::string browser_;
};

TEST_F(ChromiumTest, APageOpensWithoutComplaintsAndIsUnderstoodAsItWasWritten) {
  const Page page = {"A study",
                     {"Text."},
                     {{"Figure",
                       {},
                       {to_svg(sample_figure()), to_svg(sample_map())},
                       {{"Numbers", {"a", "b"}, {{"1", "</td><script>alert(1)</script>"}}}}}}};
  const std::string html = to_html(page);
  const Opened opened = open(html);
  EXPECT_EQ(opened.status, 0);
  EXPECT_EQ(opened.console, "");
  // A browser repairs invalid HTML: it would close, move or add elements.
  for (const char* tag : {"<path", "<rect", "<text", "<title", "<g", "<figure", "<table", "<tr", "<td",
                          "<script", "</p>", "</div>"})
    EXPECT_EQ(count(opened.document, tag), count(html, tag)) << tag;
}

TEST_F(ChromiumTest, AFigureThatWouldRunAScriptIsStoppedByThePage) {
  const Opened opened =
      open(to_html({"p", {}, {{"s", {}, {"<svg><script>document.title = 'ran';</script></svg>"}}}}));
  EXPECT_EQ(opened.status, 0);
  EXPECT_NE(opened.console, "") << "the browser is expected to complain: else the test above can't fail";
  EXPECT_EQ(opened.document.find("<title>ran"), std::string::npos);
}

}  // namespace
}  // namespace hair::plot
