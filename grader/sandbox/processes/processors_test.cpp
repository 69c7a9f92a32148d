// STAFF ONLY. Threads are bound to processors, and set free.
#include "grader/sandbox/processes/processors.h"

#include <gtest/gtest.h>

#include <thread>

namespace grader::inline sandbox {
namespace {

cpu_set_t allowed() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  return set;
}

TEST(Processors, BindAThreadToOneAsLongAsItHasALease) {
  const cpu_set_t before = allowed();
  Processors processors;
  {
    const Processors::Lease lease(processors);
    const cpu_set_t one = allowed();
    EXPECT_EQ(CPU_COUNT(&one), 1);
    EXPECT_TRUE(CPU_ISSET(sched_getcpu(), &one)) << "it is there already";
  }
  const cpu_set_t after = allowed();
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

TEST(Processors, ThreadsHaveTheirOwnAsLongAsThereAreEnough) {
  const cpu_set_t all = allowed();
  if (CPU_COUNT(&all) < 2) GTEST_SKIP() << "this machine has one processor";
  Processors processors;
  const Processors::Lease lease(processors);
  const cpu_set_t mine = allowed();
  for (int time = 0; time < 2; ++time)  // the first lease has ended by the second time
    std::jthread([&] {
      const Processors::Lease its(processors);
      const cpu_set_t other = allowed();
      EXPECT_EQ(CPU_COUNT(&other), 1);
      EXPECT_FALSE(CPU_EQUAL(&mine, &other)) << "two leases at a time have the same processor";
    });
}

}  // namespace
}  // namespace grader::sandbox
