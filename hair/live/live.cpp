#include "hair/live/live.h"

#include <chrono>
#include <deque>
#include <iostream>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "hair/io/files/json_text.h"
#include "hair/live/child.h"
#include "hair/live/message_log.h"
#include "hair/live/server.h"

namespace hair {

namespace {

constexpr auto kLongestSilence = std::chrono::seconds(10);
constexpr int kTurn = 20;              // ms
constexpr int kTurnsBetweenLooks = 8;  // at the program's file
constexpr const char* kUsualSettings = "1 1 0";
constexpr std::string_view kRestart = "restart ";

// Commands of pages, from the server's threads to ours.
class Commands {
 public:
  void put(const std::string& command) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(command);
  }
  std::optional<std::string> take() {
    const std::lock_guard lock(mutex_);
    if (waiting_.empty()) return {};
    std::string command = std::move(waiting_.front());
    waiting_.pop_front();
    return command;
  }

 private:
  std::mutex mutex_;
  std::deque<std::string> waiting_;
};

class Supervisor {
 public:
  Supervisor(const LiveOptions& options, MessageLog& log) : words_(options.words), log_(log) {}

  void start(const std::string& why) {
    started_ = true;
    child_.reset();
    log_.begin(json_object(
        {{"kind", json_text("began")}, {"why", json_text(why)}, {"settings", json_text(settings_)}}));
    try {
      child_.emplace(words_, settings_);
      child_->tell("rate " + rate_);
    } catch (const std::system_error& error) {
      say("The program does not start: " + error.code().message() + ".");
    }
  }

  void obey(const std::string& command) {
    if (command == kPageOpened) {
      if (!started_) start("");  // so that a page shows the start
    } else if (command.starts_with(kRestart)) {
      settings_ = command.substr(kRestart.size());
      start("");
    } else {
      if (command.starts_with("rate ")) rate_ = command.substr(5);
      if (child_) child_->tell(command);
    }
  }

  // Listens for some milliseconds.
  void listen() {
    if (!child_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kTurn));
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - listened_ > std::chrono::seconds(2))
      child_->forgive_silence();  // Ctrl-Z had stopped this program
    listened_ = now;
    if (auto message = child_->next(kTurn)) log_.add(std::move(*message));
    if (const auto stopped = child_->stop_if_silent(kLongestSilence)) say(*stopped);
    if (const auto ended = child_->ended()) {
      if (!ended->empty()) say(*ended);
      child_.reset();
    }
  }

 private:
  void say(const std::string& text) {
    std::cerr << "hairlab: " << text << "\n";
    log_.add(json_object({{"kind", json_text("trouble")}, {"text", json_text(text)}}));
  }

  std::vector<std::string> words_;
  MessageLog& log_;
  std::string settings_ = kUsualSettings, rate_ = "1";
  bool started_ = false;
  std::chrono::steady_clock::time_point listened_ = {};
  std::optional<Child> child_;
};

}  // namespace

void serve_live(const LiveOptions& options, ProgramFile program, const std::atomic<bool>& interrupted) {
  MessageLog log;
  Commands commands;
  LiveServer server(options, log, [&](const std::string& command) { commands.put(command); });
  std::cout << server.address().url() << "\n"
            << "Open this in a browser on this machine. After you build hairlab_live anew, the page goes on "
               "with it; Ctrl-C ends it."
            << std::endl;
  Supervisor supervisor(options, log);
  for (long turn = 0; !interrupted; ++turn) {
    while (const auto command = commands.take()) supervisor.obey(*command);
    supervisor.listen();
    if (turn % kTurnsBetweenLooks == 0 && program.is_new()) supervisor.start("The program was built anew.");
  }
  log.close();
}

}  // namespace hair
