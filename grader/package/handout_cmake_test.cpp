// STAFF ONLY. Tests that folders with names that CMake can't hold are refused in a sentence, and others work.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGenerators[] = {"Unix Makefiles", "Ninja"};

// Configures and builds a project in a folder of this name. Returns CMake's error, or an empty text.
std::string configuring(const std::string& name, const std::string& generator) {
  const hair::TemporaryFolder temporary("folder-names");
  const fs::path folder = temporary.path() / name, errors = temporary.path() / "errors";
  fs::create_directories(folder / "cmake");
  fs::copy_file(fs::path(HAIR_SOURCE_DIR) / "handout/cmake/folder.cmake", folder / "cmake/folder.cmake");
  std::ofstream(folder / "CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.22)\ninclude(cmake/folder.cmake)\nproject(names LANGUAGES NONE)\n"
         "add_custom_target(all_names ALL COMMAND \"${CMAKE_COMMAND}\" -E touch "
         "\"${PROJECT_BINARY_DIR}/made\" VERBATIM)\n";
  const auto run = [&](std::vector<std::string> words) {
    return hair::exit_code_of(
        hair::start_program({.words = std::move(words), .output = "/dev/null", .errors = errors}));
  };
  const std::string build = (folder / "build").string();
  if (run({"/usr/bin/env", "cmake", "-G", generator, "-S", folder.string(), "-B", build}) != 0)
    return hair::bytes_of(errors);
  if (run({"/usr/bin/env", "cmake", "--build", build}) != 0) return "no build: " + hair::bytes_of(errors);
  return fs::exists(folder / "build/made") ? "" : "nothing was built";
}

void expect_refused(const std::string& name, const std::string& generator) {
  // CMake breaks lines.
  const auto in_one_line = [](const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
  };
  const std::string said = in_one_line(configuring(name, generator));
  EXPECT_NE(said.find(in_one_line(name) + "\" can't be built in: CMake takes no "), std::string::npos)
      << name << ": " << said;
  EXPECT_NE(said.find("Move it to a folder without any of"), std::string::npos) << name << ": " << said;
}

TEST(FolderNames, ThatCMakeCanNotHoldAreRefusedInASentence) {
  for (const char* generator : kGenerators)
    for (const std::string name : {"C#", "a;b", "a\"b", "a<b", "a>b", "a?b", "a|b", "a[b", "a]b", "${X}",
                                   "a,b", "10:30", "a=b", "a*b", "a\tb", "a\rb", "$(X)"})
      expect_refused(name, generator);
}

TEST(FolderNames, OfOtherKindsAreBuiltIn) {
  for (const char* generator : kGenerators)
    for (const std::string name :
         {"a b", "a$b", "$HOME", "Übung", "a(b)", "c++", "a%b", "a{b}", "a~b", "a@b"})
      EXPECT_EQ(configuring(name, generator), "") << name;
}

// Ninja ends names in lists of headers there.
TEST(FolderNames, ThatNinjaCanNotReadAreForMake) {
  for (const std::string name : {"a&b", "it's", "a^b", "a`b"}) {
    EXPECT_EQ(configuring(name, "Unix Makefiles"), "") << name;
    expect_refused(name, "Ninja");
  }
}

}  // namespace
}  // namespace grader::package
