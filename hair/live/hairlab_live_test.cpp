// `hairlab live` from outside, as a browser sees it.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/serve/test_client.h"

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
    client = TestClient::at(out());
  }
  ~Live() {
    if (process_ > 0) end(SIGKILL);
  }

  std::optional<int> end(int signal) {
    kill(process_, signal);
    return exit_code_of(std::exchange(process_, -1));
  }

  int command(const std::string& what, const std::string& headers) const {
    return client.status("POST " + client.base + "command", headers, what);
  }

  // Events until one has `wanted` in it, or until nothing more comes; all of them.
  std::string events_until(
      const std::string& wanted, const std::function<void()>& meanwhile = [] {}) const {
    const int from = client.ask("GET " + client.base + "events", client.own());
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

  TestClient client;

 private:
  std::string out() const { return bytes_of(folder_.path() / "out"); }

  TemporaryFolder folder_{"hairlab-live"};
  pid_t process_;
};

TEST(HairlabLive, ObeysCommandsAlone) {
  const Live live(HAIRLAB);
  const std::string own = live.client.own(), page = "GET " + live.client.base;
  EXPECT_EQ(live.client.status(page, own), 200);
  EXPECT_EQ(live.client.status(page + "other", own), 404);
  EXPECT_EQ(live.command("pause", "Host: " + live.client.host + "\r\n"), 403) << "no origin";
  EXPECT_EQ(live.command("pause", own), 204);
  EXPECT_EQ(live.command("<script>", own), 400);
  EXPECT_EQ(live.command(std::string(201, 'a'), own), 413);
}

TEST(HairlabLive, PlaysFramesPausesAndStartsAnewWithOtherSettings) {
  Live live(HAIRLAB);
  const std::string first = live.events_until(R"("kind":"frame","time":0.0)", [] {});
  EXPECT_TRUE(has(first, R"(data: {"kind":"began")")) << first;
  EXPECT_TRUE(has(first, R"(data: {"kind":"start")"));
  live.events_until(R"("going":false)", [&] { EXPECT_EQ(live.command("pause", live.client.own()), 204); });
  const std::string other = live.events_until(R"("method":"midpoint")", [&] {
    EXPECT_EQ(live.command("restart 2 1 0 midpoint", live.client.own()), 204);
  });
  EXPECT_TRUE(has(other, R"("settings":"2 1 0 midpoint")"));
  EXPECT_EQ(live.end(SIGTERM), 0) << "it ends as it should, with pages that listen or not";
}

TEST(HairlabLive, SaysWhereItBlewUp) {
  const Live live(HAIRLAB);
  const std::string all = live.events_until(
      R"("ended":"blow_up")", [&] { live.command("restart 32 1 0 forward_euler", live.client.own()); });
  EXPECT_TRUE(has(all, R"("blow_up":{"text":"strand 0, step )"));
}

TEST(HairlabLive, NamesAnExerciseThatIsNotWrittenAndStays) {
  const Live live(STUDENT_HAIRLAB);
  const std::string all = live.events_until(R"("kind":"trouble")");
  EXPECT_TRUE(has(all, "This needs ") && has(all, "student/") && has(all, "not implemented yet")) << all;
  EXPECT_EQ(live.client.status("GET " + live.client.base, live.client.own()), 200);
}

TEST(HairlabLive, RefusesAPortThatIsTaken) {
  const Live live(HAIRLAB);
  const TemporaryFolder folder("hairlab-live");
  const std::string port = live.client.host.substr(live.client.host.find(':') + 1);
  const pid_t other = start_program({.words = {HAIRLAB, "live", "strand-swing", "--port", port},
                                     .output = folder.path() / "out",
                                     .errors = folder.path() / "errors"});
  EXPECT_EQ(exit_code_of(other), 2);
  EXPECT_EQ(bytes_of(folder.path() / "errors"),
            "hairlab: port " + port + " is taken; without --port a free one is found\n");
}

}  // namespace
}  // namespace hair
