// STAFF ONLY. A process that idles in a way of its own, for the watchdog's test: `idler vfork`, its main thread waits for a
// child that shares its memory; `idler naps`, it sleeps a hundredth of a second again and again.
#include <unistd.h>

#include <string_view>

int main(int argc, char* argv[]) {
  if (argc < 2) return 2;
  if (argv[1] == std::string_view("naps"))
    for (;;) usleep(10000);
  if (vfork() == 0) {
    sleep(1000);
    _exit(0);
  }
}
