#include "hair/io/plot/html.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "hair/io/files/base64.h"
#include "hair/io/plot/readable.h"
#include "hair/io/plot/test_parsed.h"
#include "hair/io/plot/test_samples.h"
#include "hair/io/plot/xml.h"

namespace hair {
namespace {

const std::string fffd = "\xef\xbf\xbd";

TEST(ValidUtf8, ValidTextStays) {
  const std::string text = "a\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\n";
  EXPECT_EQ(valid_utf8(text), text);
}

TEST(ValidUtf8, EveryStrayByteIsReplaced) {
  EXPECT_EQ(valid_utf8("a\xff"
                       "b"),
            "a" + fffd + "b");
  EXPECT_EQ(valid_utf8("\xc3"), fffd);
  EXPECT_EQ(valid_utf8("\xe2\x82"), fffd + fffd);
  EXPECT_EQ(valid_utf8("\xc0\xaf"), fffd + fffd) << "overlong '/'";
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), fffd + fffd + fffd) << "a surrogate";
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), fffd + fffd + fffd + fffd) << "beyond U+10FFFF";
}

TEST(Readable, TerminalColoursGoAsAWhole) {
  EXPECT_EQ(readable("\x1b[1;31merror\x1b[0m: x\x1b"), "error: x");
  EXPECT_EQ(readable("\x1b]0;title\x07"), "]0;title" + fffd);
}

TEST(Readable, ControlCharactersAreReplacedAndLinesStay) {
  EXPECT_EQ(readable(std::string("a\0b\x7f\r\nc\td\r", 10)), "a" + fffd + "b" + fffd + "\nc\td" + fffd);
  EXPECT_EQ(readable("\xc2\x85\xef\xbf\xbf"), fffd + fffd);
}

TEST(Escaped, MarksThatTurnTheDirectionOfTextAreNamed) {
  const char* marks[] = {"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c",
                         "\u202d", "\u202e", "\u2066", "\u2067", "\u2068", "\u2069"};
  for (const std::string mark : marks) EXPECT_EQ(escaped(mark).find("&lt;U+"), 0U) << mark;
  EXPECT_EQ(html("{}", {"if (a\u202e b)"}).text, "if (a&lt;U+202E&gt; b)");
  for (const std::string other :
       {"\u061b", "\u200d", "\u2010", "\u2029", "\u202f", "\u2065", "\u206a", "\u05d0"})
    EXPECT_EQ(escaped(other), other);
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

// FIPS 180-4's examples, and lengths around that of a block, as coreutils' sha256sum has them.
TEST(Sha256, IsTheStandards) {
  for (const auto& [text, sum] :
       {std::pair{std::string("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0="},
        {"", "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="},
        {std::string(55, 'a'), "n0OQ+NMMLdkuyfCVtl4rmumwqSWlJY4kHJ8ekQ9zQxg="},
        {std::string(56, 'a'), "s1Q5pKxvCUi21vnjxq8PX1kM4g8b3nCQ73lwaG7Gc4o="},
        {std::string(64, 'a'), "/+BU/nrgy23GXDr5th1SCfQ5hR20PQulmXM33xVGaOs="},
        {std::string(1000, 'a'), "Qe3s5C1j6Nm/UVqbppMuHCDLyfWl0TRkWttdsblzfqM="}})
    EXPECT_EQ(base64(sha256_bytes(text)), sum) << text.size();
}

}  // namespace
}  // namespace hair

namespace hair::plot {
namespace {

TEST(Xml, AParserWithoutMercyAcceptsAnyTextInElementsAndAttributes) {
  for (const std::string& text : hostile_texts()) {
    XmlWriter xml;
    xml.open("a", {{"b", text}}).text(text).leaf("c", {{"d", text}}, text).close();
    const std::string written = xml.take();
    Element root;
    ASSERT_NO_THROW(root = parse(written)) << written;
    ASSERT_EQ(root.elements.size(), 1) << "text became an element: " << written;
    EXPECT_EQ(root.attributes.size(), 1) << "text became an attribute: " << written;
  }
}

TEST(Xml, EveryByteAndEveryPairOfBytesIsReadBack) {
  for (int first = 0; first < 256; ++first) {
    std::string all;
    for (int second = 0; second < 256; ++second)
      all += {static_cast<char>(first), static_cast<char>(second), 'x'};
    ASSERT_NO_THROW(parse("<a>" + escaped(all) + "</a>")) << "first byte " << first;
  }
}

TEST(Xml, WhatIsOpenMustBeClosed) {
  XmlWriter xml;
  EXPECT_THROW(xml.close(), std::logic_error);
  xml.open("a");
  EXPECT_THROW(xml.take(), std::logic_error);
}

TEST(Xml, PixelsHaveTwoDecimalsAtMostAndNoMinusZero) {
  EXPECT_EQ(pixels(1.0), "1");
  EXPECT_EQ(pixels(1.005), "1");
  EXPECT_EQ(pixels(123.456), "123.46");
  EXPECT_EQ(pixels(-0.001), "0");
  EXPECT_EQ(pixels(-12.5), "-12.5");
}

}  // namespace
}  // namespace hair::plot
