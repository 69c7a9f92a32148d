// STAFF ONLY. Stores each picture once.
#include "grader/report/facts/picture_files.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader::inline report {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".png";

bool is_picture_name(std::string_view name) {
  return name.size() == 64 + kEnding.size() && name.ends_with(kEnding) &&
         name.find_first_not_of("0123456789abcdef") == 64;
}

void write_picture(const fs::path& folder, const std::string& png) {
  if (png.empty()) return;
  const fs::path file = folder / picture_name(png);
  if (hair::bytes_of(file) != png) write_file(file, png);
}

void write_pictures_of(const fs::path& folder, const std::vector<PictureResult>& pictures) {
  for (const PictureResult& picture : pictures)
    for (const std::string* png : {&picture.student, &picture.reference, &picture.heat})
      write_picture(folder, *png);
}

}  // namespace

fs::path pictures_folder(const fs::path& dir) {
  return dir / "staff" / "pictures";
}

std::string picture_name(const std::string& png) {
  return png.empty() ? "" : sha256(png) + std::string(kEnding);
}

void write_pictures(const fs::path& folder, const SubmissionResult& result) {
  for (const ExerciseResult& exercise : result.exercises) write_pictures_of(folder, exercise.pictures);
}

void remove_unshown_pictures(const fs::path& dir) {
  constexpr std::string_view link = "src=\"pictures/";
  std::set<std::string, std::less<>> shown;
  std::error_code none;
  for (const auto& page : fs::directory_iterator(dir / "staff", none)) {
    if (page.path().extension() != ".html") continue;
    const std::string text = hair::bytes_of(page.path());
    if (text.empty()) return;  // an unreadable page may show any picture
    for (std::size_t at = text.find(link); at != text.npos; at = text.find(link, at)) {
      at += link.size();
      shown.insert(text.substr(at, text.find('"', at) - at));
    }
  }
  for (const auto& file : fs::directory_iterator(pictures_folder(dir), none))
    if (const std::string name = file.path().filename().string();
        is_picture_name(name) && !shown.contains(name))
      fs::remove(file.path(), none);
}

}  // namespace grader::report
