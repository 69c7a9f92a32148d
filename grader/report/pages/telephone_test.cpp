// STAFF ONLY. Tests pages on a telephone and on a small screen: headless Chromium, if there is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "grader/report/facts/sample_results.h"
#include "grader/report/pages/pages.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/plot/readable.h"

namespace grader::inline report {
namespace {

constexpr int kTelephone = 390, kScreen = 1280;  // CSS pixels

// Our page runs no script, so the page around it measures. It lists elements that end right of the screen.
std::string measuring_page(const std::string& page, int width) {
  return "<!DOCTYPE html><html><body><iframe style=\"border:0;width:" + std::to_string(width) +
         "px;height:900px\" srcdoc=\"" + hair::escaped(page) +
         "\"></iframe><script>onload = () => {\n"
         "let seen = 0, outside = '';\n"
         "for (const one of document.querySelector('iframe').contentDocument.querySelectorAll("
         "'h1,h2,p,th,td,summary,pre,img')) {\n"
         "  seen += one.getClientRects().length > 0;\n"
         "  if (one.getBoundingClientRect().right > " +
         std::to_string(width) +
         ") outside += one.tagName + ' ' + one.textContent.slice(0, 40) + '; ';\n"
         "}\n"
         "document.body.textContent = (seen > 50 ? 'seen, ' : 'not seen, ') + 'outside: ' + outside + '|';\n"
         "};</script></body></html>";
}

std::string dump(const std::string& html) {
  const hair::TemporaryFolder temporary{"hair-telephone"};
  const std::string path = temporary.path().string();
  std::ofstream(path + "/page.html", std::ios::binary) << html;
  const std::string command =
      "HOME=" + path +
      " timeout -k 2 600 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage"
      " --no-first-run --disable-background-networking --user-data-dir=" +
      path + "/profile --dump-dom file://" + path + "/page.html >" + path +
      "/document 2>/dev/null </dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return hair::bytes_of(path + "/document");
}

TEST(Telephone, ShowsAllOfAPageWithoutScrollingSideways) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no chromium on PATH: pages are not opened in a browser";
  std::vector<SubmissionResult> results = class_of_ten_exercises(12);
  const SubmissionResult result = results[1];
  const NamesForPeople long_name{
      {result.name, "Wolfeschlegelsteinhausenbergerdorff, " + std::string(60, 'a')}};
  // All fourteen exercises, decisions and a long name stand side by side.
  for (SubmissionResult& one : results) {
    one.decided = {{"S1.2", "points", "points S1.2: 2", "ada set S1.2 to 2"}, {"", "late-days", "", ""}};
    for (const char* id : {"H7", "H8", "H9", "H10"}) one.exercises.emplace_back(one.exercises[1]).id = id;
  }
  const std::pair<std::string, int> pages[] = {{student_page(result), kTelephone},
                                               {staff_page(result), kTelephone},
                                               {student_page(result, long_name), kTelephone},
                                               {staff_page(result, long_name), kTelephone},
                                               {class_page(results, {}, long_name), kScreen}};
  for (const auto& [page, width] : pages) {
    const std::string seen = dump(measuring_page(page, width));
    EXPECT_NE(seen.find("<body>seen, outside: |"), std::string::npos)
        << seen.substr(std::min(seen.find("<body>"), seen.size()), 2000);
  }
}

}  // namespace
}  // namespace grader::report
