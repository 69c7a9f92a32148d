// STAFF ONLY. The sample class is packed as samples.json says.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "grader/course/bad_input.h"
#include "grader/samples/sample.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT, kClass = HAIR_SAMPLE_CLASS;
const fs::path kSamplesJson = kProject / "grader" / "samples" / "samples.json";
constexpr std::size_t kMostBytes = std::size_t{80} << 20;  // of a file, to compare

struct Packed {
  std::string bytes;  // the first kMostBytes of them
  std::string link;
  std::uint64_t size = 0;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Stops at the first file that is longer than kMostBytes: only a hostile archive has one.
std::map<std::string, Packed> read_archive(const fs::path& path) {
  std::map<std::string, Packed> files;
  const std::unique_ptr<archive, int (*)(archive*)> a(archive_read_new(), archive_read_free);
  archive_read_support_filter_gzip(a.get());
  archive_read_support_format_tar(a.get());
  archive_read_support_format_zip(a.get());
  if (archive_read_open_filename(a.get(), path.c_str(), 1 << 16) != ARCHIVE_OK) return files;
  archive_entry* entry = nullptr;
  while (archive_read_next_header(a.get(), &entry) == ARCHIVE_OK) {
    Packed& file = files[archive_entry_pathname(entry)];
    if (const char* link = archive_entry_symlink(entry)) file.link = link;
    file.size = static_cast<std::uint64_t>(archive_entry_size(entry));
    std::string block(1 << 20, '\0');
    for (la_ssize_t got = 0; (got = archive_read_data(a.get(), block.data(), block.size())) > 0;) {
      file.bytes.append(block, 0, static_cast<std::size_t>(got));
      if (file.bytes.size() >= kMostBytes) return files;
    }
  }
  return files;
}

std::map<std::string, Packed> read_folder(const fs::path& path) {
  std::map<std::string, Packed> files;
  for (const auto& item : fs::recursive_directory_iterator(path)) {
    Packed& file = files[item.path().lexically_relative(path).string()];
    if (item.is_symlink()) {
      file.link = fs::read_symlink(item.path()).string();
    } else if (item.is_regular_file()) {
      file.bytes = bytes_of(item.path());
      file.size = file.bytes.size();
    } else {
      files.erase(item.path().lexically_relative(path).string());
    }
  }
  return files;
}

std::map<std::string, Packed> read_packed(const Sample& sample) {
  const fs::path path = kClass / sample.file_name();
  return sample.form == SampleForm::folder ? read_folder(path) : read_archive(path);
}

std::vector<Sample> all_samples() {
  std::setlocale(LC_CTYPE, "C.UTF-8");  // libarchive's names are in the locale's encoding
  return read_samples(kSamplesJson);
}

fs::path base_file(const SampleFile& file) {
  const fs::path name = fs::path(file.path).filename();
  if (file.value == "reference") return kProject / "reference" / name;
  if (file.value == "stub") return kProject / "handout" / "student" / name;
  return kProject / "grader" / "samples" / "solutions" / file.value / name;
}

// Of this test alone: others run at the same time.
fs::path scratch(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / ("samples_test_" + std::string(test->name()) + "_" + name);
}

// A project with one sample, whose patch turns "one" to "two" in a file that reads `source`.
fs::path small_project(const std::string& source) {
  const fs::path project = scratch("project");
  const fs::path samples = project / "grader" / "samples";
  fs::remove_all(project);
  fs::create_directories(samples / "patches");
  fs::create_directories(samples / "solutions" / "plain");
  std::ofstream(samples / "solutions" / "plain" / "a.cpp") << source;
  std::ofstream(samples / "patches" / "bug.patch") << "--- a/a.cpp\n+++ b/a.cpp\n@@ -1 +1 @@\n-one\n+two\n";
  std::ofstream(samples / "samples.json")
      << R"({"samples": [{"name": "bug", "shows": "A bug.", "form": "folder", "files": {"a.cpp": "plain"},
             "patch": "bug.patch", "expect": {"S1": {"status": "wrong", "points": 3}}}]})";
  return project;
}

struct Outcome {
  int code;
  std::string output;
};

Outcome make_samples(const fs::path& project, const fs::path& out) {
  const fs::path log = scratch("log");
  const std::string command = std::string("'") + HAIR_MAKE_SAMPLES + "' '" + project.string() + "' '" +
                              out.string() + "' >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(log)};
}

TEST(SampleClass, HoldsEverySampleAndNothingElse) {
  std::set<std::string> listed, packed;
  for (const Sample& sample : all_samples()) listed.insert(sample.file_name());
  for (const auto& item : fs::directory_iterator(kClass)) packed.insert(item.path().filename().string());
  EXPECT_EQ(packed, listed);
  EXPECT_GE(listed.size(), 24u);
}

TEST(SampleClass, HoldsTheFilesThatAreListed) {
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    if (sample.cut) {
      EXPECT_EQ(fs::file_size(kClass / sample.file_name()), *sample.cut);
      continue;
    }
    const auto packed = read_packed(sample);
    for (const SampleFile& file : sample.files) {
      SCOPED_TRACE(file.path);
      const auto found = packed.find(file.path);
      ASSERT_NE(found, packed.end());
      switch (file.kind) {
        case SampleFile::Kind::solution:
          EXPECT_TRUE(found->second.link.empty());
          EXPECT_GT(found->second.size, 0u);
          break;
        case SampleFile::Kind::text:
          EXPECT_EQ(found->second.bytes, file.value);
          break;
        case SampleFile::Kind::link:
          EXPECT_EQ(found->second.link, file.value);
          break;
        case SampleFile::Kind::zeros:
          EXPECT_EQ(found->second.size, file.zeros);
          EXPECT_EQ(found->second.bytes.find_first_not_of('\0'), std::string::npos);
          EXPECT_GE(found->second.bytes.size(), std::min<std::uint64_t>(file.zeros, kMostBytes));
          break;
      }
      if (found->second.bytes.size() >= kMostBytes) break;
    }
    if (std::none_of(packed.begin(), packed.end(),
                     [](const auto& file) { return file.second.bytes.size() >= kMostBytes; })) {
      EXPECT_EQ(packed.size(), sample.files.size());
    }
  }
}

// A sample whose patch did nothing would be a right solution that is expected to be wrong.
TEST(SampleClass, PatchesChangeAFileAndNothingElseDoes) {
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    if (sample.cut || sample.windows || sample.name == "ten-gigabytes") continue;
    const auto packed = read_packed(sample);
    bool changed = false;
    for (const SampleFile& file : sample.files) {
      if (file.kind == SampleFile::Kind::solution) {
        changed |= packed.at(file.path).bytes != bytes_of(base_file(file));
      }
    }
    EXPECT_EQ(changed, !sample.patch.empty());
  }
}

TEST(SampleClass, TenGigabytesTakeLittleSpace) {
  const fs::path path = kClass / "ten-gigabytes.tar.gz";
  const auto packed = read_archive(path);
  ASSERT_EQ(packed.size(), 1u);
  EXPECT_EQ(packed.begin()->second.size, 10'737'418'240u);
  EXPECT_LT(fs::file_size(path), 11'000'000u) << "deflate packs zeros 1032:1 at best";
}

TEST(SampleClass, ExpectsAKnownStatusForEachExercise) {
  const std::set<std::string> known = {"passed",        "partly",         "wrong",     "not implemented",
                                       "missing",       "crashed",        "timed out", "does not compile",
                                       "out of memory", "broke the rules"};
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    EXPECT_EQ(sample.expected.size(), 2u);
    for (const auto& [id, expected] : sample.expected) {
      EXPECT_TRUE(id == "S1" || id == "S2") << id;
      EXPECT_TRUE(known.count(expected.status)) << expected.status;
    }
  }
}

TEST(SampleClass, IsDescribedInTheReadme) {
  const std::string readme = bytes_of(kProject / "grader" / "samples" / "README.md");
  for (const Sample& sample : all_samples()) {
    const std::string row = "| `" + sample.name + "` | " + sample.shows + " | " +
                            sample.expected.at("S1").status + " | " + sample.expected.at("S2").status +
                            " |\n";
    EXPECT_NE(readme.find(row), std::string::npos) << "README.md lacks the row\n" << row;
  }
}

TEST(MakeSamples, GivesTheSameBytesWhateverTheTimeZoneAndLocale) {
  const fs::path project = small_project("one\n"), out = project / "class", again = project / "again";
  ASSERT_EQ(make_samples(kProject, out).code, 0);
  setenv("TZ", "America/New_York", 1);
  setenv("LC_ALL", "C", 1);
  ASSERT_EQ(make_samples(kProject, again).code, 0);
  unsetenv("TZ");
  unsetenv("LC_ALL");
  for (const Sample& sample : all_samples()) {
    if (sample.form == SampleForm::folder) continue;
    EXPECT_TRUE(bytes_of(out / sample.file_name()) == bytes_of(again / sample.file_name())) << sample.name;
  }
  fs::remove_all(project);
}

TEST(MakeSamples, AppliesThePatch) {
  const fs::path project = small_project("one\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(bytes_of(project / "class" / "bug" / "a.cpp"), "two\n");
}

TEST(MakeSamples, RefusesAPatchThatDoesNotApply) {
  const fs::path project = small_project("three\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("bug.patch does not apply"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(project / "class"));
}

TEST(MakeSamples, RefusesAPatchThatNoSampleUses) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "grader" / "samples" / "patches" / "forgotten.patch") << "";
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("forgotten.patch: no sample uses it"), std::string::npos) << run.output;
}

TEST(MakeSamples, NamesASolutionThatIsNotThere) {
  const fs::path project = small_project("one\n");
  fs::remove(project / "grader" / "samples" / "solutions" / "plain" / "a.cpp");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("sample \"bug\": a.cpp: "), std::string::npos) << run.output;
}

TEST(ReadSamples, ReadsPointsAndLeavesThemOpen) {
  const fs::path project = small_project("one\n");
  const auto samples = read_samples(project / "grader" / "samples" / "samples.json");
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].expected.at("S1").status, "wrong");
  EXPECT_EQ(samples[0].expected.at("S1").points, 3.0);
}

TEST(ReadSamples, NamesAFormThatItDoesNotKnow) {
  const fs::path file = scratch("json");
  std::ofstream(file)
      << R"({"samples": [{"name": "a", "shows": "b", "form": "rar", "files": {}, "expect": {}}]})";
  try {
    read_samples(file);
    FAIL() << "read";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("samples[0].form: unknown form; write zip"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace grader
