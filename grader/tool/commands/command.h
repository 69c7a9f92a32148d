// STAFF ONLY. The commands of hairgrade, a file each. A new command has a file here, a line below and a row
// in kCommands.
#pragma once

#include <atomic>
#include <functional>

namespace CLI {  // NOLINT(readability-identifier-naming): it is the library's name
class App;
}

namespace grader::inline tool {

// A command declares its options when it is added; `run` reads them, does the work and returns hairgrade's
// exit code. It throws BadInput for wrong input (2), and any other exception for a fault of the grader (1).
struct Command {
  CLI::App* options;
  std::function<int()> run;
};
inline constexpr int kInterrupted = 130;  // finished results are kept
using AddCommand = Command (*)(CLI::App& hairgrade);

Command add_grade(CLI::App& hairgrade);
Command add_compare(CLI::App& hairgrade);
Command add_handout(CLI::App& hairgrade);
Command add_package(CLI::App& hairgrade);
Command add_gradescope(CLI::App& hairgrade);
Command add_secret(CLI::App& hairgrade);
Command add_samples(CLI::App& hairgrade);
Command add_log(CLI::App& hairgrade);
Command add_diff(CLI::App& hairgrade);
Command add_export(CLI::App& hairgrade);
Command add_forget(CLI::App& hairgrade);
Command add_set(CLI::App& hairgrade);
Command add_excuse(CLI::App& hairgrade);
Command add_comment(CLI::App& hairgrade);
Command add_comments(CLI::App& hairgrade);
Command add_request(CLI::App& hairgrade);
Command add_requests(CLI::App& hairgrade);
Command add_answer(CLI::App& hairgrade);
Command add_enter(CLI::App& hairgrade);
Command add_late_days(CLI::App& hairgrade);
Command add_unset(CLI::App& hairgrade);
Command add_hold(CLI::App& hairgrade);
Command add_unhold(CLI::App& hairgrade);
Command add_reproduce(CLI::App& hairgrade);
Command add_try(CLI::App& hairgrade);
Command add_whatif(CLI::App& hairgrade);
Command add_similar(CLI::App& hairgrade);
Command add_gradebook(CLI::App& hairgrade);
Command add_feedback(CLI::App& hairgrade);
Command add_review(CLI::App& hairgrade);
Command add_site(CLI::App& hairgrade);
Command add_new_course(CLI::App& hairgrade);
Command add_next(CLI::App& hairgrade);
Command add_prairielearn(CLI::App& hairgrade);
Command add_collect(CLI::App& hairgrade);

inline constexpr AddCommand kCommands[] = {
    add_new_course, add_next,      add_grade,   add_compare,   add_handout, add_package,      add_gradescope,
    add_secret,     add_samples,   add_similar, add_log,       add_diff,    add_export,       add_forget,
    add_set,        add_excuse,    add_comment, add_comments,  add_request, add_requests,     add_answer,
    add_enter,      add_late_days, add_unset,   add_hold,      add_unhold,  add_whatif,       add_gradebook,
    add_feedback,   add_review,    add_site,    add_reproduce, add_try,     add_prairielearn, add_collect};

// After the first call, Ctrl-C, SIGTERM or SIGHUP set this flag (SIGHUP does nothing under nohup).
const std::atomic<bool>& note_interruptions();

}  // namespace grader::tool
