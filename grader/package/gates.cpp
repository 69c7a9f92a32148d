// STAFF ONLY. Checks a handout's contents before its release.
#include "grader/package/gates.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace grader::inline package {
namespace {

const std::string canary = "STAFF ONLY";
constexpr std::size_t least_lines = 4, least_with_letters = 3, least_letters = 30;

enum class Comments { with, without };  // comments begin with //

bool is_letter(char c) {
  return c == '_' || std::isalnum(static_cast<unsigned char>(c));
}

// Removes harmless parts of a line: #include, and the words that begin a namespace or a using.
std::string_view telling_part(std::string_view line) {
  const auto first = static_cast<std::size_t>(std::ranges::find_if(line, is_letter) - line.begin());
  const std::string_view words = line.substr(first);
  if (words.starts_with("include") && line.substr(0, first).find('#') != line.npos) return {};
  for (const auto& [begin, end] : {std::pair{"using ", ';'}, std::pair{"namespace ", '{'}})
    if (words.starts_with(begin)) return words.substr(std::min(words.find(end), words.size() - 1) + 1);
  return line;
}

// Measures an escape that has letters and stands for one character in strings and on pages.
std::size_t length_of_escape(std::string_view text) {
  if (text[0] != '\\' && text[0] != '&') return 0;
  for (const std::string_view escape : {"\\n", "\\t", "\\r", "&lt;", "&gt;", "&amp;", "&quot;"})
    if (text.starts_with(escape)) return escape.size();
  return 0;
}

// Holds the letters, digits and underscores of a text in a row: neither its layout nor marks of comments
// change them.
struct Letters {
  std::string text;
  std::vector<int> line;            // are their line numbers
  std::vector<std::size_t> begins;  // are the places where lines with letters begin, and the end
};

Letters letters_of(const std::string& text, Comments comments) {
  Letters letters;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (comments == Comments::without) line.resize(std::min(line.find("//"), line.size()));
    std::string_view rest = telling_part(line);
    if (rest.find_first_not_of(" \t\r") == rest.npos) continue;
    letters.begins.push_back(letters.text.size());
    for (; !rest.empty(); rest.remove_prefix(std::max<std::size_t>(length_of_escape(rest), 1)))
      if (is_letter(rest[0])) {
        letters.text += rest[0];
        letters.line.push_back(number);
      }
  }
  letters.begins.push_back(letters.text.size());
  return letters;
}

// Finds consecutive lines from one on, as few as have enough letters to be a secret.
struct Run {
  std::string_view letters;
  int line;  // is the first one
};

std::vector<Run> runs_of(const Letters& letters) {
  std::vector<Run> runs;
  const std::vector<std::size_t>& begins = letters.begins;
  for (std::size_t first = 0; first + least_lines < begins.size(); ++first) {
    if (begins[first] == begins[first + 1]) continue;
    std::size_t end = first, with_letters = 0;
    const auto is_enough = [&] {
      return end - first >= least_lines && with_letters >= least_with_letters &&
             begins[end] - begins[first] >= least_letters;
    };
    for (; !is_enough() && end + 1 < begins.size(); ++end) with_letters += begins[end] < begins[end + 1];
    if (is_enough())
      runs.push_back({std::string_view(letters.text).substr(begins[first], begins[end] - begins[first]),
                      letters.line[begins[first]]});
  }
  return runs;
}

}  // namespace

void check_listing(const Files& handout, const Paths& listed) {
  for (const auto& [path, bytes] : handout)
    if (!listed.contains(path))
      throw HandoutError("the archive holds " + path + ", which the manifest does not list");
  for (const std::string& path : listed)
    if (!handout.contains(path))
      throw HandoutError("the archive lacks " + path + ", which the manifest lists");
}

bool is_test_by_name(const std::string& path) {
  const std::filesystem::path file = std::filesystem::path(path).filename();
  return file == "tests.cmake" || file.string().ends_with("_test.cpp") || file.string().starts_with("test_");
}

void check_folder(const Files& files, const std::string& where) {
  for (const auto& [path, text] : files) {
    const std::string stem = std::filesystem::path(path).stem().string();
    const auto holds = [&text = text](std::string_view part) { return text.find(part) != std::string::npos; };
    std::string kind;
    if (holds(canary)) kind = "a staff file";
    if (holds("gtest/gtest.h")) kind = "of a test";
    if (holds("benchmark/benchmark.h") || stem.ends_with("_bench")) kind = "of a benchmark";
    if (holds("LLVMFuzzerTestOneInput") || stem.ends_with("_fuzz")) kind = "of a fuzz program";
    if (!kind.empty())
      throw HandoutError(
          where + ": " + path + " is " + kind +
          ", and its folder ships; name a test *_test.cpp, what tests share test_*, or move the "
          "file into a folder of its own");
  }
}

void check_accepted(const Paths& now, const Paths& accepted) {
  std::string changes;
  for (const std::string& path : now)
    if (!accepted.contains(path)) changes += path + " is new\n";
  for (const std::string& path : accepted)
    if (!now.contains(path)) changes += path + " is gone\n";
  if (!changes.empty())
    throw HandoutError(
        "the handout is not the one of handout/packed.txt:\n" + changes +
        "Look at each file; then \"hairgrade handout --accept --out FILE.tar.gz\" writes the list anew");
}

void check_canary(const Files& handout, const Paths& solved) {
  for (const auto& [path, bytes] : handout)
    if (!solved.contains(path) && bytes.find(canary) != std::string::npos)
      throw HandoutError(path + " says " + canary + ": it, or a part of it, is not for students");
}

void check_reference_lines(const Files& handout, const Files& reference, const Paths& solved) {
  struct Secret {
    std::string_view letters;
    std::string place;  // "conj_grad.cpp:17"
  };
  std::deque<Letters> read;
  std::unordered_map<std::string_view, std::vector<Secret>> secrets;  // by the first letters of a run
  for (const auto& [name, text] : reference)
    for (const Comments comments : {Comments::with, Comments::without})
      for (const Run& run : runs_of(read.emplace_back(letters_of(text, comments))))
        secrets[run.letters.substr(0, least_letters)].push_back(
            {run.letters, name + ":" + std::to_string(run.line)});
  for (const auto& [path, text] : handout) {
    if (solved.contains(path)) continue;
    for (const Comments comments : {Comments::with, Comments::without}) {
      const Letters letters = letters_of(text, comments);
      const std::string_view all = letters.text;
      for (std::size_t i = 0; i + least_letters <= all.size(); ++i) {
        const auto found = secrets.find(all.substr(i, least_letters));
        if (found == secrets.end()) continue;
        for (const Secret& secret : found->second)
          if (all.substr(i).starts_with(secret.letters))
            throw HandoutError(path + ":" + std::to_string(letters.line[i]) +
                               ": what it says stands in reference/" + secret.place +
                               ", too; write it in another way");
      }
    }
  }
}

bool carries_canary(const std::string& text) {
  // A script's first line names its interpreter, a page's may be its document type.
  std::istringstream in(text);
  std::string line;
  for (int number = 1; number <= 3 && std::getline(in, line); ++number)
    if (line.find(canary) != std::string::npos) return true;
  return false;
}

}  // namespace grader::package
