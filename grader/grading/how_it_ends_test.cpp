// STAFF ONLY. Tests that the reported end of a program has the right cause, whatever the C library makes of
// it: a table of functions that the system call filter stops, and one of other ends.
#include <gtest/gtest.h>

#include <string>

#include "grader/compile/compiler.h"
#include "grader/grading/settings_for_tests.h"
#include "grader/judge/student/student.h"
#include "grader/sandbox/isolation_for_tests.h"
#include "reference/S1/calls.h"

namespace grader::inline grading {
namespace {

struct Way {
  const char* code;
  Outcome outcome;
  const char* note;  // is for staff
};

constexpr const char* kHeaders[] = {
    "csignal",        "cstdio",       "cstdlib",     "dirent.h",     "fcntl.h", "filesystem", "fstream",
    "grp.h",          "netdb.h",      "poll.h",      "pthread.h",    "pwd.h",   "sched.h",    "spawn.h",
    "stdexcept",      "syslog.h",     "sys/prctl.h", "sys/ptrace.h", "thread",  "unistd.h",   "wordexp.h",
    "sys/resource.h", "sys/socket.h", "sys/stat.h",  "ctime",        "random",  "setjmp.h"};

constexpr const char* kProcess = "it tried to start another process";
constexpr const char* kFile = "it tried to change or create a file";
constexpr const char* kNetwork = "it tried to open a network connection";
constexpr const char* kOther = "it tried to look into or stop another process";
constexpr const char* kLimits = "it tried to change the limits that it runs under";
constexpr const char* kMachine = "it tried to change the machine";

// Around some of these the C library blocks signals, makes other calls in their place, or ignores their
// failure.
constexpr Way kStopped[] = {
    {"std::system(\"pause\");", Outcome::broke_rules, kProcess},
    {"std::system(nullptr);", Outcome::broke_rules, kProcess},
    {"popen(\"ls\", \"r\");", Outcome::broke_rules, kProcess},
    {"char* none[] = {nullptr}; pid_t p; posix_spawn(&p, \"/bin/ls\", nullptr, nullptr, none, none);",
     Outcome::broke_rules, kProcess},
    {"char* none[] = {nullptr}; pid_t p; posix_spawnp(&p, \"ls\", nullptr, nullptr, none, none);",
     Outcome::broke_rules, kProcess},
    {"fork();", Outcome::broke_rules, kProcess},
    {"if (vfork() == 0) _exit(0);", Outcome::broke_rules, kProcess},
    {"execl(\"/bin/ls\", \"ls\", nullptr);", Outcome::broke_rules, kProcess},
    {"wordexp_t words; wordexp(\"$(ls)\", &words, 0);", Outcome::broke_rules, kProcess},
    {"daemon(0, 0);", Outcome::broke_rules, kProcess},
    {"fopen(\"log.txt\", \"w\");", Outcome::broke_rules, kFile},
    {"std::ofstream(\"log.txt\") << 1;", Outcome::broke_rules, kFile},
    {"freopen(\"log.txt\", \"w\", stdout);", Outcome::broke_rules, kFile},
    {"tmpfile();", Outcome::broke_rules, kFile},
    {"char name[] = \"/tmp/XXXXXX\"; mkstemp(name);", Outcome::broke_rules, kFile},
    {"std::remove(\"log.txt\");", Outcome::broke_rules, kFile},
    {"std::rename(\"a\", \"b\");", Outcome::broke_rules, kFile},
    {"std::error_code e; std::filesystem::create_directory(\"a\", e);", Outcome::broke_rules, kFile},
    {"chmod(\"a\", 0600);", Outcome::broke_rules, kFile},
    {"socket(AF_INET, SOCK_STREAM, 0);", Outcome::broke_rules, kNetwork},
    {"addrinfo* a; getaddrinfo(\"localhost\", nullptr, nullptr, &a);", Outcome::broke_rules, kNetwork},
    {"syslog(LOG_ERR, \"x\");", Outcome::broke_rules, kNetwork},
    {"sigset_t all; sigfillset(&all); sigprocmask(SIG_BLOCK, &all, nullptr); socket(AF_INET, SOCK_STREAM, "
     "0);",
     Outcome::broke_rules, kNetwork},
    {"sigset_t all; sigfillset(&all); pthread_sigmask(SIG_SETMASK, &all, nullptr); fork();",
     Outcome::broke_rules, kProcess},
    {"std::raise(SIGTERM);", Outcome::broke_rules, kOther},
    {"kill(getpid(), SIGKILL);", Outcome::broke_rules, kOther},
    {"pthread_kill(pthread_self(), SIGUSR1);", Outcome::broke_rules, kOther},
    {"ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);", Outcome::broke_rules, kOther},
    {"rlimit none{}; setrlimit(RLIMIT_CORE, &none);", Outcome::broke_rules, kLimits},
    {"std::signal(SIGSYS, SIG_IGN);", Outcome::broke_rules, kLimits},
    {"prctl(PR_SET_NAME, \"x\");", Outcome::broke_rules, kLimits},
    {"chroot(\"/\");", Outcome::broke_rules, kMachine},
    {"unshare(CLONE_NEWUSER);", Outcome::broke_rules, kMachine},
    // These fail without harm or work, so they are not reported.
    {"alarm(1); dup(1); pollfd f{}; poll(&f, 1, 0); opendir(\"/\"); access(\"/\", R_OK); "
     "nice(1);",
     Outcome::done, ""},
    {"int sum = 0; std::thread([&] { sum = 1; }).join(); if (sum != 1) abort();", Outcome::done, ""},
    {"std::printf(\"%d\\n\", isatty(1)); std::ifstream(\"none\").get(); getenv(\"HOME\"); time_t t = "
     "time(nullptr); "
     "localtime(&t); std::random_device()(); usleep(10);",
     Outcome::done, ""},
    {"sigset_t one, old, now; sigemptyset(&one); sigaddset(&one, SIGUSR1); sigaddset(&one, SIGSYS); "
     "sigprocmask(SIG_BLOCK, &one, &old); sigprocmask(SIG_BLOCK, nullptr, &now); "
     "if (sigismember(&old, SIGUSR1) || !sigismember(&now, SIGUSR1) || sigismember(&now, SIGSYS)) abort(); "
     "sigprocmask(SIG_UNBLOCK, &one, nullptr); sigprocmask(SIG_SETMASK, nullptr, &now); "
     "if (sigismember(&now, SIGUSR1)) abort(); sigprocmask(SIG_SETMASK, &one, nullptr); "
     "sigprocmask(SIG_SETMASK, &old, &now); if (!sigismember(&now, SIGUSR1)) abort();",
     Outcome::done, ""},
    {"sigjmp_buf place; volatile int times = 0; if (sigsetjmp(place, 1) < 3) siglongjmp(place, ++times);",
     Outcome::done, ""},
};

// A clock, a limit and a signal are named only if they are the cause.
constexpr Way kEnds[] = {
    {"_exit(137);", Outcome::crashed, "during the request: it left with code 137"},
    {"_exit(152);", Outcome::crashed, "during the request: it left with code 152"},
    {"_exit(3);", Outcome::crashed, "during the request: it left with code 3"},
    {"std::exit(-1);", Outcome::crashed, "during the request: it left with code 255"},
    {"std::quick_exit(159);", Outcome::crashed, "during the request: it left with code 159"},
    {"std::abort();", Outcome::crashed, "during the request: signal 6"},
    {"std::thread([] { throw 1; }).join();", Outcome::crashed, "during the request: signal 6"},
    {"void* volatile p = std::malloc(64); std::free(p); std::free(p);", Outcome::crashed,
     "during the request: signal 6"},
    {"*(volatile int*)nullptr = 1;", Outcome::crashed, "during the request: signal 11"},
    {"volatile int zero = 0; *steps = 7 / zero;", Outcome::crashed, "during the request: signal 8"},
    {"__builtin_trap();", Outcome::crashed, "during the request: signal 4"},
    {"throw std::runtime_error(\"x\");", Outcome::threw, "x"},
    {"for (volatile bool on = true; on;) {}", Outcome::timed_out, "during the request: out of CPU time"},
    {"signal(SIGXCPU, SIG_IGN); for (volatile bool on = true; on;) {}", Outcome::timed_out,
     "during the request: out of CPU time"},
    {"sleep(1000);", Outcome::timed_out, "during the request: asleep"},
#if defined(__x86_64__)
    {"syscall(0x40000000 + 39);", Outcome::broke_rules, "it tried something that is not allowed"},  // x32
#endif
};

class HowItEnds : public testing::Test {
 protected:
  HowItEnds() { settings_.cache = HAIR_TEST_CACHE; }

  // Makes a ConjGrad that does row number `steps` of a table.
  template <std::size_t n>
  std::filesystem::path compiled(const Way (&ways)[n]) const {
    std::string source = "#include \"solver/linearSolver.h\"\n";
    for (const char* header : kHeaders) source += std::string("#include <") + header + ">\n";
    source +=
        "double ConjGrad(int, implicitMatrix*, double[], double[], double, int* steps) {\n  switch (*steps) "
        "{\n";
    for (std::size_t i = 0; i < n; ++i)
      source += "    case " + std::to_string(i) + ": {\n      " + ways[i].code + "\n      break;\n    }\n";
    source += "  }\n  return 0;\n}\n";
    const Compiled object =
        compiler_.compile(s1_, source, kit_.new_job("job-" + std::to_string(jobs_++)), 200);
    EXPECT_FALSE(object.object.empty()) << object.log;
    return object.object;
  }

  // Returns the answer of a worker with this object for n = 4 and the identity.
  Answer ask(const std::filesystem::path& object, int way) const {
    WorkerSetup setup;
    setup.kit = kit_.folder();
    setup.exercise = "S1";
    setup.objects = {object};
    setup.isolation = isolation_for_tests();
    setup.log = "/dev/null";
    setup.cpu_seconds = 1;
    setup.allowance->limit.idle_seconds = 1;
    Student student(setup);
    const std::vector<double> values = {1, 2, 3, 4};
    MessageWriter request;
    request.put(s1::Calls::number_of<s1::conj_grad>()).put(0).put(4).put(4);  // operator 0 and its size
    request.put(std::span<const double>(values)).put(std::span<const double>(values)).put(1e-10).put(way);
    return student.ask(request, [](int, const std::vector<double>& v, std::vector<double>& y) {
      y = v;
      return true;
    });
  }

  template <std::size_t n>
  void expect_told(const Way (&ways)[n]) {
    const std::filesystem::path object = compiled(ways);
    for (std::size_t i = 0; i < n; ++i) {
      SCOPED_TRACE(ways[i].code);
      const Answer answer = ask(object, static_cast<int>(i));
      EXPECT_EQ(answer.outcome, ways[i].outcome);
      EXPECT_EQ(answer.note, ways[i].note);
    }
  }

  GradingSettings settings_ = settings_for_tests();
  const Exercise& s1_ = *settings_.course.find("S1");
  const StagedKit kit_{settings_.kit, settings_.course};
  const Compiler compiler_{kit_, HAIR_TEST_CACHE, isolation_for_tests()};
  mutable int jobs_ = 0;
};

TEST_F(HowItEnds, EachStoppedCallIsToldByItsIntention) {
  expect_told(kStopped);
}

TEST_F(HowItEnds, ClocksAndSignalsAreNamedWhereItWasOne) {
  expect_told(kEnds);
}

}  // namespace
}  // namespace grader::grading
