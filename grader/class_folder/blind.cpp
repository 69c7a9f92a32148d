// STAFF ONLY. Replaces names by codes.
#include "grader/class_folder/blind.h"

#include <algorithm>
#include <random>
#include <set>

namespace grader::inline class_folder {
namespace {

// Draws letters and digits that look different from each other.
std::string random_code() {
  constexpr std::string_view kLetters = "23456789abcdefghjkmnpqrstuvwxyz";
  std::random_device random;  // is the kernel's
  std::uniform_int_distribution<std::size_t> any(0, kLetters.size() - 1);
  std::string code = "code-";
  for (int i = 0; i < 8; ++i) code += kLetters[any(random)];
  return code;
}

}  // namespace

std::vector<HandIn> hand_ins_of(const std::vector<Submission>& submissions) {
  std::vector<HandIn> all;
  for (const Submission& one : submissions) {
    Owner owner = one.owner;
    if (owner.name.empty() && owner.id.empty() && owner.email.empty())
      owner.name = one.known_as.empty() ? one.name : one.known_as;
    all.push_back({one.name, owner, one.system.empty() ? "folders" : one.system, one.known_as});
  }
  return all;
}

void give_codes(std::vector<Submission>& submissions, const std::map<std::string, std::string>& known) {
  std::set<std::string> taken;
  for (const auto& [name, code] : known) taken.insert(code);
  for (Submission& one : submissions) {
    const bool first = one.known_as.empty();
    if (first) one.known_as = one.name;
    if (const auto found = known.find(one.known_as); found != known.end()) {
      one.name = found->second;
      continue;
    }
    if (!first) continue;
    do one.name = random_code();
    while (!taken.insert(one.name).second);
  }
  std::ranges::sort(submissions, {}, &Submission::name);
}

void hide(const HiddenNames& names, Intake& intake) {
  for (auto* lines : {&intake.taken_for, &intake.notices, &intake.remarks})
    for (std::string& line : *lines) line = names.in(line);
}

void hide(const HiddenNames& names, std::vector<Accounted>& listed) {
  for (Accounted& file : listed)
    for (std::string* text : {&file.path, &file.reason, &file.whose}) *text = names.in(*text);
}

void hide(const HiddenNames& names, SubmissionResult& result) {
  const auto cover = [&](std::string& text) { text = names.in_own(text, result.name); };
  result.origin.clear();
  cover(result.note);
  cover(result.about);
  for (std::string& remark : result.remarks) cover(remark);
  for (Decided& one : result.decided)
    for (std::string* text : {&one.text, &one.conflict}) cover(*text);
  for (ExerciseResult& exercise : result.exercises) {
    for (std::string* text : {&exercise.feedback, &exercise.compiler_messages, &exercise.staff_log})
      cover(*text);
    for (Said& said : exercise.said)
      for (std::string* text : {&said.code, &said.text}) cover(*text);
    cover(exercise.source);
    for (CaseResult& one : exercise.cases)
      for (std::string* text : {&one.feedback, &one.detail}) cover(*text);
  }
}

std::vector<ClassLine> blind(const std::vector<ClassLine>& lines) {
  std::vector<ClassLine> all;
  for (const ClassLine& line : lines)
    if (!line.hand_in.empty())
      all.push_back({line.hand_in, "", "", "", line.section, line.note.empty() ? "" : "on no roster"});
  return all;
}

}  // namespace grader::class_folder
