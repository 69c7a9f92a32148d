// STAFF ONLY. Starts workers, exchanges messages with them, and reports how each request ended.
#include "grader/judge/student/student.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sodium.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "grader/judge/student/provided.h"
#include "grader/judge/student/recording.h"
#include "grader/sandbox/system_mounts.h"
#include "solver/timing.h"

namespace grader::inline judge {
namespace {

// Larger than any array that a case sends; a worker that announces more has broken the protocol.
constexpr std::size_t kLargestMessage = std::size_t{8} << 20;

// Bounds calls within callbacks; honest code makes fewer.
constexpr int kMostCalls = 4;

// These say when a worker may end.
constexpr const char* kLoading = "while the code was loaded";
constexpr const char* kAsking = "during the request";

// The worker's object threw in a callback: the exception has already left the call.
struct CallbackThrew {};

std::uint64_t random_nonce() {
  std::uint64_t nonce;
  randombytes_buf(&nonce, sizeof nonce);
  return nonce;
}

// Lists objects in loading order.
std::vector<std::filesystem::path> all_objects(const WorkerSetup& setup) {
  std::vector<std::filesystem::path> all;
  for (const std::string& id : setup.provided) all.push_back(setup.kit / "provided" / (id + ".so"));
  all.insert(all.end(), setup.objects.begin(), setup.objects.end());
  return all;
}

Sandbox worker_sandbox(const WorkerSetup& setup) {
  Sandbox sandbox;
  sandbox.mounts = runtime_library_mounts();
  sandbox.mounts.push_back({setup.kit / "worker", "/worker"});
  sandbox.mounts.push_back({setup.kit / "serve" / (setup.exercise + ".so"), "/server.so"});
  for (const auto& object : all_objects(setup))
    sandbox.mounts.push_back({object, "/objects/" + object.filename().string()});
  sandbox.isolation = setup.isolation;
  sandbox.roots = setup.kit.parent_path() / "roots";
  sandbox.limits.cpu_seconds = static_cast<int>(
      std::ceil(std::clamp(setup.allowance->cpu_seconds_left(), 1.0, 1.0 * setup.cpu_seconds)));
  return sandbox;
}

Watchdog::Patience patience(const WorkerSetup& setup) {
  Watchdog::Patience patience;
  patience.idle_seconds = setup.allowance->idle_seconds_of_a_worker();
  patience.cpu_seconds = std::min(1.0 * setup.cpu_seconds, setup.allowance->cpu_seconds_left());
  patience.wakeup_seconds = setup.allowance->wakeup_seconds_left();
  patience.wall_seconds = setup.allowance->wall_seconds_left();
  return patience;
}

// 0 is no limit. The kernel counts all threads of a user in a user name space: without a sandbox, it
// also counts the user's other programs.
std::vector<std::string> worker_command(const WorkerSetup& setup, const Limits& limits) {
  std::vector<std::string> command = {
      "/worker", std::to_string(limits.cpu_seconds), std::to_string(limits.memory_bytes),
      setup.isolation != Isolation::none ? std::to_string(limits.processes) : "0"};
  for (const auto& object : all_objects(setup)) command.push_back("/objects/" + object.filename().string());
  command.push_back("/server.so");
  return command;
}

}  // namespace

struct Student::Worker {
  Pipe requests = make_pipe(), replies = make_pipe();
  Descriptor log;
  int cpu_seconds;
  SandboxedProcess process;
  Watchdog watchdog;
  Channel channel;

  Worker(const WorkerSetup& setup, const Sandbox& sandbox)
      : log(open(setup.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)),
        cpu_seconds(sandbox.limits.cpu_seconds),
        process(sandbox, worker_command(setup, sandbox.limits), requests.read_end.get(),
                replies.write_end.get(), log.get()),
        watchdog(process, patience(setup)),
        channel(replies.read_end.get(), requests.write_end.get(),
                [this](int descriptor, short events) { return watchdog.wait_for(descriptor, events); }) {
    requests.read_end.close();
    replies.write_end.close();
    fcntl(requests.write_end.get(), F_SETFL, O_NONBLOCK);
    // A larger pipe needs fewer turns for large vectors; if the kernel refuses, the usual size works.
    fcntl(requests.write_end.get(), F_SETPIPE_SZ, 1 << 18);
    fcntl(replies.read_end.get(), F_SETPIPE_SZ, 1 << 18);
  }
};

// Returns the last failure again, for all later requests, once a part of the allowance is used up.
std::optional<Answer> Student::give_up_if_used_up() {
  if (const char* what = used_up(setup_.allowance->spent, setup_.allowance->limit);
      what != nullptr && !gave_up_)
    gave_up_ = Answer{last_failure_, MessageReader({}), std::string("used up: ") + what};
  return gave_up_;
}

// Ends the worker, which has `grace_seconds` to leave by itself, and charges its costs.
Ending Student::end(double grace_seconds) {
  Budget& spent = setup_.allowance->spent;
  worker_->watchdog.wait_for_end(grace_seconds);
  const Ending ending = worker_->process.wait(0);
  spent.idle_seconds += worker_->watchdog.idle_seconds();
  setup_.allowance->wakeup_seconds += worker_->watchdog.wakeup_seconds();
  spent.worker_cpu_seconds += worker_->watchdog.cpu_seconds();
  cpu_seconds_ += worker_->watchdog.cpu_seconds();
  worker_.reset();
  return ending;
}

bool Student::tell(Kind kind, std::uint64_t nonce, std::span<const std::byte> body) {
  const bool sent = worker_->channel.send(kind, nonce, body);
  worker_->watchdog.asked();
  return sent;
}

// Returns the next message and charges its cost. It ignores a worker that has used up the allowance.
std::optional<Message> Student::receive() {
  std::optional<Message> message = worker_->channel.receive(kLargestMessage);
  if (message) {
    setup_.allowance->spent.messages += 1;
    setup_.allowance->spent.megabytes += 1e-6 * static_cast<double>(message->body.size());
  }
  return message;
}

std::optional<Answer> Student::start() {
  if (starts_ > 0 && !std::exchange(forgiven_, false)) setup_.allowance->spent.restarts += 1;
  if (give_up_if_used_up()) return gave_up_;
  ++starts_;
  worker_ = std::make_shared<Worker>(setup_, worker_sandbox(setup_));
  try {
    const std::optional<Message> message = receive();
    if (!message) return ended(kLoading);
    switch (message->kind) {
      case Kind::hello:
        return {};
      case Kind::left:
        return left(kLoading, MessageReader(message->body).get<int>());
      case Kind::denied:
        return broke_rules("it tried " +
                           std::string(denied_syscall(MessageReader(message->body).get<int>())));
      case Kind::cannot_load:
        end(1);
        gave_up_ = Answer{Outcome::cannot_load, MessageReader({}), MessageReader(message->body).get_text()};
        return gave_up_;
      default:
        return broke_rules("the first message is not the greeting");
    }
  } catch (const MalformedMessage& error) {
    return broke_rules(error.what());
  }
}

// Holds a request that is not answered yet: `depth` calls of provided functions wait for callbacks.
struct Student::Conversation {
  std::uint64_t nonce;
  const Products& products;
  double spent_before;
  double wall_before;
  double cpu_before = timing::process_cpu_seconds();
  timing::Stopwatch watch = {};
  bool stopping = false;
  int depth = 0;
};

Answer Student::ask(const MessageWriter& request, const Products& products) {
  provided_solves_.clear();
  if (recording_ == nullptr || gave_up_) return ask_worker(request, products);
  recording_->begin(request);
  Answer answer = ask_worker(request, [&](int which, const std::vector<double>& x, std::vector<double>& y) {
    const bool go_on = products(which, x, y);
    recording_->add_product(which, x, y, go_on);
    return go_on;
  });
  recording_->end(answer.outcome, answer.reply);
  return answer;
}

void Student::begin_case() {
  if (recording_ != nullptr) recording_->begin_case();
}

Answer Student::ask_worker(const MessageWriter& request, const Products& products) {
  Conversation conversation{random_nonce(), products, setup_.allowance->spent.suite_cpu_seconds,
                            setup_.allowance->spent.wall_seconds};
  auto answer = [&]() -> Answer {
    if (gave_up_) return *gave_up_;
    if (!worker_)
      if (std::optional<Answer> failure = start()) return *failure;
    try {
      return converse(request, conversation);
    } catch (const MalformedMessage& error) {
      return broke_rules(error.what());
    }
  }();
  charge(conversation);
  return answer;
}

void Student::charge(const Conversation& conversation) {
  setup_.allowance->spent.suite_cpu_seconds =
      conversation.spent_before + timing::process_cpu_seconds() - conversation.cpu_before;
  setup_.allowance->spent.wall_seconds = conversation.wall_before + conversation.watch.seconds();
}

// A worker that breaks the protocol gets no more requests; a new one may.
Answer Student::broke_rules(const std::string& how) {
  end(0);
  last_failure_ = Outcome::broke_rules;
  return {Outcome::broke_rules, MessageReader({}), how};
}

// Ends a conversation, however deep in calls and callbacks it is.
struct Student::Over {
  Answer answer;
};

Answer Student::converse(const MessageWriter& request, Conversation& conversation) {
  if (!tell(Kind::request, conversation.nonce, request.bytes())) return ended("before the request");
  try {
    return {Outcome::done, listen(conversation, Kind::done), {}};
  } catch (Over& over) {
    return std::move(over.answer);
  }
}

// Returns the next message of the kind `until`, and answers all requests of the worker before it.
MessageReader Student::listen(Conversation& conversation, Kind until) {
  for (;;) {
    std::optional<Message> message = receive();
    if (!message) {
      Answer answer = ended(kAsking);
      // Our exception to stop it ends the process if the exception leaves a thread.
      forgiven_ = conversation.stopping && answer.outcome == Outcome::crashed;
      if (forgiven_) answer = {Outcome::stopped, MessageReader({}), {}};
      throw Over{std::move(answer)};
    }
    charge(conversation);
    if (give_up_if_used_up()) {
      end(0);
      throw Over{*gave_up_};
    }
    if (message->nonce != conversation.nonce) throw MalformedMessage("a message for another request");
    MessageReader body(std::move(message->body));
    if (message->kind == until) return body;
    switch (message->kind) {
      case Kind::product:
        serve_product(conversation, body);
        break;
      case Kind::call:
        serve_call(conversation, std::move(body));
        break;
      case Kind::callback_threw:
        if (conversation.depth > 0) throw CallbackThrew();
        throw MalformedMessage("an exception of a callback, but no callback runs");
      case Kind::denied:
        throw Over{broke_rules("it tried " + std::string(denied_syscall(body.get<int>())))};
      case Kind::stopped:
        throw Over{{Outcome::stopped, MessageReader({}), {}}};
      case Kind::not_implemented:
        throw Over{{Outcome::not_implemented, MessageReader({}), body.get_text()}};
      case Kind::threw:
        throw Over{{Outcome::threw, MessageReader({}), body.get_text()}};
      case Kind::out_of_memory:
        throw Over{{Outcome::out_of_memory, MessageReader({}), {}}};
      case Kind::left:
        throw Over{left(kAsking, body.get<int>())};
      default:
        throw MalformedMessage("a message of kind " +
                               std::to_string(static_cast<std::uint32_t>(message->kind)));
    }
  }
}

void Student::serve_product(Conversation& conversation, MessageReader& asked) {
  if (conversation.stopping) throw MalformedMessage("a product after the request was stopped");
  const int which = asked.get<int>();
  const std::vector<double> x = asked.get_doubles();
  asked.expect_end();
  std::vector<double> y;
  conversation.stopping = !conversation.products(which, x, y);
  MessageWriter result;
  result.put(std::span<const double>(y));
  if (!tell(conversation.stopping ? Kind::stop : Kind::product_result, conversation.nonce, result.bytes()))
    throw Over{ended("during a product")};
}

// Calls a function of a prerequisite, which may call the worker about its own objects.
void Student::serve_call(Conversation& conversation, MessageReader call) {
  if (conversation.stopping) throw MalformedMessage("a call after the request was stopped");
  if (conversation.depth == kMostCalls) throw MalformedMessage(kNestedCalls);
  const auto send = [&](Kind kind, const MessageWriter& body) {
    if (!tell(kind, conversation.nonce, body.bytes())) throw Over{ended("during a call")};
  };
  Recording::GivenCall* const recorded = recording_ != nullptr ? recording_->begin_call(call) : nullptr;
  const Products callback = [&](int which, const std::vector<double>& x, std::vector<double>& y) {
    if (recorded != nullptr) recorded->callbacks.emplace_back(which, x);
    MessageWriter question;
    send(Kind::callback, question.put(which).put(std::span<const double>(x)));
    MessageReader answer = listen(conversation, Kind::callback_result);
    y = answer.get_doubles();
    answer.expect_end();
    return true;
  };
  ++conversation.depth;
  try {
    const MessageWriter result =
        provide(setup_.provided, std::move(call), conversation.products, callback, provided_solves_);
    --conversation.depth;
    if (recorded != nullptr) recorded->result = MessageReader(result.bytes());
    send(Kind::call_result, result);
  } catch (const CallbackThrew&) {
    --conversation.depth;
  } catch (const StoppedCall&) {
    --conversation.depth;
    conversation.stopping = true;
    send(Kind::stop, {});
  }
}

// The worker has reported its exit code; the kernel's report would look like a signal.
Answer Student::left(const std::string& during, int code) {
  end(1);
  last_failure_ = Outcome::crashed;
  return {Outcome::crashed, MessageReader({}), during + ": it left with code " + std::to_string(code)};
}

// The worker is gone, or not worth waiting for. Reports how, and gives up after too many.
Answer Student::ended(const std::string& during) {
  // A worker that has closed its pipes may still run, or wait for a processor before it leaves. An ended
  // process shows no idling.
  worker_->watchdog.wait_for_end(setup_.allowance->wall_seconds_left());
  const char* why = worker_->watchdog.why();
  const bool may_be_out_of_cpu_time = worker_->watchdog.most_cpu_seconds() >= worker_->cpu_seconds;
  const Ending ending = end(0);

  Answer answer{Outcome::crashed, MessageReader({}), during};
  if (ending.out_of_memory) {
    answer.outcome = Outcome::out_of_memory;
  } else if (ending.timed_out || (ending.signal == SIGKILL && may_be_out_of_cpu_time)) {
    answer.outcome = Outcome::timed_out;
    answer.note += std::string(": ") + (why != nullptr ? why : "out of CPU time");
    ++timeouts_;
  } else if (ending.signal == SIGSYS) {
    answer.outcome = Outcome::broke_rules;
    answer.note = "it tried " + std::string(denied_syscall(-1));  // signal masks can hide the call
  } else if (ending.signal == SIGKILL) {
    answer.note += ": killed, but not by a time limit of the grader";
  } else {
    answer.note += ending.signal != 0 ? ": signal " + std::to_string(ending.signal)
                                      : ": it left with code " + std::to_string(ending.code);
  }
  last_failure_ = answer.outcome;
  if (timeouts_ >= kMostTimeouts) gave_up_ = answer;
  return answer;
}

std::optional<double> Student::worker_cpu_seconds() const {
  if (!worker_) return {};
  return worker_->process.activity().cpu_seconds;
}

void Student::finish() {
  if (!worker_) return;
  const timing::Stopwatch watch;
  worker_->requests.write_end.close();
  end(1);
  setup_.allowance->spent.wall_seconds += watch.seconds();
}

}  // namespace grader::judge
