// STAFF ONLY. Tests a student's page on a telephone: headless Chromium, if there is one.
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

constexpr int kWidth = 390;  // CSS pixels

// Our page runs no script, so the page around it measures. It lists elements that end right of the screen.
std::string measuring_page(const std::string& page) {
  return "<!DOCTYPE html><html><body><iframe style=\"border:0;width:" + std::to_string(kWidth) +
         "px;height:900px\" srcdoc=\"" + hair::escaped(page) +
         "\"></iframe><script>onload = () => {\n"
         "let seen = 0, outside = '';\n"
         "for (const one of document.querySelector('iframe').contentDocument.querySelectorAll("
         "'h1,h2,p,th,td,summary,pre,img')) {\n"
         "  seen += one.getClientRects().length > 0;\n"
         "  if (one.getBoundingClientRect().right > " +
         std::to_string(kWidth) +
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
  const SubmissionResult result = class_of_ten_exercises(2)[1];
  const NamesForPeople long_name{
      {result.name, "Wolfeschlegelsteinhausenbergerdorff, " + std::string(60, 'a')}};
  for (const std::string& page : {student_page(result), staff_page(result), student_page(result, long_name),
                                  staff_page(result, long_name)}) {
    const std::string seen = dump(measuring_page(page));
    EXPECT_NE(seen.find("<body>seen, outside: |"), std::string::npos)
        << seen.substr(std::min(seen.find("<body>"), seen.size()), 2000);
  }
}

}  // namespace
}  // namespace grader::report
