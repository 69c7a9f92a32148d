// STAFF ONLY.
#include "grader/suite/student.h"

#include <fcntl.h>
#include <signal.h>
#include <sodium.h>

#include <cerrno>
#include <memory>

namespace grader {
namespace {

// Larger than any array that a case sends; a worker that announces more has broken the protocol.
constexpr std::size_t kLargestMessage = std::size_t{8} << 20;

std::uint64_t random_nonce() {
  std::uint64_t nonce;
  randombytes_buf(&nonce, sizeof nonce);
  return nonce;
}

Cage worker_cage(const WorkerSetup& setup) {
  Cage cage;
  cage.mounts = runtime_library_mounts();
  cage.mounts.push_back({setup.kit / "worker", "/worker"});
  cage.mounts.push_back({setup.kit / "serve" / (setup.exercise + ".so"), "/server.so"});
  for (std::size_t i = 0; i < setup.objects.size(); ++i)
    cage.mounts.push_back({setup.objects[i], "/objects/" + setup.objects[i].filename().string()});
  cage.isolated = setup.isolated;
  cage.limits.cpu_seconds = setup.cpu_seconds;
  return cage;
}

std::vector<std::string> worker_command(const WorkerSetup& setup, const Limits& limits) {
  std::vector<std::string> command = {"/worker", std::to_string(limits.cpu_seconds),
                                      std::to_string(limits.memory_bytes), std::to_string(limits.processes)};
  for (const auto& object : setup.objects) command.push_back("/objects/" + object.filename().string());
  command.push_back("/server.so");
  return command;
}

}  // namespace

struct Student::Worker {
  Pipe requests = make_pipe(), replies = make_pipe();
  Descriptor log;
  CagedProcess process;
  Watchdog watchdog;
  Channel channel;

  Worker(const WorkerSetup& setup, const Cage& cage)
      : log(open(setup.log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)),
        process(cage, worker_command(setup, cage.limits), requests.read_end.get(), replies.write_end.get(),
                log.get()),
        watchdog(process, setup.patience),
        channel(replies.read_end.get(), requests.write_end.get(),
                [this](int descriptor, short events) { return watchdog.wait_for(descriptor, events); }) {
    requests.read_end.close();
    replies.write_end.close();
    fcntl(requests.write_end.get(), F_SETFL, O_NONBLOCK);
    // Fewer turns for large vectors; refused, the usual size does.
    fcntl(requests.write_end.get(), F_SETPIPE_SZ, 1 << 18);
    fcntl(replies.read_end.get(), F_SETPIPE_SZ, 1 << 18);
  }
};

std::optional<Answer> Student::start() {
  if (gave_up_) return gave_up_;
  ++starts_;
  const Cage cage = worker_cage(setup_);
  worker_ = std::make_shared<Worker>(setup_, cage);
  try {
    const std::optional<Message> message = worker_->channel.receive(kLargestMessage);
    if (!message) return ended("while the code was loaded");
    if (message->kind == Kind::hello) return {};
    if (message->kind == Kind::denied) {
      Answer answer = ended("while the code was loaded");
      answer.outcome = Outcome::broke_rules;
      return answer;
    }
    if (message->kind == Kind::cannot_load) {
      gave_up_ = Answer{Outcome::cannot_load, MessageReader({}), MessageReader(message->body).get_text()};
      finish();
      return gave_up_;
    }
    throw MalformedMessage("something else than a greeting");
  } catch (const MalformedMessage& error) {
    return broke_rules(error);
  }
}

Answer Student::ask(const MessageWriter& request, const Products& products) {
  if (!worker_)
    if (std::optional<Answer> failure = start()) return *failure;
  try {
    return converse(request, products);
  } catch (const MalformedMessage& error) {
    return broke_rules(error);
  }
}

// A worker that does not keep to the protocol is not asked again; a new one may be.
Answer Student::broke_rules(const MalformedMessage& error) {
  finish();
  const Answer answer{Outcome::broke_rules, MessageReader({}), error.what()};
  if (starts_ > kMostRestarts) gave_up_ = answer;
  return answer;
}

Answer Student::converse(const MessageWriter& request, const Products& products) {
  const std::uint64_t nonce = random_nonce();
  std::optional<int> denied;
  bool stopping = false;
  auto finished = [&](Outcome outcome, MessageReader reply, const std::string& note = {}) {
    if (denied)
      return Answer{Outcome::broke_rules, MessageReader({}),
                    std::string("it tried ") + denied_syscall(*denied)};
    return Answer{outcome, std::move(reply), note};
  };

  if (!worker_->channel.send(Kind::request, nonce, request.bytes())) return ended("before the request");
  for (;;) {
    std::optional<Message> message = worker_->channel.receive(kLargestMessage);
    if (!message) {
      Answer answer = ended("during the request");
      if (denied) answer.outcome = Outcome::broke_rules;
      return answer;
    }
    if (message->nonce != nonce) throw MalformedMessage("a message for another request");
    MessageReader body(std::move(message->body));
    switch (message->kind) {
      case Kind::product: {
        if (stopping) throw MalformedMessage("a product after the request was stopped");
        const int which = body.get<int>();
        const std::vector<double> x = body.get_doubles();
        body.expect_end();
        std::vector<double> y;
        stopping = !products(which, x, y);
        MessageWriter result;
        result.put(std::span<const double>(y));
        if (!worker_->channel.send(stopping ? Kind::stop : Kind::product_result, nonce, result.bytes()))
          return ended("during a product");
        break;
      }
      case Kind::denied:
        denied = body.get<int>();
        break;
      case Kind::done:
        return finished(Outcome::done, std::move(body));
      case Kind::stopped:
        return finished(Outcome::stopped, MessageReader({}));
      case Kind::not_implemented:
        return finished(Outcome::not_implemented, MessageReader({}), body.get_text());
      case Kind::threw:
        return finished(Outcome::threw, MessageReader({}), body.get_text());
      case Kind::out_of_memory:
        return finished(Outcome::out_of_memory, MessageReader({}));
      default:
        throw MalformedMessage("a message of kind " +
                               std::to_string(static_cast<std::uint32_t>(message->kind)));
    }
  }
}

// The worker is gone, or asleep for good. Says how, and gives up after too many.
Answer Student::ended(const std::string& during) {
  const bool asleep = worker_->watchdog.waited_in_vain();
  // A worker that has closed its pipes may still run.
  const Ending ending = worker_->process.wait(asleep ? 0 : 1);
  worker_.reset();

  Answer answer{Outcome::crashed, MessageReader({}), during};
  if (ending.out_of_memory) {
    answer.outcome = Outcome::out_of_memory;
  } else if (ending.timed_out) {
    answer.outcome = Outcome::timed_out;
    answer.note += asleep ? ": asleep" : ": out of CPU time";
    ++timeouts_;
  } else if (ending.signal == SIGSYS) {
    answer.outcome = Outcome::broke_rules;
  } else {
    answer.note += ending.signal != 0 ? ": signal " + std::to_string(ending.signal)
                                      : ": it left with code " + std::to_string(ending.code);
  }
  if (starts_ > kMostRestarts || timeouts_ >= kMostTimeouts) gave_up_ = answer;
  return answer;
}

std::optional<double> Student::worker_cpu_seconds() const {
  if (!worker_) return {};
  return worker_->process.activity().cpu_seconds;
}

void Student::finish() {
  if (!worker_) return;
  cpu_seconds_ += worker_->process.activity().cpu_seconds;
  worker_->requests.write_end.close();
  worker_->process.wait(1);
  worker_.reset();
}

}  // namespace grader
