// STAFF ONLY. Tests that the sample class is packed as its groups say.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <memory>
#include <set>

#include "grader/samples/categories.h"
#include "grader/samples/sample.h"
#include "grader/samples/solution_files.h"
#include "grader/samples/table.h"
#include "hair/io/files/read_file.h"

namespace grader::inline samples {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT, kClass = HAIR_SAMPLE_CLASS, kAttacks = HAIR_ATTACKS;
constexpr std::size_t kMostBytes = std::size_t{80} << 20;  // bounds a file for comparisons

struct Packed {
  std::string bytes;  // has the first kMostBytes
  std::string link;
  std::uint64_t size = 0;
};

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
      file.bytes = hair::bytes_of(item.path());
      file.size = file.bytes.size();
    } else {
      files.erase(item.path().lexically_relative(path).string());
    }
  }
  return files;
}

fs::path packed_path(const Sample& sample) {
  return (sample.in_class() ? kClass : kAttacks / sample.attack->place) / sample.file_name();
}

std::map<std::string, Packed> read_packed(const Sample& sample) {
  const fs::path path = packed_path(sample);
  return sample.form == SampleForm::folder ? read_folder(path) : read_archive(path);
}

std::vector<Sample> all_samples() {
  std::setlocale(LC_CTYPE, "C.UTF-8");  // libarchive's names are in the locale's encoding
  return read_samples(kProject);
}

TEST(SampleClass, HoldsEverySampleAndNothingElse) {
  std::set<std::string> listed, packed;
  for (const Sample& sample : all_samples())
    if (sample.in_class()) listed.insert(sample.file_name());
  for (const auto& item : fs::directory_iterator(kClass)) packed.insert(item.path().filename().string());
  EXPECT_EQ(packed, listed);
  EXPECT_GE(listed.size(), 24u);
}

TEST(AttackCorpus, HoldsThePlacesAttacksAndWhatIsGradedBesideThem) {
  std::size_t attacks = 0;
  for (const std::string place : kPlaces) {
    SCOPED_TRACE(place);
    std::set<std::string> listed, packed;
    std::size_t honest = 0, here = 0;
    for (const Sample& sample : all_samples())
      if (sample.graded_at(place)) {
        listed.insert(sample.file_name());
        ++(sample.attack ? here : honest);
      }
    for (const auto& item : fs::directory_iterator(kAttacks / place))
      packed.insert(item.path().filename().string());
    EXPECT_EQ(packed, listed);
    EXPECT_GE(here, 7U);
    EXPECT_GE(honest, 2U);
    attacks += here;
  }
  EXPECT_GE(attacks, 60U);
}

TEST(SampleClass, HoldsTheFilesThatAreListed) {
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    if (!sample.overwrite.empty()) continue;
    if (sample.cut) {
      EXPECT_EQ(fs::file_size(packed_path(sample)), *sample.cut);
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

// If its edits did nothing, a sample would be a right solution that is expected to be wrong.
TEST(SampleClass, EditsChangeAFileAndNothingElseDoes) {
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    if (sample.cut || !sample.overwrite.empty() || sample.windows || sample.name == "ten-gigabytes") continue;
    const auto packed = read_packed(sample);
    Sample unedited = sample;
    unedited.edits.clear();
    bool changed = false;
    for (const auto& [path, text] : solution_files(unedited, kProject))
      changed |= packed.at(path).bytes != text;
    EXPECT_EQ(changed, !sample.edits.empty());
  }
}

TEST(SampleClass, TenGigabytesTakeLittleSpace) {
  const fs::path path = kAttacks / "archive" / "ten-gigabytes.tar.gz";
  const auto packed = read_archive(path);
  ASSERT_EQ(packed.size(), 1u);
  EXPECT_EQ(packed.begin()->second.size, 10'737'418'240u);
  EXPECT_LT(fs::file_size(path), 11'000'000u) << "deflate packs zeros 1032:1 at best";
}

TEST(SampleClass, ExpectsAKnownStatusForEachExercise) {
  const std::set<std::string> known = {"passed",        "partly",          "wrong",     "not implemented",
                                       "missing",       "crashed",         "timed out", "does not compile",
                                       "out of memory", "broke the rules", "not taken", "can't be read"};
  for (const Sample& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    for (const auto& [id, expected] : sample.expected)
      EXPECT_TRUE(known.count(expected.status)) << id << ": " << expected.status;
    if (!sample.attack) continue;
    for (const std::string& status : sample.attack->also) EXPECT_TRUE(known.count(status)) << status;
  }
}

// Both the points and the categories are written down: either shows an error in the other.
TEST(SampleClass, ShowcasesPointsAreThoseOfTheirCategories) {
  const SampleCategories categories =
      read_categories(kProject, read_course(kProject / "handout/exercises.json"));
  int compared = 0;
  for (const Sample& sample : all_samples())
    for (const auto& [id, expected] : sample.expected)
      if (sample.showcase && !expected.failed.empty()) {
        EXPECT_EQ(expected.points, points_without(categories.at(id), expected.failed))
            << sample.name << ", " << id;
        ++compared;
      }
  EXPECT_GE(compared, 14);
}

TEST(SampleTable, HasARowForEverySample) {
  const std::string table = table_of(all_samples());
  for (const Sample& sample : all_samples())
    EXPECT_NE(table.find("| `" + sample.name + "` | " + sample.shows + " |"), std::string::npos)
        << sample.name;
  for (const char* row :
       {"## Bugs in S1\n\n| sample | what it shows | gets |\n|---|---|---|\n",
        "| `perfect` | Every exercise, as the reference has it. | passed |\n",
        "| `h2-acos` | The angle is acos(u1 . u2). | H2 partly 28 |\n", "## Attacks: protocol\n\n| sample | ",
        "| `drips` | Sends a long message, a byte at a time, with a nap after each. | all waits together are "
        "limited | "
        "S1 timed out | S1 0 | 10 |\n"})
    EXPECT_NE(table.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace grader::samples
