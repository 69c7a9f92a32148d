// STAFF ONLY.
#include "grader/worker/session.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <new>

namespace grader {
namespace {

constexpr std::size_t kLargestAnswer = std::size_t{256} << 20;

}  // namespace

void Session::product(int which, std::span<const double> x, std::span<double> result) {
  MessageWriter message;
  message.put(which).put(x);
  if (!channel_.send(Kind::product, nonce_, message.bytes())) _exit(0);
  const std::vector<double> values =
      MessageReader(receive(result.size_bytes() + sizeof(std::uint64_t)).body).get_doubles(result.size());
  std::copy(values.begin(), values.end(), result.begin());
}

MessageReader Session::call(const MessageWriter& arguments, const Callback& callback) {
  if (!channel_.send(Kind::call, nonce_, arguments.bytes())) _exit(0);
  for (;;) {
    Message answer = receive(kLargestAnswer);
    MessageReader body(std::move(answer.body));
    if (answer.kind != Kind::callback) return body;
    const int which = body.get<int>();
    std::vector<double> x = body.get_doubles(), y;
    try {
      callback(which, x, y);
    } catch (...) {
      channel_.send(Kind::callback_threw, nonce_);
      throw;
    }
    MessageWriter result;
    result.put(std::span<const double>(y));
    if (!channel_.send(Kind::callback_result, nonce_, result.bytes())) _exit(0);
  }
}

// Without the suite there is nothing left to do.
Message Session::receive(std::size_t limit) {
  std::optional<Message> answer = channel_.receive(limit);
  if (!answer) _exit(0);
  if (answer->kind == Kind::stop) throw Stopped();
  return std::move(*answer);
}

void ServedMatrix::matVecMult(double x[], double b[]) {
  const std::less<const double*> before;
  if (before(x, b + rows_) && before(b, x + cols_)) ++mistakes_;
  session_.product(which_, {x, static_cast<std::size_t>(cols_)}, {b, static_cast<std::size_t>(rows_)});
}

GuardedBuffer::GuardedBuffer(const std::vector<double>& values) {
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t bytes = values.size() * sizeof(double);
  const std::size_t usable = (bytes + page - 1) / page * page;
  void* memory = mmap(nullptr, usable + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  pages_ = {static_cast<std::byte*>(memory), usable + page};
  mprotect(pages_.data() + usable, page, PROT_NONE);
  values_ = {reinterpret_cast<double*>(pages_.data() + (usable - bytes)), values.size()};
  std::copy(values.begin(), values.end(), values_.begin());
}

GuardedBuffer::~GuardedBuffer() {
  munmap(pages_.data(), pages_.size());
}

}  // namespace grader
