#include "hair/io/plot/xml.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hair/io/plot/test_parsed.h"
#include "hair/io/plot/test_samples.h"

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
