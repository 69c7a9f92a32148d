// STAFF ONLY. Tests of the handout's CMake files: folders with names that CMake can't hold are refused in a
// sentence, and others work; files unpacked over a built folder are built again, whatever their dates.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <regex>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using tests::says;

constexpr const char* kGenerators[] = {"Unix Makefiles", "Ninja"};

int run(std::vector<std::string> words, const hair::Stream& errors = {}) {
  words.insert(words.begin(), "/usr/bin/env");
  return hair::exit_code_of(
             hair::start_program({.words = std::move(words), .output = "/dev/null", .errors = errors}))
      .value_or(-1);
}

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
  const std::string build = (folder / "build").string();
  if (run({"cmake", "-G", generator, "-S", folder.string(), "-B", build}, errors) != 0)
    return hair::bytes_of(errors);
  if (run({"cmake", "--build", build}, errors) != 0) return "no build: " + hair::bytes_of(errors);
  return fs::exists(folder / "build/made") ? "" : "nothing was built";
}

void expect_refused(const std::string& name, const std::string& generator) {
  // CMake breaks lines.
  const auto in_one_line = [](const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
  };
  const std::string said = in_one_line(configuring(name, generator));
  EXPECT_TRUE(says(said, in_one_line(name) + "\" can't be built in: CMake takes no ")) << name << ": ";
  EXPECT_TRUE(says(said, "Move it to a folder without any of")) << name << ": ";
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

class Unpacked : public testing::TestWithParam<const char*> {
 protected:
  void write(const std::string& file, const std::string& text, fs::file_time_type date) const {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << text;
    fs::last_write_time(folder_ / file, date);
  }

  // Unpacks as an archive that keeps dates.
  void unpack(const std::string& given) const {
    write("given/a.txt", given, old_);
    write("cmake/just-unpacked", "", old_);
  }

  // Returns the built lines, one for each time that they were built.
  std::string built(const std::string& build = "build", bool configures = false) const {
    const std::string there = (folder_ / build).string();
    if (configures) {
      EXPECT_EQ(run({"cmake", "-G", GetParam(), "-S", folder_.string(), "-B", there}), 0);
    }
    EXPECT_EQ(run({"cmake", "--build", there}), 0);
    return hair::bytes_of(folder_ / build / "made");
  }

  hair::TemporaryFolder temporary_{"unpacked"};
  fs::path folder_ = temporary_.path();
  fs::file_time_type old_ = fs::file_time_type::clock::now() - 1000h;
};

TEST_P(Unpacked, IsBuiltAnewOnceInEachFolderAndAStudentsFilesAreLeftAlone) {
  fs::create_directory(folder_ / "cmake");
  fs::copy_file(fs::path(HAIR_SOURCE_DIR) / "handout/cmake/unpacked.cmake", folder_ / "cmake/unpacked.cmake");
  write("CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.22)\nproject(x LANGUAGES NONE)\ninclude(cmake/unpacked.cmake)\n"
        "foreach(file given/a student/b)\nadd_custom_command(OUTPUT ${file} DEPENDS "
        "\"${PROJECT_SOURCE_DIR}/${file}.txt\"\n"
        "COMMAND sh -c \"mkdir -p given student && touch ${file} && cat ${PROJECT_SOURCE_DIR}/${file}.txt >> "
        "made\" VERBATIM)\n"
        "endforeach()\nadd_custom_target(both ALL DEPENDS given/a student/b)\n",
        old_);
  write("student/b.txt", "", old_);
  unpack("one\n");
  EXPECT_EQ(built("build", true), "one\n");
  EXPECT_EQ(built("other", true), "one\n");
  unpack("two\n");
  EXPECT_EQ(built(), "one\ntwo\n") << "without configuring";
  EXPECT_EQ(built(), "one\ntwo\n");
  EXPECT_EQ(built("other", true), "one\ntwo\n");
  write("given/a.txt", "an experiment\n", fs::file_time_type::clock::now());
  EXPECT_EQ(built(), "one\ntwo\nan experiment\n");
  unpack("two\n");
  EXPECT_EQ(built("build", true), "one\ntwo\nan experiment\ntwo\n") << "the same archive again";
  EXPECT_EQ(fs::last_write_time(folder_ / "student/b.txt"), old_);
}

INSTANTIATE_TEST_SUITE_P(ByEach, Unpacked, testing::Values("Unix Makefiles", "Ninja"),
                         [](const auto& generator) { return generator.index == 0 ? "Make" : "Ninja"; });

}  // namespace
}  // namespace grader::package
