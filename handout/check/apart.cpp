#include "apart.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "solver/not_implemented.h"

namespace checks {
namespace {

// A child reports each event to its parent as a letter, a length and so many bytes.
constexpr char kStarts = 's', kFails = 'f', kHints = 'h', kPasses = 'p', kEnds = 'e';

void tell(int out, char event, const std::string& text) {
  std::string bytes(1, event);
  const std::size_t length = text.size();
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += text;
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t now = write(out, bytes.data() + sent, bytes.size() - sent);
    if (now <= 0) _exit(3);
    sent += static_cast<std::size_t>(now);
  }
}

// Ends this process after so many further seconds of computing, or thirty times as many of waiting.
void limit_from_now(unsigned seconds) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  const auto so_far = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  limit.rlim_cur = std::min(limit.rlim_max, so_far + 1 + seconds);
  setrlimit(RLIMIT_CPU, &limit);
  alarm(30 * seconds);
}

class Teller : public testing::EmptyTestEventListener {
 public:
  Teller(int out, unsigned seconds) : out_(out), seconds_(seconds) {}

  void OnTestStart(const testing::TestInfo& test) override {
    limit_from_now(seconds_);
    tell(out_, kStarts, test.name());
  }
  void OnTestPartResult(const testing::TestPartResult& part) override {
    if (part.failed()) tell(out_, kFails, part.message());
  }
  void OnTestEnd(const testing::TestInfo& test) override {
    std::fflush(stdout);
    for (int i = 0; i < test.result()->test_property_count(); ++i) {
      const testing::TestProperty& one = test.result()->GetTestProperty(i);
      if (one.key() == std::string("hint")) tell(out_, kHints, one.value());
    }
    tell(out_, test.result()->Failed() ? kEnds : kPasses, test.name());
  }

 private:
  int out_;
  unsigned seconds_;
};

// Reads both until both are closed at their other ends.
void read_both(int in1, std::string& text1, int in2, std::string& text2) {
  pollfd open[2] = {{in1, POLLIN, 0}, {in2, POLLIN, 0}};
  std::string* texts[2] = {&text1, &text2};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    if (poll(open, 2, -1) < 0) {
      if (errno != EINTR) return;
      continue;
    }
    for (int i = 0; i < 2; ++i) {
      if (open[i].fd < 0 || open[i].revents == 0) continue;
      char block[4096];
      const ssize_t got = read(open[i].fd, block, sizeof block);
      if (got > 0)
        texts[i]->append(block, static_cast<std::size_t>(got));
      else if (got == 0 || errno != EINTR)
        open[i].fd = -1;  // poll leaves it out
    }
  }
}

// Runs the checks of the filter.
void run_checks_of(const std::string& filter, unsigned seconds, int events) {
  testing::GTEST_FLAG(filter) = filter;
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new Teller(events, seconds));
  [[maybe_unused]] const int failed = RUN_ALL_TESTS();  // the events report it
}

struct Ended {
  std::string events, errors;
  int signal = 0;  // 0: it left by itself
};

// Does `work` in a child, which gets a place to write events to.
Ended run_in_a_child(unsigned seconds, const std::function<void(int events)>& work) {
  int events[2], errors[2];
  if (pipe(events) != 0 || pipe(errors) != 0) throw std::runtime_error("no pipe for a check");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a check: too many of them run");
  if (child == 0) {
    close(events[0]);
    close(errors[0]);
    dup2(errors[1], STDERR_FILENO);
    if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO);
    setvbuf(stdout, nullptr, _IOLBF, 0);  // a crash loses no line
    limit_from_now(seconds);
    work(events[1]);
    std::fflush(nullptr);
    _exit(0);
  }
  close(events[1]);
  close(errors[1]);
  Ended ended;
  read_both(events[0], ended.events, errors[0], ended.errors);
  close(events[0]);
  close(errors[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  return ended;
}

// Fills in the checks' results from the events. Returns the check that did not end, or null.
Finding* take_events(const std::string& events, const std::vector<Finding*>& checks) {
  Finding* current = nullptr;
  std::size_t at = 0, length = 0;
  while (at + 1 + sizeof length <= events.size()) {
    const char event = events[at];
    std::memcpy(&length, events.data() + at + 1, sizeof length);
    at += 1 + sizeof length;
    if (length > events.size() - at) break;
    const std::string text = events.substr(at, length);
    at += length;
    if (event == kStarts) {
      const auto found = std::ranges::find_if(checks, [&](const Finding* one) { return one->name == text; });
      current = found == checks.end() ? nullptr : *found;
    } else if (current != nullptr && event == kFails) {
      current->failures.push_back(text);
    } else if (current != nullptr && event == kHints) {
      current->hint = text;
    } else if (current != nullptr) {
      current->state = event == kPasses ? Finding::State::passed : Finding::State::failed;
      current = nullptr;
    }
  }
  return current;
}

// The text from `words` to the end of their line; "" if the text does not have them.
std::string line_with(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

// "student/conj_grad.cpp:17" of the first frame in a file of yours.
std::string place_in(const std::string& written) {
  const std::string folder = "/student/";
  for (std::size_t at = written.find(folder); at != std::string::npos; at = written.find(folder, at + 1)) {
    const std::string place = written.substr(at + 1, written.find_first_of(" \n)", at) - at - 1);
    if (place.find('/', folder.size() - 1) == std::string::npos && place.find(".cpp") != std::string::npos)
      return place;
  }
  return "";
}

bool is_a_sanitizers(const std::string& written) {
  return written.find("Sanitizer") != std::string::npos ||
         written.find("runtime error: ") != std::string::npos;
}

// The text that the program itself wrote: without an assertion's long line, which is in the findings.
std::string own_lines(const std::string& written) {
  if (is_a_sanitizers(written)) return "";
  std::string own;
  std::istringstream lines(written);
  for (std::string line; std::getline(lines, line);)
    if (line.find(": Assertion ") == std::string::npos) own += line + "\n";
  return own;
}

std::string signal_in_words(int signal) {
  if (signal == SIGSEGV || signal == SIGBUS)
    return "it reached for memory that is not its own: an array's size, an index, or a loop's bound?";
  if (signal == SIGFPE) return "an integer was divided by 0";
  if (signal == SIGXCPU) return "it took too long, and was ended: a loop that never ends?";
  if (signal == SIGALRM) return "it waited for too long, and was ended";
  if (signal == SIGKILL) return "it was killed: did it ask for too much memory?";
  if (signal == SIGABRT) return "it was ended by abort()";
  return std::string("it was ended by a signal: ") + strsignal(signal);
}

}  // namespace

std::string how_it_ended(int signal, const std::string& written) {
  std::string words;
  for (const char* begin : {"AddressSanitizer: ", "runtime error: ", "Assertion `", "Assertion '",
                            "Assertion failed:", "terminate called", "terminating "}) {
    words = line_with(written, begin);
    if (!words.empty()) break;
  }
  if (words.starts_with("AddressSanitizer: "))  // without the addresses, which say nothing
    for (const char* end : {" on ", " 0x", " (", " exceeds"}) words = words.substr(0, words.find(end));
  for (const char* heap : {"munmap_chunk()", "malloc()", "free()", "corrupted size", "double free"})
    if (words.empty() && written.find(heap) != std::string::npos)
      words = "memory beyond the end of an array was written: its size, a loop's bound, or `i + 1`?";
  if (words.empty()) words = signal == 0 ? "the program left in the middle of it" : signal_in_words(signal);
  const std::string place = place_in(written);
  return words + (place.empty() ? "" : "\nin " + place);
}

std::string not_implemented_by(const std::function<void()>& call, unsigned seconds) {
  return run_in_a_child(seconds,
                        [&](int events) {
                          try {
                            call();
                          } catch (const NotImplemented& problem) {
                            const std::string sentence = problem.what();
                            if (write(events, sentence.data(), sentence.size()) < 0) _exit(3);
                          } catch (...) {
                            _exit(0);  // It is written: the checks will tell what is wrong with it.
                          }
                        })
      .events;
}

void run_apart(std::vector<Finding*> checks, unsigned seconds) {
  for (int endless = 0; !checks.empty() && endless < 2;) {
    std::string filter;
    for (const Finding* check : checks) filter += (filter.empty() ? "" : ":") + check->full_name();
    const Ended ended = run_in_a_child(seconds, [&](int events) { run_checks_of(filter, seconds, events); });
    std::fputs(own_lines(ended.errors).c_str(), stderr);
    if (Finding* broken = take_events(ended.events, checks)) {
      broken->state = Finding::State::broke_off;
      broken->failures.push_back(how_it_ended(ended.signal, ended.errors));
      endless += ended.signal == SIGXCPU || ended.signal == SIGALRM ? 1 : 0;
    } else if (std::ranges::all_of(checks,
                                   [](const Finding* one) { return one->state == Finding::State::waits; })) {
      checks.front()->state = Finding::State::broke_off;  // it ended before the first one
      checks.front()->failures.push_back(how_it_ended(ended.signal, ended.errors));
    }
    std::erase_if(checks, [](const Finding* one) { return one->state != Finding::State::waits; });
  }
}

}  // namespace checks
