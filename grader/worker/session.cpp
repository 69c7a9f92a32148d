// STAFF ONLY. Receives requests, sends answers, and puts a guard page behind each buffer.
#include "grader/worker/session.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace grader::inline worker {
namespace {

constexpr std::size_t kLargestAnswer = std::size_t{256} << 20;

std::size_t page_size() {
  static const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return size;
}

// Keeps pages of freed buffers, the last one protected. A whole run needs the same few small buffers
// thousands of times, and mapping and protecting pages takes longer than most answers.
constexpr std::size_t kMostKept = 16;
std::vector<std::span<std::byte>> kept;

std::span<std::byte> take_pages(std::size_t bytes) {
  const auto found =
      std::find_if(kept.begin(), kept.end(), [&](const auto& pages) { return pages.size() == bytes; });
  if (found != kept.end()) {
    const std::span<std::byte> pages = *found;
    kept.erase(found);
    return pages;
  }
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  const std::span<std::byte> pages(static_cast<std::byte*>(memory), bytes);
  mprotect(pages.data() + bytes - page_size(), page_size(), PROT_NONE);
  return pages;
}

void keep_or_unmap(std::span<std::byte> pages) {
  if (pages.size() <= 4 * page_size() && kept.size() < kMostKept)
    kept.push_back(pages);
  else
    munmap(pages.data(), pages.size());
}

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

GuardedBuffer::GuardedBuffer(const std::vector<double>& values) {
  const std::size_t page = page_size(), bytes = values.size() * sizeof(double);
  const std::size_t usable = (bytes + page - 1) / page * page;
  pages_ = take_pages(usable + page);
  const std::span<std::byte> before = pages_.first(usable - bytes);
  std::fill(before.begin(), before.end(), std::byte{0});
  values_ = {reinterpret_cast<double*>(pages_.data() + before.size()), values.size()};
  std::copy(values.begin(), values.end(), values_.begin());
}

GuardedBuffer::~GuardedBuffer() {
  keep_or_unmap(pages_);
}

}  // namespace grader::worker
