// STAFF ONLY. Reads hostile bytes as an archive: alone, and handed in as a submission or a class. A tar also
// gets right checksums and is packed by gzip, since a change of one byte never gives these.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "grader/course/input.h"
#include "grader/intake/archives/archive.h"
#include "grader/intake/archives/archive_builder.h"
#include "grader/intake/read_submissions.h"
#include "hair/io/fuzz/fuzz.h"

namespace {

using grader::Archive, grader::ArchiveBuilder, grader::Container, grader::Entry, grader::Packing;

constexpr std::size_t kMostUnpacked = 1 << 20, kMostOfAFile = 1 << 16, kMostEntries = 200;
constexpr std::size_t kBlock = 512;  // is a tar's block

// True if a right checksum makes a tar of these bytes.
bool may_be_tar(std::string_view bytes) {
  return bytes.size() >= kBlock && !bytes.starts_with("PK") && !bytes.starts_with("\x1f\x8b");
}

// Reads an octal number, up to the first other byte.
std::size_t octal(std::string_view digits) {
  std::size_t number = 0;
  for (const char c : digits) {
    if (c < '0' || c > '7') break;
    number = number * 8 + static_cast<std::size_t>(c - '0');
  }
  return number;
}

// Writes the right checksum into each header of a tar: the sum of its bytes, with eight spaces for the sum.
std::string repaired(std::string_view bytes) {
  std::string all(bytes);
  for (std::size_t at = 0; at + kBlock <= all.size();) {
    const auto header = all.begin() + static_cast<std::ptrdiff_t>(at);
    std::fill_n(header + 148, 8, ' ');
    unsigned sum = 0;
    std::for_each(header, header + kBlock, [&](char c) { sum += static_cast<unsigned char>(c); });
    for (int i = 5; i >= 0; --i, sum /= 8) header[148 + i] = static_cast<char>('0' + sum % 8);
    header[154] = '\0';
    const std::size_t size = octal(std::string_view(all).substr(at + 124, 12));
    at += kBlock + std::min(size, all.size()) / kBlock * kBlock + (size % kBlock != 0 ? kBlock : 0);
  }
  return all;
}

void check(const Entry& entry) {
  fuzz::expect(entry.shown.size() <= 4096, "a path has at most 4096 bytes");
  fuzz::expect(!entry.path.starts_with('/') && !entry.path.ends_with('/'), "a path has no empty part");
  const std::string path = "/" + entry.path + "/";
  for (const char* part : {"/../", "/./", "\\"})
    fuzz::expect(path.find(part) == std::string::npos, "a path's parts are names");
  fuzz::expect(entry.path.empty() || path.find("//") == std::string::npos, "a path has no empty part");
}

// Holds the content of each entry; nothing for a refused one.
using Texts = std::vector<std::optional<std::string>>;

Texts texts_of(Archive& archive, std::size_t count, std::size_t most) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  Texts texts(count);
  archive.visit(all, [&](std::size_t index, const Container::Read& read) {
    try {
      texts[index] = read(most);
      fuzz::expect(texts[index]->size() <= most, "a text is as long as it may be");
    } catch (const grader::Refused& why) {
      fuzz::expect_readable(why.what());
    }
  });
  return texts;
}

void try_archive(const std::string& bytes) {
  Archive archive(bytes, "x", {kMostUnpacked, kMostEntries});
  try {
    const std::vector<Entry> list = archive.list();
    fuzz::expect(list.size() <= kMostEntries, "there are as many entries as there may be");
    for (const Entry& entry : list) check(entry);
    texts_of(archive, list.size(), kMostOfAFile);
    fuzz::expect(archive.list().size() == list.size(), "an archive's list is always the same");
  } catch (const grader::Refused& why) {
    fuzz::expect_readable(why.what());
  }
}

grader::Course two_exercises() {
  grader::Course course;
  course.exercises.resize(2);
  course.exercises[0].file = "a.cpp";
  course.exercises[1].file = "b.cpp";
  return course;
}

void try_intake(std::string_view bytes) {
  static const grader::Course course = two_exercises();
  const grader::IntakeLimits limits{kMostOfAFile, kMostUnpacked, kMostUnpacked, kMostEntries};
  const grader::Descriptor file = grader::opened(std::string(bytes), "x");
  try {
    for (const grader::Submission& submission :
         grader::read_submissions({"/proc/self/fd/" + std::to_string(file.get())}, course, grader::open_here,
                                  limits)
             .submissions) {
      if (!submission.problem.empty()) fuzz::expect_readable(submission.problem);
      fuzz::expect(submission.problem.empty() != submission.files.empty(),
                   "a submission has files or a problem");
      for (const auto& [name, source] : submission.files) {
        fuzz::expect(name == "a.cpp" || name == "b.cpp", "only files of exercises are taken");
        fuzz::expect(source.text.size() <= kMostOfAFile, "a file is as long as it may be");
        if (!source.problem.empty()) fuzz::expect_readable(source.problem);
        fuzz::expect(source.problem.empty() || source.text.empty(), "a file has a text or a problem");
      }
    }
  } catch (const grader::BadInput& error) {
    fuzz::expect_readable(error.what());
  }
}

void try_bytes(const std::string& bytes) {
  try_archive(bytes);
  try_intake(bytes);
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  try_bytes(std::string(bytes));
  if (!may_be_tar(bytes)) return;
  const std::string tar = repaired(bytes);
  try_bytes(tar);
  try_bytes(grader::gzip(tar));
}

// All unpacked bytes of an archive may be in memory at once, in a text that doubles as it grows, and three
// nested archives with their contents. The library has megabytes of its own for headers and windows.
std::size_t fuzz::most_memory(std::size_t input) {
  return 16'000'000 + 6 * kMostUnpacked + 100 * input;
}

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> all;
  for (const Packing packing : {Packing::zip, Packing::tar, Packing::tar_gz}) {
    all.push_back(ArchiveBuilder(packing).folder("p/").file("p/a.cpp", "text").file("p/b.cpp", "").bytes());
    all.push_back(ArchiveBuilder(packing)
                      .symbolic_link("a.cpp", "b.cpp")
                      .file("../b.cpp")
                      .file("x\\y/c.cpp", std::string(600, 'c'))
                      .bytes());
    all.push_back(ArchiveBuilder(packing).file(std::string(120, 'd') + "/Ü/a.cpp").bytes());
    all.push_back(ArchiveBuilder(packing).file("alice.zip", all[0]).file("bob/b.cpp").bytes());
    all.push_back(ArchiveBuilder(packing).file("alice/x.tar.gz", all.back()).bytes());
  }
  all.push_back(
      ArchiveBuilder(Packing::tar).file("a.cpp").hard_link("b.cpp", "a.cpp").special("c", AE_IFIFO).bytes());
  all.push_back(ArchiveBuilder(Packing::zip, "zip:compression=store").file("a.cpp").bytes());
  all.push_back(ArchiveBuilder(Packing::zip, "zip:encryption=zipcrypt").file("a.cpp").bytes());
  for (const Packing packing : {Packing::v7, Packing::v7_gz})
    all.push_back(ArchiveBuilder(packing).folder("p/").file("p/a.cpp").file("p/b.cpp", "").bytes());
  for (const char* options : {"zip:compression=deflate", "zip:zip64"})
    for (const auto& [form, bytes] :
         grader::forms_of(ArchiveBuilder(Packing::zip, options).file("a.cpp").bytes(), 100))
      all.push_back(bytes);
  // LZMA and PPMd request memory: 64 kB and 1 MiB here.
  all.push_back(grader::zip_of_method(14, std::string("\x09\x04\x05\0\x5d\0\0\1\0\0\x12\x34\x56\x78", 14)));
  all.push_back(grader::zip_of_method(98, std::string("\x05\0\0\x12\x34\x56\x78", 7)));
  for (const int method : {12, 93, 95}) all.push_back(grader::zip_of_method(method, "12345678"));
  all.push_back(grader::gzip("int x;"));
  return all;
}
