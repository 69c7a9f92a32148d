#include "hair/live/child.h"

#include <cxxabi.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "hair/io/files/start_program.h"

namespace hair {

namespace {

constexpr int kTurnsForAnAnswer = 25;
constexpr int kTimesTheSlowest = 10;

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  return ends;
}

std::string words_of(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "a segmentation fault: the code read or wrote memory that is not its own";
    case SIGABRT:
      return "it was aborted: a check in the code failed, memory was freed twice, or an exception left a "
             "function that may throw none";
    case SIGFPE:
      return "a whole number was divided by zero";
    case SIGILL:
      return "a function ended without a return, or what the compiler took for impossible happened";
    case SIGKILL:
      return "the system ended it, perhaps because memory ran out";
    default:
      return "signal " + std::to_string(signal) + " ended it";
  }
}

std::string leading_word(const std::string& message) {
  return message.substr(0, message.find(','));
}

}  // namespace

Child::Child(const std::vector<std::string>& words, const std::string& settings)
    : heard_(std::chrono::steady_clock::now()) {
  const auto [in, to] = make_pipe();
  const auto [from, out] = make_pipe();
  to_ = to;
  from_ = from;
  messages_.emplace(from_);
  try {
    process_ = start_program({.words = words, .input = in, .output = out});
  } catch (...) {
    for (const int end : {in, out, to_, from_}) ::close(end);
    throw;
  }
  ::close(in);
  ::close(out);
  tell(settings);
}

Child::~Child() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    exit_code_of(process_);
  }
  ::close(to_);
  ::close(from_);
}

void Child::tell(const std::string& command) {
  const std::string line = command + "\n";
  [[maybe_unused]] const ssize_t written = ::write(to_, line.data(), line.size());
}

std::optional<std::string> Child::next(int milliseconds) {
  const std::optional<std::string> line = messages_->next(milliseconds);
  if (!line) return {};
  const auto now = std::chrono::steady_clock::now();
  if (has_begun_) slowest_ = std::max(slowest_, now - heard_);
  heard_ = now;
  has_begun_ = true;
  if (line->starts_with(". ")) {
    steps_ = std::atol(line->c_str() + 2);
    return {};
  }
  if (line->empty()) return {};
  if (line->starts_with("@ ")) {
    read_whereabouts(*line);
    return {};
  }
  const std::string kind = leading_word(*line);
  has_trouble_ = has_trouble_ || kind == R"({"kind":"trouble")";
  if (const std::size_t at = line->find("\"steps\":");
      kind != R"({"kind":"start")" && at != std::string::npos)
    steps_ = std::atol(line->c_str() + at + std::strlen("\"steps\":"));
  return line;
}

// "@ H6 _ZN4hair7correctEv"
void Child::read_whereabouts(const std::string& line) {
  const std::size_t space = line.find(' ', 2);
  where_ = " in " + line.substr(2, space - 2);
  if (space == std::string::npos || space + 1 == line.size()) return;
  const std::string name = line.substr(space + 1);
  int status = 0;
  char* const readable = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  const std::string function = status == 0 ? readable : name;
  std::free(readable);
  where_ += " (" + function.substr(0, function.find('(')) + ")";
}

std::string Child::after() const {
  return where_ + (steps_ == 0 ? " before the first step was over" : " after step " + std::to_string(steps_));
}

std::optional<std::string> Child::ended() {
  if (process_ <= 0 || messages_->open()) return {};
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return {};
  process_ = -1;
  if (has_trouble_ || stopped_) return "";
  if (WIFSIGNALED(status)) return "The code crashed" + after() + ": " + words_of(WTERMSIG(status)) + ".";
  return "The code ended the program" + after() + ", with exit code " + std::to_string(WEXITSTATUS(status)) +
         ".";
}

std::optional<std::string> Child::stop_if_silent(std::chrono::seconds longest) {
  longest = has_begun_
                ? std::max(longest, std::chrono::ceil<std::chrono::seconds>(kTimesTheSlowest * slowest_))
                : 3 * longest;
  if (process_ <= 0 || stopped_ || std::chrono::steady_clock::now() - heard_ < longest) return {};
  stopped_ = true;
  kill(process_, SIGUSR1);
  for (int i = 0; i < kTurnsForAnAnswer && where_.empty(); ++i) next(20);
  kill(process_, SIGKILL);
  return "The code did not come back" + after() + ", for " + std::to_string(longest.count()) +
         " s, and was ended: an endless loop?";
}

}  // namespace hair
