// STAFF ONLY. Packs the samples: make_samples PROJECT CLASS SHOWCASE FIRST ATTACKS makes the four folders
// anew. CLASS gets an archive or a folder for each sample of PROJECT except most attacks, SHOWCASE and FIRST
// a copy of those that are marked for them, and ATTACKS a folder for each place, with its attacks and the
// right samples beside them.
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "grader/archive/archive_writer.h"
#include "grader/course/input.h"
#include "grader/samples/sample.h"
#include "grader/samples/solution_files.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"

namespace {

namespace fs = std::filesystem;
using grader::ArchiveEntry;
using grader::Sample;
using grader::SampleFile;
using grader::SampleForm;

std::vector<ArchiveEntry> entries_of(const Sample& sample, const fs::path& project) {
  const auto solutions = grader::solution_files(sample, project);
  std::vector<ArchiveEntry> entries;
  for (const SampleFile& file : sample.files) {
    switch (file.kind) {
      case SampleFile::Kind::solution:
        entries.push_back({file.path, solutions.at(file.path), "", 0});
        break;
      case SampleFile::Kind::text:
        entries.push_back({file.path, file.value, "", 0});
        break;
      case SampleFile::Kind::link:
        entries.push_back({file.path, "", file.value, 0});
        break;
      case SampleFile::Kind::zeros:
        entries.push_back({file.path, "", "", file.zeros});
        break;
    }
  }
  return entries;
}

void write_folder(const fs::path& folder, const std::vector<ArchiveEntry>& entries) {
  for (const ArchiveEntry& entry : entries) {
    const fs::path path = (folder / entry.path).lexically_normal();
    if (path.string().find(folder.lexically_normal().string() + "/") != 0) {
      throw grader::BadInput(entry.path + ": leaves the sample's folder; pack it as zip or tar.gz");
    }
    fs::create_directories(path.parent_path());
    if (entry.link.empty()) {
      hair::write_file(path, entry.bytes + std::string(entry.zeros, '\0'));
    } else {
      fs::create_symlink(entry.link, path);
    }
  }
}

// Changes bytes of a file, as a damaged or forged archive has them.
void overwrite(const fs::path& path, const std::vector<grader::Overwrite>& changes) {
  if (changes.empty()) return;
  std::string bytes = hair::bytes_of(path);
  const auto size = static_cast<std::int64_t>(bytes.size());
  for (const grader::Overwrite& change : changes) {
    const std::int64_t at = change.at < 0 ? size + change.at : change.at;
    if (at < 0 || at + static_cast<std::int64_t>(change.bytes.size()) > size)
      throw grader::BadInput(path.string() + ": there is nothing to overwrite at " +
                             std::to_string(change.at));
    bytes.replace(static_cast<std::size_t>(at), change.bytes.size(), change.bytes);
  }
  hair::write_file(path, bytes);
}

void write_sample(const Sample& sample, const fs::path& project, const fs::path& folder) {
  const fs::path path = folder / sample.file_name();
  const auto entries = entries_of(sample, project);
  switch (sample.form) {
    case SampleForm::zip:
      grader::write_zip(path, entries);
      break;
    case SampleForm::tar_gz:
      grader::write_tar_gz(path, entries);
      break;
    case SampleForm::folder:
      write_folder(path, entries);
      break;
  }
  if (sample.cut) fs::resize_file(path, *sample.cut);
  overwrite(path, sample.overwrite);
}

// Makes a folder completely or not at all: `fill` fills one with another name, which is then renamed.
template <typename Fill>
void make_folder(const fs::path& folder, const Fill& fill) {
  const fs::path unfinished = folder.string() + ".unfinished";
  fs::remove_all(unfinished);
  fs::create_directories(unfinished);
  fill(unfinished);
  fs::remove_all(folder);
  fs::rename(unfinished, folder);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "usage: make_samples PROJECT CLASS SHOWCASE FIRST ATTACKS\n";
    return 2;
  }
  // Times and names in archives depend on both.
  setenv("TZ", "UTC", 1);
  if (!std::setlocale(LC_CTYPE, "C.UTF-8")) std::setlocale(LC_CTYPE, "en_US.UTF-8");
  try {
    const fs::path project = argv[1], all = argv[2], showcase = argv[3], first = argv[4], attacks = argv[5];
    const auto samples = grader::read_samples(project);
    make_folder(all, [&](const fs::path& folder) {
      for (const Sample& sample : samples)
        if (sample.in_class()) write_sample(sample, project, folder);
    });
    make_folder(attacks, [&](const fs::path& folder) {
      for (const std::string place : grader::kPlaces)
        for (const Sample& sample : samples)
          if (sample.graded_at(place)) {
            fs::create_directories(folder / place);
            write_sample(sample, project, folder / place);
          }
    });
    const auto copy_those = [&](bool Sample::*marked) {
      return [&, marked](const fs::path& folder) {
        for (const Sample& sample : samples) {
          const fs::path name = sample.file_name();
          if (sample.*marked) fs::copy(all / name, folder / name, fs::copy_options::recursive);
        }
      };
    };
    make_folder(showcase, copy_those(&Sample::showcase));
    make_folder(first, copy_those(&Sample::first));
  } catch (const std::exception& error) {
    std::cerr << "make_samples: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
