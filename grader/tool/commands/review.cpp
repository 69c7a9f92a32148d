// STAFF ONLY. `hairgrade review`: a TA decides, in a browser.
#include <chrono>
#include <iostream>
#include <thread>

#include "grader/class_folder/class_files.h"
#include "grader/class_folder/folder_of_grades.h"
#include "grader/course/input.h"
#include "grader/review/desk.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct Review : OfARecord {
  std::string as = user();
  int port = 0;
  std::vector<std::string> graders;
  bool by_section = false;
};

int review_class(const Review& options) {
  if (options.as.empty() || options.as.size() > 100 || options.as != printable(options.as))
    throw BadInput("--as " + printable(options.as) + ": is no name; write one such as ada");
  const std::atomic<bool>& ended = note_interruptions();
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  Desk desk(*record, options.as, options.hand_in.empty() ? "The class" : options.hand_in);
  if (!options.graders.empty())
    desk.list().share(options.graders, options.by_section ? ShareBy::section : ShareBy::evenly);
  {
    const hair::LocalServer server(options.port, kMostSavedBytes,
                                   [&](const hair::WebRequest& request) { return desk.answer(request); });
    const std::string& host = server.address().host;
    const std::string port = host.substr(host.find(':') + 1);
    std::cout << server.address().url() << "\nOpen this in a browser. From another machine first: ssh -L "
              << port << ":" << host << " THIS_MACHINE. Ctrl-C ends it; all decisions of " << options.as
              << " are kept." << std::endl;
    while (!ended) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  desk.list().open("");
  std::cout << "\nThe pages are written: some seconds for a large class." << std::endl;
  if (const std::optional<FolderLock> lock = FolderLock::take(options.folder, ended, std::cerr))
    write_class_files(options.folder, *record);
  return 0;
}

}  // namespace

Command add_review(CLI::App& hairgrade) {
  const auto options = std::make_shared<Review>();
  CLI::App* command = hairgrade.add_subcommand("review", "Decide what needs a person, in a browser");
  needed_elsewhere(command->add_option("GRADES", options->folder, "The folder of grades"), options->folder,
                   kGrades);
  add_hand_in(*command, options->hand_in);
  command->add_option("--as", options->as, "The name that decisions have (default: yours here)");
  command->add_option("--port", options->port, "The server's port (default: a free one)")
      ->check(CLI::Range(1, 65535));
  command->add_option("--graders", options->graders, "Share the work out to these TAs: ada,ben")
      ->delimiter(',');
  command
      ->add_option_function<std::string>(
          "--by", [options](const std::string& by) { options->by_section = by == "section"; },
          "Share by section, or evenly (the default)")
      ->check(CLI::IsMember({"section", "evenly"}));
  return {command, [options] { return review_class(*options); }};
}

}  // namespace grader::tool
