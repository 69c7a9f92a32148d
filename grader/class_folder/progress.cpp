// STAFF ONLY. Reports the progress of long work.
#include "grader/class_folder/progress.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

namespace grader::inline class_folder {
namespace {

constexpr double kMinute = 60;

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string about(double seconds) {
  if (seconds < kMinute) return "less than a minute";
  const long minutes = std::lround(seconds / kMinute);
  return minutes < 100 ? std::to_string(minutes) + " min"
                       : std::to_string(std::lround(seconds / 3600)) + " h";
}

}  // namespace

Progress::Progress(std::size_t total)
    : Progress(total, std::cerr, isatty(STDERR_FILENO) != 0, steady_seconds) {}

Progress::Progress(std::size_t total, std::ostream& out, bool terminal, std::function<double()> seconds)
    : total_(total),
      out_(out),
      terminal_(terminal),
      seconds_(std::move(seconds)),
      began_(seconds_()),
      said_(began_) {}

// Assumes that all remaining steps are work.
std::string Progress::left() const {
  if (worked_ == 0 || done_ >= total_) return "";
  const double each = (seconds_() - began_) / static_cast<double>(worked_);
  return ", about " + about(each * static_cast<double>(total_ - done_)) + " left";
}

void Progress::step(const std::string& what, bool worked) {
  ++done_;
  worked_ += worked;
  const std::string place = std::to_string(done_) + (terminal_ ? "/" : " of ") + std::to_string(total_);
  if (terminal_) {
    out_ << "[" << place << left() << "] " << what << std::endl;
  } else if (seconds_() - said_ >= kMinute && done_ < total_) {
    said_ = seconds_();
    out_ << place << " done" << left() << std::endl;
  }
}

}  // namespace grader::class_folder
