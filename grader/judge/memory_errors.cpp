// STAFF ONLY. Asks the recorded questions again of a worker with sanitizers.
#include "grader/judge/memory_errors.h"

#include <algorithm>

#include "grader/judge/run/whole_run.h"
#include "grader/wire/memory_error.h"

namespace grader::inline judge {
namespace {

Budget rest_of(const Allowance& allowance) {
  Budget rest;
  for (const BudgetField& field : budget_fields())
    rest.*field.value = std::max(0.0, allowance.limit.*field.value - allowance.spent.*field.value);
  return rest;
}

WorkerSetup sanitised_worker(const WorkerSetup& cases, const std::filesystem::path& object) {
  WorkerSetup setup = cases;
  setup.sanitised = true;
  setup.objects.back() = object;
  setup.log += kSanitisedLog;
  setup.allowance = std::make_shared<Allowance>();
  return setup;
}

bool only_restarts_are_used_up(const Allowance& allowance) {
  Budget others = allowance.spent;
  others.restarts = 0;
  return used_up(allowance.spent, allowance.limit) != nullptr && used_up(others, allowance.limit) == nullptr;
}

// True if the program or its function has ended without an answer.
bool broke_off(Outcome outcome) {
  return outcome == Outcome::crashed || outcome == Outcome::threw || outcome == Outcome::broke_rules ||
         outcome == Outcome::cannot_load;
}

}  // namespace

MemoryErrors::MemoryErrors(const WorkerSetup& worker, std::filesystem::path object,
                           std::vector<Student*> earlier, const Recording& recording,
                           std::function<bool()> anything_right)
    : paying_(worker.allowance),
      object_(std::move(object)),
      earlier_(std::move(earlier)),
      recording_(recording),
      anything_right_(std::move(anything_right)),
      setup_(sanitised_worker(worker, object_)),
      student_(setup_) {}

Category MemoryErrors::category(const std::string& exercise) {
  return category_of(exercise, "Memory", [this](Trial& trial) { look(trial); });
}

void MemoryErrors::tell(Trial& trial, const std::string& sentence, const std::string& detail) {
  message_ = sentence;
  trial.fail(Status::wrong, sentence, detail);
}

void MemoryErrors::look(Trial& trial) {
  for (Student* student : earlier_) student->finish();
  // Code that never answers would use up its limits once more. Code that crashes too often is worth asking:
  // the sanitizers find the place.
  for (Student* student : earlier_) {
    if (!student->gave_up() || only_restarts_are_used_up(*paying_)) continue;
    if (student->gave_up()->outcome == Outcome::timed_out && student->spent().messages > kManyMessages)
      trial.fail(Status::wrong, "the run used up the limits, so memory errors were not looked for",
                 student->gave_up()->note);
    trial.reply_of(*student->gave_up());
  }
  // A file can make its own build with sanitizers meet a limit.
  if (object_.empty())
    trial.fail(Status::wrong,
               "compiling with sanitizers exceeded the limits of time or size, so memory errors were not "
               "looked for; "
               "leave out headers that the file does not need",
               {});
  setup_.allowance->limit = rest_of(*paying_);
  setup_.allowance->wakeup_seconds = paying_->wakeup_seconds;
  ask_all(trial);
}

void MemoryErrors::ask_all(Trial& trial) {
  // Charges the worker's costs in any case.
  struct Charge {
    Student& student;
    Allowance &from, &to;
    ~Charge() {
      student.finish();
      for (const BudgetField& field : budget_fields()) to.spent.*field.value += from.spent.*field.value;
    }
  } const charge{student_, *setup_.allowance, *paying_};

  bool implemented = false;
  for (const Recording::Request& request : recording_.requests()) {
    trial.describe("asked for \"" + request.category + "\"");
    std::size_t next = 0;
    const auto products = [&](int which, const std::vector<double>&, std::vector<double>& y) {
      if (next == request.products.size() || request.products[next].which != which) return false;
      y = request.products[next].result;
      return request.products[next++].go_on;
    };
    Answer answer = student_.ask(request.message, products);
    implemented |= answer.outcome != Outcome::not_implemented;
    if (answer.outcome == Outcome::memory_error) {
      const MemoryErrorKind& error = read_memory_error(answer.reply);
      if (answer.note.empty()) call_ = MessageReader(request.message.bytes()).get<int>();
      tell(trial, std::string("The code ") + error.shown, std::string(error.runtime));
    }
    if (broke_off(answer.outcome) && !broke_off(request.outcome))
      tell(trial,
           "The code breaks off with sanitizers, but not without them: it may use a variable that has no "
           "value yet",
           answer.note);
    if (answer.outcome == Outcome::timed_out || answer.outcome == Outcome::out_of_memory) break;
  }
  trial.describe("all requests");
  if (!implemented) trial.fail(Status::not_implemented, "not implemented yet", {});
  trial.expect(anything_right_(),
               "no memory error was found, which counts only once another category passes");
}

}  // namespace grader::judge
