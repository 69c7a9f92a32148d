// `hairlab live` from outside, as a browser sees it.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <utility>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"

namespace hair {
namespace {

constexpr int kMostHeartbeats = 60;  // two minutes

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Live {
 public:
  explicit Live(const std::string& hairlab, const std::string& scene = "strand-swing")
      : process_(start_program({.words = {hairlab, "live", scene},
                                .output = folder_.path() / "out",
                                .errors = folder_.path() / "errors"})) {
    if (!wait_until([&] { return out().find("Ctrl-C") != std::string::npos; }, process_))
      throw std::runtime_error(bytes_of(folder_.path() / "errors"));
    const std::string line = out().substr(0, out().find('\n'));
    constexpr std::string_view kBefore = "http://", kToken = "/?token=";
    const std::size_t token = line.find(kToken);
    host = line.substr(kBefore.size(), token - kBefore.size());
    query = line.substr(token + 1);
  }
  ~Live() {
    if (process_ > 0) end(SIGKILL);
  }

  std::optional<int> end(int signal) {
    kill(process_, signal);
    return exit_code_of(std::exchange(process_, -1));
  }

  std::string own() const { return "Host: " + host + "\r\nOrigin: http://" + host + "\r\n"; }

  // Sends a request. The answer comes from the descriptor.
  int ask(const std::string& line, const std::string& headers, const std::string& body = "") const {
    const auto port = static_cast<in_port_t>(std::stoi(host.substr(host.find(':') + 1)));
    const sockaddr_in server{AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}};
    const int to = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(to, reinterpret_cast<const sockaddr*>(&server), sizeof server), 0);
    const std::string request = line + " HTTP/1.1\r\n" + headers +
                                "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
    send(to, request.data(), request.size(), MSG_NOSIGNAL);
    return to;
  }

  int status(const std::string& line, const std::string& headers, const std::string& body = "") const {
    const int from = ask(line, headers, body);
    char start[sizeof "HTTP/1.1 200"] = "HTTP/1.1 -1";  // if it is cut off
    recv(from, start, sizeof start - 1, MSG_WAITALL);
    close(from);
    return std::atoi(start + 9);
  }

  int command(const std::string& what, const std::string& headers) const {
    return status("POST /command" + query, headers, what);
  }

  // Events until one has `wanted` in it, or until nothing more comes; all of them.
  std::string events_until(
      const std::string& wanted, const std::function<void()>& meanwhile = [] {}) const {
    const int from = ask("GET /events" + query, own());
    std::string all, piece(" ");
    for (int quiet = 0; quiet < kMostHeartbeats && !piece.empty() && !has(all, wanted);) {
      piece.resize(1 << 16);
      piece.resize(std::max<ssize_t>(recv(from, piece.data(), piece.size(), 0), 0));
      if (all.empty()) meanwhile();
      all += piece;
      quiet = has(piece, "data:") ? 0 : quiet + 1;
    }
    close(from);
    return all;
  }

  std::string host, query;

 private:
  std::string out() const {
    std::ifstream file(folder_.path() / "out");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_{"hairlab-live"};
  pid_t process_;
};

TEST(HairlabLive, AnswersItsOwnPageAndNobodyElse) {
  const Live live(HAIRLAB);
  EXPECT_TRUE(live.host.starts_with("127.0.0.1:")) << live.host;
  const std::string page = "GET /" + live.query, host = "Host: " + live.host + "\r\n";
  EXPECT_EQ(live.status(page, host), 200);
  EXPECT_EQ(live.status("GET /", host), 403) << "no token";
  EXPECT_EQ(live.status(page, "Host: evil.example\r\n"), 403);
  EXPECT_EQ(live.status("GET /events" + live.query, host + "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(live.status("GET /other" + live.query, host), 404);
  EXPECT_EQ(live.command("pause", host), 403) << "no origin";
  EXPECT_EQ(live.command("pause", live.own()), 204);
  EXPECT_EQ(live.command("<script>", live.own()), 400);
  EXPECT_EQ(live.command(std::string(201, 'a'), live.own()), 413);
}

TEST(HairlabLive, RefusesARequestWithEndlessHeaders) {
  const Live live(HAIRLAB);
  std::string headers;
  while (headers.size() < 1'000'000) headers += "a: b\r\n";
  EXPECT_NE(live.status("GET /" + live.query, live.own() + headers), 200);
  EXPECT_EQ(live.status("GET /" + live.query, live.own()), 200) << "it goes on";
}

TEST(HairlabLive, PlaysFramesPausesAndStartsAnewWithOtherSettings) {
  Live live(HAIRLAB);
  const std::string first = live.events_until(R"("kind":"frame","time":0.0)", [] {});
  EXPECT_TRUE(has(first, R"(data: {"kind":"began")")) << first;
  EXPECT_TRUE(has(first, R"(data: {"kind":"start")"));
  live.events_until(R"("going":false)", [&] { EXPECT_EQ(live.command("pause", live.own()), 204); });
  const std::string other = live.events_until(
      R"("method":"midpoint")", [&] { EXPECT_EQ(live.command("restart 2 1 midpoint", live.own()), 204); });
  EXPECT_TRUE(has(other, R"("settings":"2 1 midpoint")"));
  EXPECT_EQ(live.end(SIGTERM), 0) << "it ends as it should, with pages that listen or not";
}

TEST(HairlabLive, SaysWhereItBlewUp) {
  const Live live(HAIRLAB);
  const std::string all = live.events_until(R"("ended":"blow_up")",
                                            [&] { live.command("restart 32 1 forward_euler", live.own()); });
  EXPECT_TRUE(has(all, R"("blow_up":{"text":"strand 0, step )"));
}

TEST(HairlabLive, NamesAnExerciseThatIsNotWrittenAndStays) {
  const Live live(STUDENT_HAIRLAB);
  const std::string all = live.events_until(R"("kind":"trouble")");
  EXPECT_TRUE(has(all, "This needs ") && has(all, "student/") && has(all, "not implemented yet")) << all;
  EXPECT_EQ(live.status("GET /" + live.query, live.own()), 200);
}

TEST(HairlabLive, RefusesAPortThatIsTaken) {
  const Live live(HAIRLAB);
  const TemporaryFolder folder("hairlab-live");
  const std::string port = live.host.substr(live.host.find(':') + 1);
  const pid_t other = start_program({.words = {HAIRLAB, "live", "strand-swing", "--port", port},
                                     .output = folder.path() / "out",
                                     .errors = folder.path() / "errors"});
  EXPECT_EQ(exit_code_of(other), 2);
  EXPECT_EQ(bytes_of(folder.path() / "errors"),
            "hairlab: port " + port + " is taken; without --port a free one is found\n");
}

}  // namespace
}  // namespace hair
