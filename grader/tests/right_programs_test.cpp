// STAFF ONLY. Tests the suite as a classifier: right programs lose no point. It compiles each sample that
// passes with several compilers, and runs it under several seeds: bounds must hold for every order of
// roundings. The environment's HAIR_SEEDS sets the number of seeds (as graded: 30; else 5),
// HAIR_REFERENCE_SEEDS the least number for the reference, HAIR_FIRST_SEED the first (0). Prints how near
// they come to the bounds. Objects and passes are kept by content: an interrupted test goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "grader/compile/hash.h"
#include "grader/compile/toolchain.h"
#include "grader/course/course.h"
#include "grader/samples/sample.h"
#include "grader/samples/solution_files.h"
#include "grader/sandbox/processes/processors.h"
#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT, kKept = fs::path(HAIR_GRADED) / "right";

// glibc then takes the C library's functions for processors without AVX and FMA. Other libraries ignore it.
const char* const kPlainLibm = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F";

struct Setting {
  std::string name, compiler;
  std::vector<std::string> options;  // follow those of grading
  int seeds;
};

// Leaves out compilers that this machine lacks, and says so.
std::vector<Setting> settings() {
  const auto seeds = [](const char* otherwise) { return std::stoi(environment("HAIR_SEEDS", otherwise)); };
  std::vector<Setting> all = {
      {"as graded", "", {}, seeds("30")}, {"-O0", "", {"-O0"}, seeds("5")}, {"-O2", "", {"-O2"}, seeds("5")}};
  if (fs::exists("/usr/bin/clang++"))
    all.push_back({"clang++", "/usr/bin/clang++", {}, seeds("5")});
  else
    std::puts("clang++ is not installed, and left out (grader/setup.sh --with lint)");
#ifdef __x86_64__
  // The worker allocates for 16 bytes, and Eigen would expect 32 of a machine with AVX.
  if (__builtin_cpu_supports("fma"))
    all.push_back({"FMA", "", {"-ffp-contract=fast", "-mfma", "-DEIGEN_MAX_ALIGN_BYTES=16"}, seeds("5")});
  else
#endif
    std::puts("this machine has no fused multiply-adds, and they are left out");
  return all;
}

// Lists the right programs of an exercise, each once: the reference, and samples that pass. Those with edits
// or other line ends are the same program.
std::vector<SampleProgram> right_programs(const Exercise& exercise) {
  std::vector<SampleProgram> programs =
      programs_of(exercise, kProject, [](const Sample& sample, const std::string& status) {
        return status == "passed" && sample.edits.empty() && !sample.windows;
      });
  const std::string reference = hair::bytes_of(kProject / "reference" / exercise.id / exercise.file);
  std::erase_if(programs, [&](const SampleProgram& one) { return one.source == reference; });
  programs.insert(programs.begin(), {"reference", reference, true});
  return programs;
}

// Holds the largest error / bound of each bound, by category and quantity.
using Nearest = std::map<std::string, double>;

// Adds the output of hairseeds.
void add_nearest(const std::string& printed, Nearest& nearest) {
  std::istringstream lines(printed);
  for (std::string line, bound; std::getline(lines, line);) {
    std::istringstream words(line);
    double ratio;
    int seed;
    if (words >> ratio >> seed >> std::ws && std::getline(words, bound))
      nearest[bound] = std::max(nearest[bound], ratio);
  }
}

// Prints a row for each bound that a program came near to: the largest error / bound of the reference, the
// first program, and of the others.
void print_nearest(const std::string& exercise, const std::vector<Nearest>& nearest) {
  std::map<std::string, std::pair<double, double>> rows;
  for (const Nearest& program : nearest)
    for (const auto& [bound, ratio] : program) {
      double& largest = &program == &nearest[0] ? rows[bound].first : rows[bound].second;
      largest = std::max(largest, ratio);
    }
  const std::size_t far = std::erase_if(
      rows, [](const auto& row) { return std::max(row.second.first, row.second.second) <= 1.0 / 16; });
  for (const auto& [bound, ratios] : rows)
    std::printf("| %s | %s | %.2g | %.2g |\n", exercise.c_str(), bound.c_str(), ratios.first, ratios.second);
  std::printf("| %s | all | %zu others | | |\n", exercise.c_str(), far);
}

// Runs it without a sandbox: we trust these programs.
ProgramRun run(const std::vector<std::string>& words, const fs::path& log) {
  std::string command;
  for (const std::string& word : words) command += "'" + word + "' ";
  const int status = std::system((command + "> '" + log.string() + "' 2>&1").c_str());
  return {status, hair::bytes_of(log), {}};
}

class RightPrograms : public testing::TestWithParam<std::string> {
 protected:
  const Course course_ = read_course(kProject / "handout/exercises.json");
  const Exercise& exercise_ = *course_.find(GetParam());
  const StagedKit kit_{HAIR_KIT_DIR, course_};
  const Toolchain toolchain_{kit_, Isolation::none};
  const std::string suite_ = sha256_of(HAIRSEEDS), given_ = sha256_of(kit_.folder() / "handout");
  const fs::path folder_ = kKept / GetParam();

  std::vector<std::string> compiling(const Setting& setting) const {
    std::vector<std::string> words;
    for (std::string word : toolchain_.compile_command(exercise_.libraries)) {
      // clang++ does not know these options: the look of messages, and the unused memory.
      if (word.find("diagnostics") != std::string::npos || word.starts_with("-fmax-errors") ||
          word.starts_with("--param"))
        continue;
      if (word.starts_with("-I/handout")) word.replace(2, 8, (kit_.folder() / "handout").string());
      words.push_back(word);
    }
    if (!setting.compiler.empty()) words[0] = setting.compiler;
    words.insert(words.end(), setting.options.begin(), setting.options.end());
    return words;
  }

  // Returns the program's failures, or an empty text.
  std::string failures(const SampleProgram& program, const Setting& setting, Nearest& nearest) const {
    const std::string first = environment("HAIR_FIRST_SEED", "0"), seeds = std::to_string(setting.seeds);
    std::string made_of = given_ + toolchain_.version() + setting.compiler + program.source;
    for (const std::string& option : setting.options) made_of += " " + option;
    const std::string name = sha256(made_of);
    const fs::path object = folder_ / name / (exercise_.id + ".so"), log = object.parent_path() / "log",
                   passed =
                       folder_ / (sha256(made_of + suite_ + kit_.hash() + first + " " + seeds) + ".passed");
    if (fs::exists(passed)) {
      add_nearest(hair::bytes_of(passed), nearest);
      return {};
    }

    std::vector<std::string> ask = {HAIRSEEDS, exercise_.id, first, seeds, kit_.folder().string()};
    for (const std::string& id : exercise_.prerequisites) ask.push_back(provided(id));
    ask.push_back(object.string());
    if (!fs::exists(object)) {
      fs::create_directories(object.parent_path());
      const std::string source = object.parent_path() / exercise_.file,
                        compiled = object.parent_path() / "object.o",
                        linked = object.parent_path() / "linked.so";
      std::ofstream(source) << program.source;
      std::vector<std::string> compile = compiling(setting), link = toolchain_.link_command();
      compile.insert(compile.end(), {"-c", source, "-o", compiled});
      link.insert(link.end(),
                  {"-Wl,-soname," + exercise_.id + ".so",
                   "-Wl,--version-script=" + (kit_.folder() / "export" / (exercise_.id + ".map")).string(),
                   "-o", linked, compiled});
      for (const std::string& id : exercise_.prerequisites) link.push_back(provided(id));
      for (const std::string& library : exercise_.libraries) link.push_back(given(library));
      link.push_back(given("standard"));
      for (const auto& words : {compile, link})
        if (const ProgramRun found = run(words, log); found.code != 0) return found.output;
      fs::rename(linked, object);
    }
    const ProgramRun found = run(ask, log);
    add_nearest(found.output, nearest);
    if (found.code != 0) return found.output;
    fs::rename(log, passed);
    return {};
  }

  std::string provided(const std::string& id) const { return kit_.folder() / "provided" / (id + ".so"); }
  std::string given(const std::string& library) const { return kit_.folder() / "given" / (library + ".a"); }
};

TEST_P(RightPrograms, LoseNoPointWhateverCompilesThem) {
  const std::vector<SampleProgram> programs = right_programs(exercise_);
  EXPECT_GE(programs.size(), 3u) << "the reference and two others";
  const std::vector<Setting> all = settings();
  const int reference_seeds = std::stoi(environment("HAIR_REFERENCE_SEEDS", "0"));
  std::vector<std::string> refused(programs.size());
  std::vector<Nearest> nearest(programs.size());
  Processors processors;
  side_by_side(programs.size(), [&](std::size_t i) {
    const Processors::Lease processor(processors);
    for (Setting setting : all) {
      if (i == 0) setting.seeds = std::max(setting.seeds, reference_seeds);
      if (const std::string lost = failures(programs[i], setting, nearest[i]); !lost.empty())
        refused[i] += setting.name + ": " + lost;
    }
  });
  std::printf("%s, seeds:", exercise_.id.c_str());
  for (const Setting& setting : all) std::printf(" %d %s;", setting.seeds, setting.name.c_str());
  std::printf("\n");
  for (std::size_t i = 0; i < programs.size(); ++i) {
    std::printf("  %s\n", programs[i].name.c_str());
    EXPECT_EQ(refused[i], "") << "refused, though it is right: " << programs[i].name;
  }
  print_nearest(exercise_.id, nearest);
}

// The environment's HAIR_OTHER_SUITE may name another compiler's hairseeds. The worker is the same one.
TEST_P(RightPrograms, AreAskedTheSameBitsByEveryBuildOnEveryProcessor) {
  std::vector<std::vector<std::string>> suites = {{HAIRSEEDS}, {"env", kPlainLibm, HAIRSEEDS}};
  if (const std::string other = environment("HAIR_OTHER_SUITE", ""); !other.empty())
    suites.push_back({other});
  fs::create_directories(folder_);
  std::string asked;
  for (std::vector<std::string>& ask : suites) {
    ask.insert(ask.end(), {exercise_.id, "0", "3", kit_.folder().string()});
    for (const std::string& id : exercise_.prerequisites) ask.push_back(provided(id));
    ask.push_back(kit_.folder() / "lib" / (exercise_.id + ".so"));
    const ProgramRun found = run(ask, folder_ / "asked.log");
    ASSERT_EQ(found.code, 0) << found.output;
    const std::string hashes = found.output.substr(found.output.find("\nasked "));
    if (asked.empty()) asked = hashes;
    EXPECT_EQ(hashes, asked) << ask[0];
  }
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const Exercise& exercise : read_course(kProject / "handout/exercises.json").exercises)
    all.push_back(exercise.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Of, RightPrograms, testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace grader
