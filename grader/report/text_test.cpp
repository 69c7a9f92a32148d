// STAFF ONLY.
#include "grader/report/text.h"
#include "hair/io/plot/readable.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "hair/io/plot/html.h"

namespace grader {
namespace {

const std::string fffd = "\xef\xbf\xbd";

TEST(ValidUtf8, ValidTextStays) {
  const std::string text = "a\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\n";
  EXPECT_EQ(hair::valid_utf8(text), text);
}

TEST(ValidUtf8, EveryStrayByteIsReplaced) {
  EXPECT_EQ(hair::valid_utf8("a\xff"
                             "b"),
            "a" + fffd + "b");
  EXPECT_EQ(hair::valid_utf8("\xc3"), fffd);
  EXPECT_EQ(hair::valid_utf8("\xe2\x82"), fffd + fffd);
  EXPECT_EQ(hair::valid_utf8("\xc0\xaf"), fffd + fffd) << "overlong '/'";
  EXPECT_EQ(hair::valid_utf8("\xed\xa0\x80"), fffd + fffd + fffd) << "a surrogate";
  EXPECT_EQ(hair::valid_utf8("\xf4\x90\x80\x80"), fffd + fffd + fffd + fffd) << "beyond U+10FFFF";
}

TEST(Readable, TerminalColoursGoAsAWhole) {
  EXPECT_EQ(hair::readable("\x1b[1;31merror\x1b[0m: x\x1b"), "error: x");
  EXPECT_EQ(hair::readable("\x1b]0;title\x07"), "]0;title" + fffd);
}

TEST(Readable, ControlCharactersAreReplacedAndLinesStay) {
  EXPECT_EQ(hair::readable(std::string("a\0b\x7f\r\nc\td\r", 10)), "a" + fffd + "b" + fffd + "\nc\td" + fffd);
  EXPECT_EQ(hair::readable("\xc2\x85\xef\xbf\xbf"), fffd + fffd);
}

TEST(ShownPoints, HaveTwoDecimalsAtMost) {
  EXPECT_EQ(shown_points(0), "0");
  EXPECT_EQ(shown_points(30), "30");
  EXPECT_EQ(shown_points(100), "100");
  EXPECT_EQ(shown_points(12.5), "12.5");
  EXPECT_EQ(shown_points(29.999999999999996), "30");
  EXPECT_EQ(shown_points(1.0 / 3), "0.33");
  EXPECT_EQ(shown_points(-1e-9), "0");
}

TEST(HtmlPattern, EveryTextIsEscapedAndHtmlIsNot) {
  const std::string text = "<a href=\"x\">'&";
  EXPECT_EQ(html("{}|{}", {text, Html{"<b>"}}).text, "&lt;a href=&quot;x&quot;&gt;&#39;&amp;|<b>");
}

TEST(HtmlPattern, BracesInTextAreNoHoles) {
  EXPECT_EQ(html("{}{}", {"{}", "x"}).text, "{}x");
}

TEST(HtmlPattern, HolesAndPartsMustMatch) {
  EXPECT_THROW(html("{}"), std::invalid_argument);
  EXPECT_THROW(html("", {"x"}), std::invalid_argument);
}

}  // namespace
}  // namespace grader
