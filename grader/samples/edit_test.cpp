// STAFF ONLY. Tests that an edit changes one place, or fails.
#include "grader/samples/edit.h"

#include <gtest/gtest.h>

#include <utility>

#include "grader/course/input.h"
#include "solver/test_refusal.h"

namespace grader::inline samples {
namespace {

using tests::says;

TEST(Edited, LooksForItsLinesInTheTextAsItWas) {
  const std::string text = "a\nb\nc\nb\n";
  const auto edit = [&](std::vector<EditLine> lines) {
    return Edit{"x.samples:1", "f.cpp", std::move(lines)};
  };
  EXPECT_EQ(
      edited(text, "f.cpp", {edit({{'=', "a"}, {'-', "b"}, {'+', "c"}}), edit({{'-', "c"}, {'=', "b"}})}),
      "a\nc\nb\n");
  EXPECT_EQ(edited(text, "f.cpp", {edit({{'+', "0"}, {'=', "a"}})}), "0\na\nb\nc\nb\n");
  EXPECT_EQ(edited(text, "g.cpp", {edit({{'-', "a"}})}), text);
}

TEST(Edited, RefusesWhatIsNotOnePlace) {
  const auto refused = [](std::vector<EditLine> lines, const std::string& words) {
    const Edit edit{"x.samples:1", "f.cpp", std::move(lines)};
    EXPECT_TRUE(says(tests::refusal<BadInput>([&] {
                       edited("a\nb\nc\nb\n", "f.cpp", {edit, edit});
                     }),
                     "x.samples:1: f.cpp " + words));
  };
  refused({{'+', "a"}}, "is not told where");
  refused({{'-', "d"}}, "has no line \"d\"");
  refused({{'-', "a"}, {'-', "c"}}, "has these lines, but not one after the other");
  refused({{'-', "b"}}, "has \"b\" 2 times, in lines 2, 4");
  refused({{'-', "a"}}, "loses \"a\" by two edits");
}

}  // namespace
}  // namespace grader::samples
