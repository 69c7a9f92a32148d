// STAFF ONLY. Writes pages that accuse nobody: they show two texts, and a person decides.
#include "grader/similar/similar_pages.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grader/course/input.h"
#include "hair/io/plot/html.h"

namespace grader::inline similar {
namespace {

namespace fs = std::filesystem;
using hair::Html, hair::html, hair::html_page;

// Bounds the shown pairs of an exercise; others are counted. Each person of a pair is in a group, or shown.
constexpr std::size_t kMostPairs = 100;

std::string per_cent(double part) {
  return std::to_string(std::lround(100 * part)) + " %";
}

const std::string& who(const SimilarFile& file) {
  return file.shown.empty() ? file.name : file.shown;
}

std::string page_of(const SimilarExercise& exercise, const SharedPair& pair) {
  return exercise.id + "-" + exercise.files[pair.one].name + "-" + exercise.files[pair.other].name + ".html";
}

std::string lines_of(Lines lines) {
  return std::to_string(lines.first) + "-" + std::to_string(lines.last);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Writes one text with its numbers. Lines that the other one has, too, are marked, and given lines are pale.
Html source(const std::string& text, const std::string& own, const std::vector<Lines>& shared) {
  const std::vector<std::string> lines = split(text), left = split(own);
  Html all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    const bool marked = std::any_of(shared.begin(), shared.end(), [&](Lines block) {
      return block.first <= number && number <= block.last;
    });
    const bool given = i < left.size() && left[i].empty() && !lines[i].empty();
    all += html("<li class=\"{}\">{}</li>\n", {marked ? "shared" : given ? "given" : "", lines[i]});
  }
  return html("<ol class=\"source\">\n{}</ol>\n", {all});
}

std::string pair_page(const SimilarExercise& exercise, const SharedPair& pair) {
  const SimilarFile &one = exercise.files[pair.one], &other = exercise.files[pair.other];
  std::vector<Lines> mine, theirs;
  Html blocks;
  for (const Match& block : pair.blocks) {
    mine.push_back(block.lines);
    theirs.push_back(block.other_lines);
    blocks += html("<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td></tr>\n",
                   {lines_of(block.lines), lines_of(block.other_lines), std::to_string(block.tokens)});
  }
  return html_page(
      exercise.id + ": " + who(one) + " and " + who(other),
      html("<h1>{}: {} and {}</h1>\n<p>{} of what {} wrote stands in {}'s file, too: {} tokens. Names, "
           "numbers, "
           "layout and comments are not compared. Marked lines are shared, pale ones were given to "
           "everybody.</p>\n<p><a href=\"index.html\">All pairs</a></p>\n<div class=\"beside\">\n"
           "<section><h2>{}</h2>\n{}</section>\n<section><h2>{}</h2>\n{}</section>\n</div>\n"
           "<table>\n<thead><tr><th>Lines of {}</th><th>Lines of {}</th><th>Tokens</th></tr></thead>\n"
           "<tbody>\n{}</tbody></table>\n",
           {exercise.file, who(one), who(other), per_cent(pair.part), who(one), who(other),
            std::to_string(pair.tokens), who(one), source(one.text, exercise.shared.own[pair.one], mine),
            who(other), source(other.text, exercise.shared.own[pair.other], theirs), who(one), who(other),
            blocks}));
}

Html pairs_table(const SimilarExercise& exercise) {
  Html rows;
  const std::vector<SharedPair>& pairs = exercise.shared.pairs;
  for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i)
    rows += html(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td><a href=\"{}\">side by side</a></td></tr>\n",
        {who(exercise.files[pairs[i].one]), who(exercise.files[pairs[i].other]), per_cent(pairs[i].part),
         std::to_string(pairs[i].tokens), std::to_string(pairs[i].of_many), page_of(exercise, pairs[i])});
  if (rows.text.empty()) return html("<p class=\"quiet\">No pair.</p>\n");
  if (pairs.size() > kMostPairs)
    rows += html("<tr><td colspan=\"6\">and {} more</td></tr>\n", {pairs.size() - kMostPairs});
  return html(
      "<table>\n<thead><tr><th>Who</th><th>Stands in the file of</th><th class=\"number\">Part</th><th "
      "class=\"number\">Tokens</th><th class=\"number\">Of these, many have</th><th></th></tr></thead>\n"
      "<tbody>\n{}</tbody></table>\n",
      {rows});
}

std::string names(const SimilarExercise& exercise, const std::vector<std::size_t>& files) {
  std::string list;
  for (const std::size_t file : files) list += (list.empty() ? "" : ", ") + who(exercise.files[file]);
  return list;
}

Html common_code(const SimilarExercise& exercise) {
  Html list;
  for (const CommonPiece& piece : exercise.shared.common) {
    const SimilarFile& first = exercise.files[piece.owners.front()];
    list += html("<li>{} people, as in lines {} of {}: {}</li>\n",
                 {piece.owners.size(), lines_of(piece.lines), who(first), names(exercise, piece.owners)});
  }
  if (list.text.empty()) return {};
  return html("<details><summary>Code that many share: {} pieces</summary>\n<ul>\n{}</ul>\n</details>\n",
              {exercise.shared.common.size(), list});
}

Html part_of(const SimilarExercise& exercise) {
  Html part = html("<h2>{}: {}</h2>\n", {exercise.id, exercise.file});
  for (const auto& group : groups_of(exercise.shared, exercise.files.size()))
    part += html("<p class=\"note\">A group of {}: {}</p>\n", {group.size(), names(exercise, group)});
  part += pairs_table(exercise);
  part += common_code(exercise);
  Html left_out;
  for (const NotCompared& one : exercise.shared.not_compared)
    left_out += html("<li>{}: {}</li>\n", {who(exercise.files[one.file]), one.why});
  if (!left_out.text.empty())
    part += html("<details><summary>Not compared: {}</summary>\n<ul>\n{}</ul>\n</details>\n",
                 {exercise.shared.not_compared.size(), left_out});
  return part;
}

}  // namespace

void write_similar_pages(const fs::path& out, const std::vector<SimilarExercise>& exercises,
                         const SimilarRules& rules) {
  Html parts;
  for (const SimilarExercise& exercise : exercises) {
    parts += part_of(exercise);
    const std::vector<SharedPair>& pairs = exercise.shared.pairs;
    for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i)
      write_file(out / page_of(exercise, pairs[i]), pair_page(exercise, pairs[i]));
  }
  write_file(
      out / "index.html",
      html_page("Similar hand-ins",
                html("<h1>Similar hand-ins</h1>\n<p>Pairs of whom one has {} or more of the other's own "
                     "code, beyond what everybody was given. For staff alone. It is no proof: who solves "
                     "a short task as the text says writes what others write. Look at both sources, and "
                     "ask.</p>\n{}",
                     {per_cent(rules.least_part), parts})));
}

}  // namespace grader::similar
