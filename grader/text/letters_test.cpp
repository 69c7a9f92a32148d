// STAFF ONLY. One name is one, however its letters are written.
#include "grader/text/letters.h"

#include <gtest/gtest.h>

namespace grader {
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

}  // namespace
}  // namespace grader
