// STAFF ONLY. A process that idles, for the watchdog's test. `idler vfork`: its main thread waits for a child
// that shares its memory. `idler naps`: it sleeps for a hundredth of a second, again and again. `idler
// chatters`: it writes a letter to descriptor 4 after each of its short naps.
#include <unistd.h>

#include <string_view>

int main(int argc, char* argv[]) {
  if (argc < 2) return 2;
  const std::string_view way = argv[1];
  if (way == "naps")
    for (;;) usleep(10000);
  if (way == "chatters")
    for (;;) {
      usleep(1);
      if (write(4, "x", 1) != 1) return 1;
    }
  if (vfork() == 0) {
    sleep(1000);
    _exit(0);
  }
}
