// STAFF ONLY. Tests base64, and the names of statuses and outcomes.
#include "grader/result/result.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "grader/result/result_fields.h"

namespace grader::inline result {
namespace {

// These are from RFC 4648, section 10.
TEST(Base64, IsTheRfcs) {
  const std::map<std::string, std::string> vectors{{"", ""},
                                                   {"f", "Zg=="},
                                                   {"fo", "Zm8="},
                                                   {"foo", "Zm9v"},
                                                   {"foob", "Zm9vYg=="},
                                                   {"fooba", "Zm9vYmE="},
                                                   {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(pictures_in_base64().write(bytes), text);
    EXPECT_EQ(pictures_in_base64().read(text), bytes);
  }
  for (const char* bad : {"Zg", "Zg=", "Zg==\n", "Zm9v!", "Zh==", "====", "Z"})
    EXPECT_THROW(pictures_in_base64().read(bad), std::invalid_argument) << bad;
}

TEST(Statuses, HaveNamesAndSentencesOfTheirOwn) {
  std::map<std::string, int> names, sentences;
  for (int i = 0; i <= static_cast<int>(kLast<Status>); ++i) {
    const auto status = static_cast<Status>(i);
    EXPECT_TRUE(names.emplace(to_string(status), i).second);
    EXPECT_TRUE(sentences.emplace(sentence_for(status), i).second);
    EXPECT_TRUE(sentence_for(status).ends_with("."));
  }
  EXPECT_THROW(to_string(static_cast<Status>(names.size())), std::out_of_range) << "kLast is the last";
}

}  // namespace
}  // namespace grader::result
