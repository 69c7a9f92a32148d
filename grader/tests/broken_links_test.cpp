// STAFF ONLY. Tests that broken links are found.
#include "grader/tests/broken_links.h"

#include <gtest/gtest.h>

#include <fstream>

#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using Links = std::vector<std::string>;

class BrokenLinks : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& body) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << "<html><body id=\"top\">" << body << "</body></html>";
  }
  static std::string link(const std::string& to) { return "<a href=\"" + to + "\">there</a>"; }

  hair::TemporaryFolder temporary_{"links"};
  fs::path folder_ = temporary_.path();
};

TEST_F(BrokenLinks, AreNoneWhereAllIsThere) {
  write("index.html", link("#top") + link("staff/an%20other.html") + link("staff/an%20other.html#S1") +
                          link("staff") + link("https://example.org/none") +
                          "<img src=\"data:image/png;base64,AAAA\"/><img src=\"staff/picture.png\"/>");
  write("staff/an other.html", "<h2 id=\"S1\"/>" + link("../index.html#top") + link("../index.html"));
  write("staff/picture.png", "");
  EXPECT_EQ(broken_links(folder_), Links());
}

TEST_F(BrokenLinks, AreNamedWithTheirPage) {
  write("a/page.html", link("none.html") + link("#none") + link("../b.html#none") + link("../none.html#top") +
                           link("%zz") + "<img src=\"none.png\"/>");
  write("b.html", "");
  EXPECT_EQ(broken_links(folder_),
            (Links{"a/page.html: none.html", "a/page.html: #none", "a/page.html: ../b.html#none",
                   "a/page.html: ../none.html#top", "a/page.html: %zz", "a/page.html: none.png"}));
}

TEST_F(BrokenLinks, AreThoseThatLeadOutside) {
  write("outside.html", "");
  write("in/page.html", link("../outside.html") + link((folder_ / "outside.html").string()));
  EXPECT_EQ(broken_links(folder_ / "in").size(), 2U);
}

TEST_F(BrokenLinks, AreAFolderWithoutPages) {
  EXPECT_EQ(broken_links(folder_).size(), 1U);
}

}  // namespace
}  // namespace grader
