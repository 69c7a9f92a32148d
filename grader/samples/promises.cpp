// STAFF ONLY. Finds quoted words in the sentences of headers.
#include "grader/samples/promises.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;  // of a header

// A comment's text, or what stands behind code in a line.
std::string comment_in(const std::string& line) {
  const std::size_t slashes = line.find("//");
  if (slashes == std::string::npos) return "";
  std::istringstream words(line.substr(slashes + 2));
  std::string text;
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool is_only_a_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && line.compare(first, 2, "//") == 0;
}

// "E. Hairer" goes on behind the full stop.
bool is_initial(const std::string& text, std::size_t stop) {
  return stop > 0 && std::isupper(static_cast<unsigned char>(text[stop - 1])) != 0 &&
         (stop == 1 || text[stop - 2] == ' ');
}

void split(const std::string& paragraph, std::vector<std::string>& sentences) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < paragraph.size(); ++i) {
    const bool ends = i + 1 == paragraph.size() ||
                      (paragraph[i] == '.' && paragraph[i + 1] == ' ' && !is_initial(paragraph, i));
    if (!ends) continue;
    sentences.push_back(paragraph.substr(begin, i + 1 - begin));
    begin = i + 2;
  }
}

// Whether `words` stand in the sentences, which `mark` is called for. Words may go from one sentence into the next.
template <class Mark>
bool find_words(const std::vector<Promise>& sentences, const std::string& words, const Mark& mark) {
  std::string all;
  std::vector<std::size_t> begins;
  for (const Promise& one : sentences) {
    begins.push_back(all.size());
    all += one.sentence + " ";
  }
  bool found = false;
  for (std::size_t at = all.find(words); at != std::string::npos && !words.empty();
       at = all.find(words, at + 1)) {
    found = true;
    for (std::size_t i = 0; i < begins.size(); ++i)
      if (begins[i] < at + words.size() && at < begins[i] + sentences[i].sentence.size()) mark(i);
  }
  return found;
}

std::string in_a_cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text;
}

}  // namespace

std::vector<std::string> sentences_of(const std::string& header) {
  std::vector<std::string> sentences;
  std::string paragraph;
  const auto end_paragraph = [&] {
    split(paragraph, sentences);
    paragraph.clear();
  };
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('}')) continue;  // it names a namespace
    const std::string comment = comment_in(line);
    if (!is_only_a_comment(line) || comment.empty()) end_paragraph();
    if (!comment.empty()) paragraph += (paragraph.empty() ? "" : " ") + comment;
  }
  end_paragraph();
  return sentences;
}

std::vector<Promises> promises_of(const std::filesystem::path& project, const std::vector<Sample>& samples) {
  std::vector<Promises> all;
  for (const Exercise& exercise : read_course(project / "handout/exercises.json").exercises) {
    Promises promises{exercise.id, exercise.header, {}};
    const std::string header = hair::read_file(project / exercise.header, kMostBytes, "a header");
    for (std::string& sentence : sentences_of(header))
      promises.sentences.push_back({std::move(sentence), {}, false});
    all.push_back(std::move(promises));
  }
  for (const Sample& sample : samples) {
    const auto fail = [&](const std::string& key, const std::string& words) {
      throw BadInput("sample " + sample.name + ": \"" + key + " " + words +
                     "\": no header of its exercises has these words");
    };
    for (const std::string& words : sample.breaks) {
      bool found = false;
      for (Promises& of : all)
        if (std::ranges::find(sample.listed, of.exercise) != sample.listed.end())
          found |= find_words(of.sentences, words,
                              [&](std::size_t i) { of.sentences[i].broken_by.push_back(&sample); });
      if (!found) fail("breaks", words);
    }
    const auto of = std::ranges::find(all, sample.group, &Promises::exercise);
    for (const std::string& words : sample.explains)
      if (of == all.end() ||
          !find_words(of->sentences, words, [&](std::size_t i) { of->sentences[i].explained = true; }))
        fail("explains", words);
  }
  return all;
}

std::string table_of(const std::vector<Promises>& promises, const FindFailedCase& find_failed_case) {
  std::ostringstream out;
  out << "<!-- STAFF ONLY. The promises of the exercises' headers, and the programs that lose points for "
         "ignoring them. -->\n"
         "# Promises\n\n"
         "*Made by:* `hairgrade grade --class build/release/grader/samples/class --out GRADES`, then "
         "`hairgrade samples --promises "
         "--graded GRADES > grader/samples/PROMISES.md`.\n"
         "`samples_test` holds its sentences, programs and categories to the headers and the samples. Inputs "
         "are those of one secret, in "
         "the first category.\n\n";
  const bool graded = find_failed_case != nullptr;
  for (const Promises& of : promises) {
    out << "## " << of.exercise << ": " << of.header
        << "\n\n| the header says | a program ignores it | and loses |"
        << (graded ? " at the input | where a student reads |" : "") << "\n|---|---|---|"
        << (graded ? "---|---|" : "") << "\n";
    for (const Promise& promise : of.sentences) {
      if (promise.explained && promise.broken_by.empty()) continue;
      if (promise.broken_by.empty())
        out << "| " << in_a_cell(promise.sentence) << " | | |" << (graded ? " | |" : "") << "\n";
      for (const Sample* sample : promise.broken_by) {
        const ExpectedResult& expected = sample->expected.at(of.exercise);
        std::string lost;
        for (const std::string& title : expected.failed) lost += (lost.empty() ? "" : "; ") + title;
        out << "| " << in_a_cell(sample == promise.broken_by.front() ? promise.sentence : "") << " | `"
            << sample->name << "`: " << in_a_cell(sample->shows) << " | "
            << in_a_cell(lost.empty() ? expected.status : lost) << " |";
        if (graded) {
          const FailedCase failed = find_failed_case(*sample, of.exercise);
          out << " " << in_a_cell(failed.input) << " | " << in_a_cell(failed.student_reads) << " |";
        }
        out << "\n";
      }
    }
    out << "\n";
  }
  return out.str();
}

}  // namespace grader
