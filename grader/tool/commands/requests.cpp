// STAFF ONLY. `hairgrade request`, `requests` and `answer`: students ask for another look.
#include <iostream>

#include "grader/course/input.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct RequestOptions : OfARecord {
  std::string place, text;
  std::int64_t id = 0;
};

int ask(const RequestOptions& options) {
  return change_record(options, [&](Record& record, const std::string& name) {
    const std::int64_t id = record.ask(name, options.place == kWhole ? "" : options.place, options.text);
    std::cout << (id == 0 ? "was asked before" : "request " + std::to_string(id)) << "\n";
  });
}

// Open ones come last, where a terminal shows them.
int list(const OfARecord& options) {
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

Command add_request(CLI::App& hairgrade) {
  const auto options = std::make_shared<RequestOptions>();
  CLI::App* command = hairgrade.add_subcommand("request", "Note that a student asks for another look");
  add_name(*command, *options);
  add_place_of_words(*command, options->place);
  command->add_option("TEXT", options->text, "The student's words")->required();
  add_folder(*command, *options);
  return {command, [options] { return ask(*options); }};
}

Command add_requests(CLI::App& hairgrade) {
  const auto options = std::make_shared<RequestOptions>();
  CLI::App* command = hairgrade.add_subcommand("requests", "List what students asked");
  add_folder(*command, *options);
  return {command, [options] { return list(*options); }};
}

Command add_answer(CLI::App& hairgrade) {
  const auto options = std::make_shared<RequestOptions>();
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
