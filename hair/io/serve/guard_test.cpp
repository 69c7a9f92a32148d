#include "hair/io/serve/guard.h"

#include <gtest/gtest.h>

namespace hair {
namespace {

const ServerAddress kAddress{"127.0.0.1:4321", "0123456789abcdef"};

struct Case {
  const char* what;
  RequestHead request;
  bool is_refused;
};

TEST(Guard, AnswersItsOwnPageAlone) {
  const std::string host = kAddress.host, token = kAddress.token, own = "http://127.0.0.1:4321";
  const Case cases[] = {
      {"the page, from the address bar", {host, token}, false},
      {"the stream, with an origin", {host, token, false, own}, false},
      {"a command", {host, token, true, own}, false},
      {"a name that points here", {"evil.example:4321", token}, true},
      {"that name, with the right origin", {"evil.example:4321", token, true, own}, true},
      {"another port", {"127.0.0.1:4322", token}, true},
      {"no port", {"127.0.0.1", token}, true},
      {"another site", {host, token, false, "http://evil.example"}, true},
      {"another server of this machine", {host, token, true, "http://127.0.0.1:8000"}, true},
      {"the same, by another protocol", {host, token, true, "https://127.0.0.1:4321"}, true},
      {"a page from disk", {host, token, true, "null"}, true},
      {"a command without an origin", {host, token, true}, true},
      {"no token", {host, ""}, true},
      {"a part of the token", {host, token.substr(1)}, true},
      {"another token", {host, "0123456789abcdee"}, true},
  };
  for (const Case& one : cases)
    EXPECT_EQ(!refusal(one.request, kAddress).empty(), one.is_refused)
        << one.what << ": " << refusal(one.request, kAddress);
}

TEST(Guard, MakesAnotherTokenEachTime) {
  const std::string token = new_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
  EXPECT_NE(new_token(), token);
}

}  // namespace
}  // namespace hair
