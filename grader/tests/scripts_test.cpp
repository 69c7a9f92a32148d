// STAFF ONLY. Tests the scripts that people start before anything is built: a request for help is answered at
// once.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using tests::says;

TEST(Scripts, HelpWithoutABuild) {
  const hair::TemporaryFolder checkout("checkout");
  fs::create_directory(checkout.path() / "grader");
  for (const char* script : {"grader/grade", "grader/check", "grader/setup.sh"})
    fs::copy_file(fs::path(HAIR_PROJECT) / script, checkout.path() / script);
  const fs::path said = checkout.path() / "said";
  for (const auto& [script, words, part] :
       {std::tuple<std::string, std::vector<std::string>, std::string>{"grade", {"--help"}, "/grade --all "},
        {"grade", {"-h"}, "/grade --all "},
        {"grade", {"--version"}, "/grade --all "},
        {"grade", {"grade", "--help"}, "COMMAND --help"},
        {"grade", {"handout", "--out", "x.tar.gz", "--help"}, "COMMAND --help"},
        {"check", {"--help"}, "/check --all "},
        {"setup.sh", {"--help"}, "TARGET"}}) {
    std::vector<std::string> all = words;
    all.insert(all.begin(), (checkout.path() / "grader" / script).string());
    EXPECT_EQ(hair::exit_code_of(hair::start_program({.words = all, .output = said})), 0) << script;
    EXPECT_TRUE(says(hair::bytes_of(said), part)) << script;
  }
  EXPECT_FALSE(fs::exists(checkout.path() / "build"));
}

}  // namespace
}  // namespace grader
