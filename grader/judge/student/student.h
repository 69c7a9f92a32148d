// STAFF ONLY. A student's code as the suite sees it: a process behind two pipes that gets requests and may
// answer. All answers are untrusted; a worker that dies is restarted for the next request, as long as the
// allowance lasts.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"
#include "grader/judge/student/provided.h"
#include "grader/judge/student/recording.h"
#include "grader/sandbox/sandbox.h"
#include "grader/sandbox/watchdog.h"
#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader::inline judge {

// The budget of a submission's code in one exercise, for all its workers together, and the part
// that they have used.
struct Allowance {
  Budget limit;
  Budget spent = nothing_spent();

  // A new worker may idle for at most half of the exercise's time, so that one that falls asleep leaves some
  // for the other categories.
  double idle_seconds_of_a_worker() const {
    return std::min(limit.idle_seconds - spent.idle_seconds, limit.idle_seconds / 2);
  }
  double wakeup_seconds = 0;  // is the time that watchdogs have forgiven

  // Starts with the same limit as the idle time.
  double wakeup_seconds_left() const { return std::max(0.0, limit.idle_seconds - wakeup_seconds); }
  double wall_seconds_left() const { return std::max(0.0, limit.wall_seconds - spent.wall_seconds); }
  double cpu_seconds_left() const { return limit.worker_cpu_seconds - spent.worker_cpu_seconds; }
};

// Such a note means that calls of given functions were nested too deeply.
inline constexpr const char* kNestedCalls = "calls within calls";

struct WorkerSetup {
  std::filesystem::path kit;          // see grader/worker/CMakeLists.txt
  std::string exercise;               // names the exercise whose server answers
  std::vector<std::string> provided;  // are prerequisites whose functions the suite provides, see provided.h
  std::vector<std::filesystem::path> objects;  // in loading order; the student's last
  std::filesystem::path log;                   // the worker's output is appended here
  Isolation isolation = Isolation::namespaces;
  int cpu_seconds = 10;  // bounds one worker
  // Workers that share it may be copies of one setup.
  std::shared_ptr<Allowance> allowance = std::make_shared<Allowance>();
};

struct Answer {
  Outcome outcome;
  MessageReader reply;  // the server's reply, if done
  std::string note;     // says to staff what happened
};

class Student {
 public:
  static constexpr int kMostTimeouts = 2;  // a third one would only cost time

  explicit Student(WorkerSetup setup) : setup_(std::move(setup)) {}

  // Records all later requests there. Null: stops recording.
  void record(Recording* recording) { recording_ = recording; }
  void begin_case();  // for the recording

  // Sends a request and waits for its answer.
  Answer ask(const MessageWriter& request, const Products& products);

  // Sums all workers that have ended.
  double cpu_seconds() const { return cpu_seconds_; }

  // Returns the CPU time of the present worker so far, all threads together, by the kernel's clock, which
  // code in the worker can't change. Nothing if there is no worker.
  std::optional<double> worker_cpu_seconds() const;
  int starts() const { return starts_; }

  // Lists ConjGrad's solves that the suite made for the last request, in their order. Empty if the student's
  // code solves by itself.
  const std::vector<ProvidedSolve>& provided_solves() const { return provided_solves_; }
  const Budget& spent() const { return setup_.allowance->spent; }
  const std::optional<Answer>& gave_up() const { return gave_up_; }  // final answer, if the suite gave up
  void finish();

 private:
  struct Worker;

  std::optional<Answer> start();
  struct Conversation;
  struct Over;
  Answer ask_worker(const MessageWriter& request, const Products& products);
  Answer converse(const MessageWriter& request, Conversation& conversation);
  void charge(const Conversation& conversation);
  MessageReader listen(Conversation& conversation, Kind until);
  void serve_product(Conversation& conversation, MessageReader& asked);
  void serve_call(Conversation& conversation, MessageReader call);
  std::optional<Message> receive();
  Answer broke_rules(const std::string& how);
  Answer ended(const std::string& during);
  Answer left(const std::string& during, int code);
  std::optional<Answer> give_up_if_used_up();
  Ending end(double grace_seconds);
  bool tell(Kind kind, std::uint64_t nonce, std::span<const std::byte> body);

  WorkerSetup setup_;
  Recording* recording_ = nullptr;
  std::shared_ptr<Worker> worker_;
  bool forgiven_ = false;  // True: the last worker ended because we stopped it.
  std::optional<Answer> gave_up_;
  Outcome last_failure_ = Outcome::timed_out;
  double cpu_seconds_ = 0;
  std::vector<ProvidedSolve> provided_solves_;
  int starts_ = 0, timeouts_ = 0;
};

}  // namespace grader::judge
