// STAFF ONLY. Tests that archives come back as packed, and that hostile ones are refused within limits.
#include "grader/intake/archives/archive.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "grader/intake/archives/archive_builder.h"
#include "grader/intake/names/archive_format.h"
#include "solver/test_refusal.h"

namespace grader::inline intake {
namespace {

using tests::says;

constexpr ArchiveLimits kLimits{1 << 20, 100};

// Returns the reason for which the archive is refused, or "".
std::string refusal(const std::string& bytes, ArchiveLimits used = kLimits) {
  Archive archive(bytes, "x", used);
  return tests::refusal<Refused>([&] {
    const std::vector<Entry> list = archive.list();
    for (std::size_t i = 0; i < list.size(); ++i) {
      archive.visit({i}, [&](std::size_t, const Container::Read& read) { read(used.unpacked_bytes); });
    }
  });
}

class EveryPacking : public testing::TestWithParam<Packing> {};
INSTANTIATE_TEST_SUITE_P(Archive, EveryPacking,
                         testing::Values(Packing::zip, Packing::tar, Packing::tar_gz, Packing::v7,
                                         Packing::v7_gz));

TEST_P(EveryPacking, WhatWasPackedComesBack) {
  std::string binary("\0\x1a\xff\n", 4);
  Archive archive(ArchiveBuilder(GetParam())
                      .folder("a/")
                      .file("a/x.cpp", "text")
                      .file("a/y", binary)
                      .file("z", "")
                      .bytes(),
                  "x", kLimits);
  const std::vector<Entry> list = archive.list();
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].kind, Entry::Kind::folder);
  EXPECT_EQ(list[1].path, "a/x.cpp");
  EXPECT_EQ(list[1].bytes, 4u);
  std::vector<std::string> texts;
  archive.visit({1, 2, 3}, [&](std::size_t, const Container::Read& read) { texts.push_back(read(100)); });
  EXPECT_EQ(texts, (std::vector<std::string>{"text", binary, ""}));
}

// An archive without entries is not damaged.
TEST_P(EveryPacking, AnEmptyOneIsNotDamaged) {
  if (GetParam() == Packing::tar || GetParam() == Packing::v7)
    GTEST_SKIP() << "an empty tar is zeros: nothing says what they are";
  EXPECT_EQ(refusal(ArchiveBuilder(GetParam()).bytes()), "");
}

TEST_P(EveryPacking, NamesOutsideAsciiAreTaken) {
  Archive archive(ArchiveBuilder(GetParam()).file("Übung/conj_grad.cpp", "text").bytes(), "x", kLimits);
  const std::vector<Entry> list = archive.list();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(name_of(list[0]), "conj_grad.cpp");
}

TEST_P(EveryPacking, NoCutGivesATextThatWasNotPacked) {
  const std::string text = "int answer = 42;\n";
  const std::string whole = ArchiveBuilder(GetParam()).file("a.cpp", text).file("b.cpp", text).bytes();
  std::size_t refused = 0;
  for (std::size_t size = 0; size<whole.size(); size += whole.size()> 4096 ? 64 : 1) {
    Archive archive(whole.substr(0, size), "x", kLimits);
    try {
      const std::size_t count = archive.list().size();
      for (std::size_t i = 0; i < count; ++i) {
        archive.visit({i},
                      [&](std::size_t, const Container::Read& read) { EXPECT_EQ(read(100), text) << size; });
      }
    } catch (const Refused&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0u);
}

TEST_P(EveryPacking, MoreEntriesThanAllowedAreRefused) {
  ArchiveBuilder builder(GetParam());
  for (int i = 0; i < 5; ++i) builder.file("f" + std::to_string(i), "");
  const std::string bytes = builder.bytes();
  EXPECT_EQ(refusal(bytes, {1 << 20, 5}), "");
  EXPECT_TRUE(says(refusal(bytes, {1 << 20, 4}), "more than 4 files"));
}

TEST(Archive, AStreamThatUnpacksToMoreThanAllowedIsRefused) {
  const std::string bytes = ArchiveBuilder(Packing::tar_gz).zeros("zeros", 4 << 20).bytes();
  EXPECT_TRUE(says(refusal(bytes), "unpacks to more than 1 MiB"));
}

// Reads an archive of two entries, of which the first is refused. Returns the second.
std::string behind_a_refused_entry(const std::string& bytes) {
  Archive archive(bytes, "x", kLimits);
  EXPECT_EQ(archive.list().size(), 2u);
  std::string second;
  archive.visit({0, 1}, [&](std::size_t index, const Container::Read& read) {
    if (index == 1) return void(second = read(100));
    EXPECT_THROW(read(100000), Refused);
  });
  return second;
}

TEST(Archive, AnEntryIsReadOnlyAsFarAsAllowed) {
  for (const Packing packing : {Packing::zip, Packing::tar})
    EXPECT_EQ(
        behind_a_refused_entry(ArchiveBuilder(packing).zeros("zeros", 100001).file("x", "text").bytes()),
        "text");
}

TEST(Archive, ADamagedEntryDoesNotHideTheNext) {
  std::string bytes =
      ArchiveBuilder(Packing::zip).file("a", "AAAA" + std::string(5000, 'x')).file("b", "BBBB").bytes();
  // A deflate block of no known type begins the first entry's data, behind its name and extra field.
  bytes.at(30 + 1 + static_cast<unsigned char>(bytes.at(28))) = '\xff';
  EXPECT_EQ(behind_a_refused_entry(bytes), "BBBB");
}

// A zip may state false sizes: here 8 MiB of zeros state 4 bytes, in the directory and at the data.
TEST(Archive, AFalseSizeDoesNotWidenTheLimit) {
  std::string bytes = ArchiveBuilder(Packing::zip).zeros("zeros", 8 << 20).bytes();
  const std::string stated("\0\0\x80\0", 4);
  std::size_t patched = 0;
  for (std::size_t at = bytes.find(stated); at != std::string::npos; at = bytes.find(stated, at)) {
    bytes.replace(at, 4, std::string("\x04\0\0\0", 4));
    ++patched;
  }
  ASSERT_GT(patched, 0u);
  Archive archive(bytes, "x", kLimits);
  ASSERT_EQ(archive.list().at(0).bytes, 4u);
  archive.visit({0}, [](std::size_t, const Container::Read& read) { EXPECT_THROW(read(1000), Refused); });
}

// They choose the memory of their unpacker: here 4 GiB for a dictionary, 256 MiB for a model.
TEST(Archive, MethodsOfZipThatAskForMemoryAreRefused) {
  const std::string lzma("\x09\x04\x05\0\x5d\xff\xff\xff\xff\0", 10), model("\xff\x2f", 2);
  for (const auto& [method, data] :
       std::map<int, std::string>{{12, "BZh9"}, {14, lzma}, {93, ""}, {95, ""}, {98, model}}) {
    EXPECT_TRUE(says(refusal(zip_of_method(method, data + "12345678")), "by a method that is not read here"))
        << method;
  }
  EXPECT_EQ(refusal(zip_of_method(0, "int x;")), "");
}

TEST(Archive, AZipIsReadWhateverStandsAroundIt) {
  for (const char* options : {"zip:compression=deflate", "zip:compression=store", "zip:zip64"})
    for (const auto& [form, bytes] : forms_of(
             ArchiveBuilder(Packing::zip, options).file("a.cpp", "first").file("b.cpp", "second").bytes())) {
      if (options == std::string("zip:zip64") && form.ends_with(", counted")) continue;  // other fields
      SCOPED_TRACE(std::string(options) + ", " + form);
      EXPECT_EQ(refusal(bytes), "");
      Archive archive(bytes, "x", kLimits);
      ASSERT_EQ(archive.list().size(), 2U);
      archive.visit({1}, [](std::size_t, const Container::Read& read) { EXPECT_EQ(read(10), "second"); });
    }
}

// The file ends with another zip, whose end record must not count for the first one.
TEST(Archive, AZipThatWasCutOffIsNotTheOneInIt) {
  const std::string inner = ArchiveBuilder(Packing::zip).file("a.cpp").bytes();
  const std::string outer =
      ArchiveBuilder(Packing::zip, "zip:compression=store").file("a.zip", inner).file("b.cpp").bytes();
  const std::size_t end = outer.find(inner) + inner.size();
  for (const std::size_t more : {0, 10, 100})
    EXPECT_TRUE(says(refusal(outer.substr(0, end + more)), "damaged or cut short")) << more;
}

TEST(Archive, OtherFormatsAreNamed) {
  for (const auto& [bytes, why] : std::vector<std::pair<std::string, std::string>>{
           {"Rar!\x1a\x07", "x is a RAR archive. Hand in a .zip or .tar.gz"},
           {"7z\xbc\xaf\x27\x1c", "a 7z archive"},
           {"", "x is empty"},
           {"hello", "neither a zip nor a tar.gz"},
           {gzip("int x;"), "is one file that is packed with gzip"}})
    EXPECT_TRUE(says(refusal(bytes), why));
}

TEST(Archive, EndingsAreKnownInAnyCase) {
  EXPECT_EQ(without_archive_ending("alice.zip"), "alice");
  EXPECT_EQ(without_archive_ending("alice.v2.TAR.GZ"), "alice.v2");
  EXPECT_EQ(without_archive_ending("alice"), "alice");
  EXPECT_TRUE(has_archive_ending("x.rar"));
  EXPECT_FALSE(has_archive_ending("conj_grad.cpp"));
}

}  // namespace
}  // namespace grader::intake
