// STAFF ONLY. `hairgrade comment` and `comments` put words on reports, which several students may have;
// `request`, `requests` and `answer` note that students ask for another look.
#include <iostream>

#include "grader/course/input.h"
#include "grader/report/facts/text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct WordsOptions : OfARecord {
  std::string place, text;
  std::int64_t id = 0;
  std::optional<double> points;
};

int comment(const WordsOptions& options) {
  if (options.text.empty() == (options.id == 0))
    throw BadInput("give the comment's text, or --id of an earlier one");
  if (options.id != 0 && options.points)
    throw BadInput("--points: comment " + std::to_string(options.id) +
                   " has its own; `hairgrade comments` changes them");
  return change_record(options, [&](Record& record, const std::string& name) {
    record.decide(name, {.kind = DecisionKind::comment,
                         .place = options.place == kWhole ? "" : options.place,
                         .number = options.points.value_or(0),
                         .why = options.text,
                         .comment = options.id});
  });
}

void list(const std::vector<Comment>& comments) {
  for (const Comment& one : comments)
    std::cout << one.id << "  " << (one.points == 0 ? "" : shown_points(one.points) + " points  ")
              << printable(one.text, 2000) << "\n    " << who_have(one) << "\n";
}

int change(const WordsOptions& options) {
  if (options.id == 0) {
    list(open_record(options.folder, options.hand_in)->comments());
    return 0;
  }
  return change_record(options, [&](Record& record, const std::string&) {
    const Comment before = record.comment(options.id);
    record.change_comment(options.id, options.text.empty() ? before.text : options.text,
                          options.points.value_or(before.points));
    list({record.comment(options.id)});
  });
}

void add_text(CLI::App& command, WordsOptions& options) {
  command.add_option("TEXT", options.text, "For the student");
  command.add_option("--points", options.points, "So many more at the place, or less: --points -2");
  add_folder(command, options);
}

int ask(const WordsOptions& options) {
  return change_record(options, [&](Record& record, const std::string& name) {
    const std::int64_t id = record.ask(name, options.place == kWhole ? "" : options.place, options.text);
    std::cout << (id == 0 ? "was asked before" : "request " + std::to_string(id)) << "\n";
  });
}

// Open ones come last, where a terminal shows them.
int list_requests(const OfARecord& options) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  const NamesForPeople people = record->names_for_people();
  std::size_t count = 0;
  for (const bool open : {false, true})
    for (const Request& one : record->requests()) {
      if (one.is_open() != open) continue;
      count += open;
      std::cout << one.id << "  " << one.at << "  " << called(one.name, people) << " " << printable(one.place)
                << "  " << printable(one.text, 2000) << "\n";
      if (!open)
        std::cout << "    " << one.answered << "  " << printable(one.answered_by) << "  "
                  << printable(one.answer, 2000) << "\n";
    }
  std::cout << count << " open\n";
  return 0;
}

}  // namespace

Command add_comment(CLI::App& hairgrade) {
  const auto options = std::make_shared<WordsOptions>();
  CLI::App* command = hairgrade.add_subcommand("comment", "Say something on a student's report");
  add_name(*command, *options);
  add_place_of_words(*command, options->place);
  add_text(*command, *options);
  command->add_option("--id", options->id, "Of an earlier comment, in place of the text");
  return {command, [options] { return comment(*options); }};
}

Command add_comments(CLI::App& hairgrade) {
  const auto options = std::make_shared<WordsOptions>();
  CLI::App* command = hairgrade.add_subcommand(
      "comments", "List comments with their students; or change one, for all who have it");
  command->add_option("ID", options->id, "Of the comment that changes");
  add_text(*command, *options);
  return {command, [options] { return change(*options); }};
}

Command add_request(CLI::App& hairgrade) {
  const auto options = std::make_shared<WordsOptions>();
  CLI::App* command = hairgrade.add_subcommand("request", "Note that a student asks for another look");
  add_name(*command, *options);
  add_place_of_words(*command, options->place);
  command->add_option("TEXT", options->text, "The student's words")->required();
  add_folder(*command, *options);
  return {command, [options] { return ask(*options); }};
}

Command add_requests(CLI::App& hairgrade) {
  const auto options = std::make_shared<WordsOptions>();
  CLI::App* command = hairgrade.add_subcommand("requests", "List what students asked");
  add_folder(*command, *options);
  return {command, [options] { return list_requests(*options); }};
}

Command add_answer(CLI::App& hairgrade) {
  const auto options = std::make_shared<WordsOptions>();
  CLI::App* command = hairgrade.add_subcommand("answer", "Answer a request, once; the student sees it");
  command->add_option("ID", options->id, "Of the request")->required();
  command->add_option("TEXT", options->text, "The answer")->required();
  add_folder(*command, *options);
  return {command, [options] {
            return change_record(*options, [&](Record& record, const std::string&) {
              record.answer(options->id, options->text);
            });
          }};
}

}  // namespace grader::tool
