// Pages in a browser: headless Chromium, if it is installed.
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/plot/page.h"
#include "hair/io/plot/test_sample_figures.h"

namespace hair::plot {
namespace {

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
