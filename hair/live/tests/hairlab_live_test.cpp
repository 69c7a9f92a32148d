// `hairlab live` from outside, as a browser sees it.
#include <gtest/gtest.h>
#include <httplib.h>
#include <signal.h>

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

  httplib::Headers own() const { return {{"Host", host}, {"Origin", "http://" + host}}; }

  int status(const std::string& path, const httplib::Headers& headers) const {
    httplib::Client client("http://" + host);
    const auto answer = client.Get(path.c_str(), headers);
    return answer ? answer->status : -1;
  }

  int command(const std::string& what, const httplib::Headers& headers) const {
    httplib::Client client("http://" + host);
    const auto answer = client.Post(("/command" + query).c_str(), headers, what, "text/plain");
    return answer ? answer->status : -1;
  }

  // Events until one has `wanted` in it, or until nothing more comes; all of them.
  std::string events_until(
      const std::string& wanted, const std::function<void()>& meanwhile = [] {}) const {
    httplib::Client client("http://" + host);
    client.set_read_timeout(600);
    std::string all;
    bool asked = false;
    int quiet = 0;
    client.Get(("/events" + query).c_str(), own(), [&](const char* data, std::size_t size) {
      all.append(data, size);
      if (!std::exchange(asked, true)) meanwhile();
      quiet = std::string_view(data, size).find("data:") == std::string_view::npos ? quiet + 1 : 0;
      return quiet < kMostHeartbeats && all.find(wanted) == std::string::npos;
    });
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

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(HairlabLive, AnswersItsOwnPageAndNobodyElse) {
  const Live live(HAIRLAB);
  EXPECT_TRUE(live.host.starts_with("127.0.0.1:")) << live.host;
  const std::string page = "/" + live.query;
  EXPECT_EQ(live.status(page, {{"Host", live.host}}), 200);
  EXPECT_EQ(live.status("/", {{"Host", live.host}}), 403) << "no token";
  EXPECT_EQ(live.status(page, {{"Host", "evil.example"}}), 403);
  EXPECT_EQ(live.status("/events" + live.query, {{"Host", live.host}, {"Origin", "http://evil.example"}}),
            403);
  EXPECT_EQ(live.command("pause", {{"Host", live.host}}), 403) << "no origin";
  EXPECT_EQ(live.command("pause", live.own()), 204);
  EXPECT_EQ(live.command("<script>", live.own()), 400);
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
  EXPECT_EQ(live.status("/" + live.query, {{"Host", live.host}}), 200);
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
