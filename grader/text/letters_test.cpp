// STAFF ONLY. Tests that one name stays one, however its letters are written.
#include "grader/text/letters.h"

#include <gtest/gtest.h>

#include <ctime>

namespace grader::inline text {
namespace {

TEST(Letters, AreComposed) {
  EXPECT_EQ(composed("Jo\xcc\x88rg  Mu\xcc\x88ller\t"), "Jörg Müller");
  EXPECT_EQ(composed(" \xc2\xa0Nguyễn Văn \r\n An"), "Nguyễn Văn An");
  EXPECT_EQ(composed("李伟"), "李伟");
  EXPECT_EQ(composed("a\xff\x1b[31mb"),
            "a\xef\xbf\xbd"
            "b");
  EXPECT_EQ(composed(""), "");
}

TEST(Letters, AreSqueezedAsCanvasDoes) {
  EXPECT_EQ(squeezed("Müller-Lüdenscheidt, Jörg"), "müllerlüdenscheidtjörg");
  EXPECT_EQ(squeezed("O'Brien, Sea\xcc\x81n"), "obrienseán");
  EXPECT_EQ(squeezed("Øst, Élodie 2"), "østélodie2");
  EXPECT_EQ(squeezed("李, 伟"), "李伟");
  EXPECT_EQ(squeezed("-, '"), "");
}

TEST(Letters, LoseTheirMarksWhereAsciiHasThem) {
  EXPECT_EQ(without_marks("Müller-Lüdenscheidt, Jo\xcc\x88rg"), "Muller-Ludenscheidt, Jorg");
  EXPECT_EQ(without_marks("Øst 李"), "Øst 李");
}

// utf8proc sorts a run of marks in quadratic time. U+0F73 consists of two marks.
TEST(Letters, WithManyMarksInARowStayAsTheyAre) {
  const auto times = [](int count, const std::string& letter) {
    std::string text;
    for (int i = 0; i < count; ++i) text += letter;
    return text;
  };
  for (const std::string& text :
       {"a" + times(10'000, "\xcc\x81") + times(10'000, "\xcc\x96"), "a" + times(10'000, "\xe0\xbd\xb3")}) {
    EXPECT_FALSE(is_stream_safe(text));
    const std::clock_t start = std::clock();
    EXPECT_EQ(composed_path(text), text);
    EXPECT_EQ(composed(text), text);
    EXPECT_EQ(without_marks(text), text);
    EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC);
  }
  EXPECT_TRUE(is_stream_safe(times(30, "\xcc\x81") + "a" + times(30, "\xcc\x81")));
  EXPECT_FALSE(is_stream_safe(times(31, "\xcc\x81")));
}

TEST(Letters, AreLegibleInALine) {
  EXPECT_EQ(legible("Jörg\n\x1b[31m\xff\u202e"), "Jörg\\x0a\\x1b[31m\\xff\\xe2\\x80\\xae");
  EXPECT_EQ(legible("李伟李伟", 6), "李伟...");
}

TEST(Letters, TakeColumnsOfATerminal) {
  EXPECT_EQ(terminal_columns("Jörg"), 4U);
  EXPECT_EQ(terminal_columns("Jo\xcc\x88rg"), 4U);
  EXPECT_EQ(terminal_columns("李伟"), 4U);
  EXPECT_EQ(first_columns("李伟", 3), "李");
  EXPECT_EQ(first_columns("Jo\xcc\x88rg", 2), "Jo\xcc\x88");
  EXPECT_EQ(first_columns("Jörg", 9), "Jörg");
}

}  // namespace
}  // namespace grader::text
