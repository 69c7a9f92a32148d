#include "hair/lab/commands/study_shell.h"

#include <unistd.h>

#include <cctype>
#include <iostream>

#include "hair/io/machine.h"
#include "hair/lab/run/interruption.h"

namespace hair {

CLI::App* add_study(CLI::App& program, const OtherCommand& command, ShellOptions& options, const char* quick,
                    bool out_is_required) {
  CLI::App* app = program.add_subcommand(command.name, command.what);
  app->add_option("--out", options.out, "The folder for page, tables and record")->required(out_is_required);
  options.when_quick = quick;
  std::string help = quick;
  help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  app->add_flag("--quick", options.quick, help);
  return app;
}

StudyShell::StudyShell(const ShellOptions& options, const std::string& command, const std::string& record,
                       std::vector<std::string> files, WhenInterrupted leaves)
    : options_(options),
      kind_{command, record, "{\n  \"program\": \"" + command + '"', std::move(files)},
      interrupted_(catch_interruption(
          leaves == WhenInterrupted::loses
              ? "\nhairlab: stopping; once more ends at once\n"
              : "\nhairlab: stopping, what is finished is kept; once more ends at once\n")),
      terminal_(isatty(STDERR_FILENO) != 0) {
  if (options.writes) folder_.emplace(options.out, kind_);
}

void StudyShell::say(const std::string& what) const {
  if (terminal_) std::cerr << "\r\x1b[K" << what << std::flush;
}

void StudyShell::keep(const OrderedJson& record, Page page,
                      const std::vector<std::pair<std::string, std::vector<Row>>>& tables) {
  if (kept_) folder_.emplace(options_.out, kind_);
  const std::string machine = measured_on(this_machine());
  OrderedJson whole = {{"program", kind_.command}, {"quick", options_.quick}, {"machine", machine}};
  whole.update(record);
  page.paragraphs.push_back(machine + (options_.quick ? " A quick study: " + options_.when_quick + "." : ""));
  for (const auto& [name, rows] : tables)
    if (!rows.empty()) write_whole(*folder_, name, csv_of(rows));
  write_whole(*folder_, "index.html", to_html(page));
  write_whole(*folder_, kind_.record, record_text(whole));
  folder_->keep();
  kept_ = true;
}

int StudyShell::end(bool finished, const std::string& more) const {
  say("");
  if (kept_) std::cout << folder_->then("index.html").string() << more << std::endl;
  if (finished) return 0;
  std::cerr << "hairlab: interrupted; " << (kept_ ? "what is finished is kept" : "nothing is written")
            << "\n";
  return kInterrupted;
}

}  // namespace hair
