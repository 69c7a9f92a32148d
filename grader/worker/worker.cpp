// STAFF ONLY. The program that runs student code: it limits itself and its system calls, loads the given
// objects and answers requests on descriptor 3 through descriptor 4.
//
//   hairworker CPU_SECONDS MEMORY_BYTES THREADS OBJECT... SERVER
//
// MEMORY_BYTES limits the address space. THREADS limits the threads of its user; 0: a control group alone may
// bound them. Objects are loaded in their order, each finding the functions of those before it. Nothing here
// is trusted after they are loaded.
#include <dlfcn.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "grader/sandbox/system_calls/syscalls.h"
#include "grader/worker/session.h"
#include "solver/not_implemented.h"

namespace grader::inline worker {
namespace {

constexpr int kIn = 3, kOut = 4;
constexpr std::size_t kLargestRequest = std::size_t{256} << 20;

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit value{soft, hard};
  if (setrlimit(resource, &value) != 0) _exit(120);
}

// Belongs to the present request, for events in the middle of student code.
std::uint64_t current_nonce = 0;

// Reports to the suite a system call that student code never needs, or an exit code.
template <Kind kind>
void tell(int number) {
  MessageWriter message;
  Channel(kIn, kOut).send(kind, current_nonce, message.put(number).bytes());
}

void lock_down(int cpu_seconds, rlim_t memory, rlim_t threads) {
  if (syscall(SYS_close_range, kOut + 1, ~0U, 0U) != 0) _exit(120);
  limit(RLIMIT_CPU, cpu_seconds, cpu_seconds + 1);
  limit(RLIMIT_AS, memory, memory);
  if (threads > 0) limit(RLIMIT_NPROC, threads, threads);
  limit(RLIMIT_FSIZE, 1 << 20, 1 << 20);  // standard output is a file
  limit(RLIMIT_NOFILE, 32, 32);
  limit(RLIMIT_CORE, 0, 0);
  signal(SIGXFSZ, SIG_IGN);
  signal(SIGPIPE, SIG_IGN);
  prctl(PR_SET_DUMPABLE,
        0);  // a core pattern may be a program, which takes a core and time in any case
  hear_of_stopped_calls(tell<Kind::denied>, tell<Kind::left>);
  restrict_syscalls(Syscalls::worker);
}

void send_text(Channel& channel, Kind kind, std::uint64_t nonce, const char* text) {
  MessageWriter message;
  message.put(std::string(text).substr(0, 1000));
  channel.send(kind, nonce, message.bytes());
}

// Holds loaded objects: the server, and the variables of provided functions that point to the session.
struct Loaded {
  Server serve = nullptr;
  std::vector<ProvidedSession*> provided;
};

Loaded load(Channel& channel, int count, char* files[]) {
  Loaded loaded;
  void* object = nullptr;
  for (int i = 0; i < count; ++i) {
    object = dlopen(files[i], RTLD_NOW | (i + 1 < count ? RTLD_GLOBAL : RTLD_LOCAL));
    if (object == nullptr) {
      send_text(channel, Kind::cannot_load, 0, dlerror());
      _exit(0);
    }
    if (void* session = dlsym(object, kProvidedSessionName))
      loaded.provided.push_back(static_cast<ProvidedSession*>(session));
  }
  loaded.serve = reinterpret_cast<Server>(dlsym(object, kServerName));
  return loaded;
}

void answer(Channel& channel, const Loaded& loaded, Message& request) {
  const std::uint64_t nonce = request.nonce;
  try {
    Session session(channel, nonce, MessageReader(std::move(request.body)));
    for (ProvidedSession* provided : loaded.provided) *provided = &session;
    loaded.serve(session);
    channel.send(Kind::done, nonce, session.reply.bytes());
  } catch (const Stopped&) {
    channel.send(Kind::stopped, nonce);
  } catch (const NotImplemented& error) {
    send_text(channel, Kind::not_implemented, nonce, error.what());
  } catch (const std::bad_alloc&) {
    channel.send(Kind::out_of_memory, nonce);
  } catch (const std::exception& error) {
    send_text(channel, Kind::threw, nonce, error.what());
  } catch (...) {
    send_text(channel, Kind::threw, nonce, "something that is no std::exception");
  }
}

void serve_requests(int count, char* files[]) {
  Channel channel(kIn, kOut);
  const Loaded loaded = load(channel, count, files);
  channel.send(Kind::hello, 0);
  while (std::optional<Message> request = channel.receive(kLargestRequest)) {
    current_nonce = request->nonce;
    answer(channel, loaded, *request);
  }
  _exit(0);  // skips the student's destructors
}

}  // namespace
}  // namespace grader::worker

int main(int argc, char* argv[]) {
  using namespace grader;
  if (argc < 5) return 2;
  lock_down(std::atoi(argv[1]), std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  serve_requests(argc - 4, argv + 4);
}
