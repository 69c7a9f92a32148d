// hairlab's studies refuse bad input, as seen from outside: in one line, before they compute, and without
// leaving files.
#include <gtest/gtest.h>

#include <sstream>
#include <string_view>

#include "hair/lab/tests/run_hairlab.h"
#include "hair/truth/accurate_motion.h"

namespace hair {
namespace {

struct Refused {
  const char* command;  // words; '' is an empty one. OUT is a folder below two that are not there
  const char* says;     // a part of the line
  const char* program = HAIRLAB;
};

const Refused kRefused[] = {
    {"stability strand-swing --out OUT --strand 1", "there is no strand 1"},
    {"stability FLOATING --out OUT", "nothing brings its strand back when it swings"},
    {"stability rigid-links --out OUT",
     "rigid-links: studies know no rigid_links; study a scene with hair of "},
    {"study", "SCENE is required"},
    {"study pendulum", "--out is required"},
    {"study ./head --out OUT", "./head"},
    {"study strand-swing --out OUT --methods leapfrog",
     "--methods: there is no \"leapfrog\"; there are forward-euler, "},
    {"study strand-swing --out OUT --methods ''", "--methods: there is no \"\"; "},
    {"study strand-swing --out OUT --strand 1", "there is no strand 1"},
    {"study strand-swing --out OUT --duration nan", "--duration: nan is not right; give 1e-6 to 1000"},
    {"study strand-swing --out OUT --duration 1001", "--duration: 1001 is not right; give 1e-6 to 1000"},
    {"study rigid-links --out OUT", "rigid-links: studies know no rigid_links; study a scene with hair of "},
    {"study head", "--out is required"},
    {"study head --out OUT --hair grey",
     "hairlab: --hair: there is no \"grey\"; there are straight, combed, wavy, curly\n"},
    {"study head --out OUT --exercise-strands 0", "--exercise-strands"},
    {"study head --out OUT --exercise-strands nan", "--exercise-strands"},
    {"study head --out OUT --duration 1", "--duration"},
    {"validate pendulum", "validate: there is no \"pendulum\"; there are published-numbers, "},
};

TEST(Studies, RefuseWhatIsNotThereInOneLine) {
  const TestFolder folder;
  const std::string floating = folder.write("floating.json", R"({"shows": "hair without weight", "frames": 3,
 "gravity": [0, 0, 0], "hair": [{"segments": 3, "length": 0.1, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})");
  const std::vector<std::string> before = folder.names();
  for (const Refused& one : kRefused) {
    SCOPED_TRACE(one.command);
    const std::string_view all = one.command;
    if (!have_accurate_motion() && all.starts_with("study ") && !all.starts_with("study head")) continue;
    std::vector<std::string> words;
    std::istringstream command(one.command);
    for (std::string word; command >> word;) {
      for (const auto& [name, meant] :
           {std::pair<std::string, std::string>{"OUT", (folder / "q/r/out").string()},
            {"FLOATING", floating},
            {"''", ""}})
        if (word.starts_with(name)) word.replace(0, name.size(), meant);
      words.push_back(word);
    }
    expect_refused(run_hairlab(words, {.program = one.program}), 2, one.says);
    EXPECT_EQ(folder.names(), before);
  }
}

}  // namespace
}  // namespace hair
