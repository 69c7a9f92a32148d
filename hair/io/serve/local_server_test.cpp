#include "hair/io/serve/local_server.h"

#include <gtest/gtest.h>

#include "hair/io/files/bad_input.h"
#include "hair/io/serve/test_client.h"

namespace hair {
namespace {

constexpr std::size_t kMostBytes = 200;

struct Served {
  LocalServer server{0, kMostBytes, [](const WebRequest& request) {
                       return WebAnswer{200, request.path + "|" + request.body + "|"};
                     }};
  TestClient client = TestClient::at(server.address().url());
};

TEST(LocalServer, AnswersItsOwnPageAndNobodyElse) {
  const Served served;
  const TestClient& client = served.client;
  const std::string page = "GET " + client.base, post = "POST " + client.base;
  const std::string host = "Host: " + client.host + "\r\n", own = client.own();
  const std::string long_head(1'000'000, 'a');
  const struct {
    std::string line, headers;
    int status;
    std::string body = {};
  } cases[] = {
      {page, host, 200},
      {page + "a/b", host, 200},
      {post + "c", own, 200, std::string(kMostBytes, 'a')},
      {post + "c", own, 413, std::string(kMostBytes + 1, 'a')},
      {post + "c", own, 413, std::string(10'000'000, 'a')},
      {post + "c", host, 403},
      {page, "Host: evil.example\r\n", 403},
      {page, host + "Origin: http://evil.example\r\n", 403},
      {"GET /", host, 403},
      {"GET " + client.base.substr(0, client.base.size() - 1), host, 404},
      {"GET /../" + client.base.substr(1), host, 403},
      {"DELETE " + client.base, own, 404},
      {page, own + "A: " + long_head + "\r\n", -1},
      {page + long_head, own, -1},
  };
  for (const auto& [line, headers, status, body] : cases) {
    const int found = client.status(line, headers, body);
    const std::string what = line.substr(0, 60) + " " + headers.substr(0, 60);
    if (status > 0)
      EXPECT_EQ(found, status) << what;
    else
      EXPECT_TRUE(found == -1 || (found >= 400 && found < 500)) << what << ": " << found;
    EXPECT_EQ(client.status(page, host), 200) << "it goes on after " << what;
  }
  const std::string answer = client.answer(post + "save", own, "text");
  EXPECT_TRUE(answer.ends_with("save|text|")) << answer;
}

TEST(LocalServer, WaitsForNoSlowClient) {
  const Served served;
  const TestClient& client = served.client;
  const std::string head = "POST " + client.base + " HTTP/1.1\r\n" + client.own();
  std::vector<int> slow;
  for (const std::string& begun : {head.substr(0, 10), head, head + "Content-Length: 100\r\n\r\nabc"})
    slow.push_back(client.send_text(begun));
  EXPECT_EQ(client.status("GET " + client.base, client.own()), 200);
  for (const int descriptor : slow) {
    const int status = TestClient::status_from(descriptor);  // waits until the server has closed it
    EXPECT_TRUE(status == -1 || (status >= 400 && status < 500)) << status;
  }
}

TEST(LocalServer, RefusesAPortThatIsTaken) {
  const Served served;
  const int port = std::stoi(served.client.host.substr(served.client.host.find(':') + 1));
  EXPECT_THROW(LocalServer(port, kMostBytes, [](const WebRequest&) { return WebAnswer{}; }), BadInput);
}

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
