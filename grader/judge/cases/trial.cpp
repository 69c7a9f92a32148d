// STAFF ONLY. Compares numbers of a student with the reference's, and describes the first failure.
#include "grader/judge/cases/trial.h"
#include "handout/check/hint.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <utility>

namespace grader::inline judge {
namespace {

constexpr std::pair<double, const char*> kFactors[] = {{-1, "-1"},       {2, "2"},       {1.0 / 2, "1/2"},
                                                       {-2, "-2"},       {-0.5, "-1/2"}, {3, "3"},
                                                       {1.0 / 3, "1/3"}, {4, "4"},       {1.0 / 4, "1/4"}};

std::string told_of(double factor) {
  for (const auto& [value, text] : kFactors)
    if (std::abs(factor - value) <= 1e-6 * std::abs(value))
      return "Its numbers are " + std::string(text) + " times what is expected: a " +
             (value < 0 ? "sign?" : "factor?");
  return "";
}

// Describes wrong numbers by one of a few sentences: a number that code may choose could carry a hidden input
// out. Returns an empty text if no mistake is clear, and for a factor that no ordinary mistake makes.
std::string hint_for_students(const checks::Hint& hint) {
  switch (hint.looks) {
    case checks::Looks::like_nothing:
      return "";
    case checks::Looks::never_set:
      return "One of its numbers was never set.";
    case checks::Looks::huge:
      return "One of its numbers is huge: was it made from a variable that was never set, or read beyond an "
             "end?";
    case checks::Looks::tiny:
      return "One of its numbers is tiny: was it made from a variable that was never set, or read beyond an "
             "end?";
    case checks::Looks::no_number:
      return "One of its numbers is no number: 0/0, a division by 0, or the root of a negative one?";
    case checks::Looks::zero:
      return "All of it is 0: never written, left out by a condition or a loop's bounds, or terms that "
             "cancel?";
    case checks::Looks::unchanged:
    case checks::Looks::filled:
      return "It is an input, or what stood there before the call, unchanged: never written, or nothing "
             "done?";
    case checks::Looks::wrong_at_the_end:
      return "It is right but for its last entries: a loop's bound?";
    case checks::Looks::wrong_at_the_beginning:
      return "It is right but for its first entries: a loop's bound?";
    case checks::Looks::a_factor:
      return told_of(hint.number);
    case checks::Looks::transposed:
      return "A matrix is the transpose of what is expected.";
    case checks::Looks::wrong_signs:
      return "It is right but for signs of some entries.";
  }
  return "";
}

std::span<const double> as_span(const Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

// Returns the first NaN, or the largest difference.
std::optional<Eigen::Index> worst_entry(const Compared& numbers) {
  const auto& [actual, expected, block, before, bound] = numbers;
  std::optional<Eigen::Index> worst;
  double error = 0;
  for (Eigen::Index i = 0; i < expected.size() && !std::isnan(error); ++i)
    if (const double one = std::abs(actual[i] - expected[i]); !worst || !(one <= error)) {
      error = one;
      worst = i;
    }
  return worst;
}

double in_limits(double error, double limit) {
  const double ratio = error / limit;
  return std::isfinite(error) && std::isfinite(ratio) ? ratio : kNoNumber;
}

std::string times_the_limit(double error, double limit) {
  if (!std::isfinite(error)) return "not a finite number";
  const double ratio = in_limits(error, limit);
  if (ratio == kNoNumber) return "above its limit, 0";
  std::ostringstream text;
  text.precision(3);
  text << ratio << " times the limit";
  return text.str();
}

}  // namespace

MessageReader Trial::ask(const MessageWriter& request, const Products& products, const std::string& stopped) {
  ++cases_;
  case_failed_ = false;
  if (!aside_) student_.begin_case();
  return ask_on(request, products, stopped);
}

MessageReader Trial::ask_on(const MessageWriter& request, const Products& products,
                            const std::string& stopped) {
  return reply_of(student_.ask(request, products), stopped);
}

MessageReader Trial::reply_of(Answer answer, const std::string& stopped) const {
  switch (answer.outcome) {
    case Outcome::done:
      return std::move(answer.reply);
    case Outcome::stopped:
      fail(Status::wrong, stopped, "stopped", stopped.empty() ? "" : "It " + stopped + ".");
    case Outcome::not_implemented:
      fail(Status::not_implemented, "not implemented yet", answer.note);
    case Outcome::threw:
      fail(Status::crashed, "the code threw an exception", "exception: " + answer.note);
    case Outcome::out_of_memory:
      fail(Status::out_of_memory, "the code asked for more memory than there is", answer.note);
    case Outcome::crashed:
      fail(Status::crashed, "the program ended in the middle of the call", answer.note);
    case Outcome::timed_out:
      fail(Status::timed_out, "no answer within the time limit", answer.note);
    case Outcome::broke_rules:
      fail(Status::broke_rules,
           "the code " + (answer.note.starts_with("it tried") ? answer.note.substr(3)
                          : answer.note.starts_with("used up")
                              ? "broke the rules before, and is not asked again"
                              : std::string("sent the grader a message that does not fit the request")),
           answer.note,
           answer.note == kNestedCalls
               ? "Its calls of given functions lie within each other too deeply: does a "
                 "matrix or a force call what uses it?"
               : "");
    case Outcome::cannot_load:
      fail(Status::does_not_compile, "a function is missing, or its declaration differs from the header's",
           answer.note);
  }
  fail(Status::wrong, "no answer", "unknown outcome");
}

void Trial::expect(bool holds, const std::string& feedback, const std::string& detail) {
  if (!holds) wrong(feedback, detail);
}

void Trial::require(bool holds, const std::string& feedback, const std::string& detail,
                    const std::string& hint) {
  if (!holds) fail(Status::wrong, feedback, detail, hint);
}

void Trial::expect_at_most(double error, Bound bound, const std::string& what, const std::string& detail) {
  expect_at_most(error, bound, what, Compared{}, detail);
}

void Trial::expect_at_most(double error, Bound bound, const std::string& what, const Compared& numbers,
                           const std::string& detail) {
  double& nearest = nearest_[what];
  if (error > bound.promised) nearest = std::max(nearest, (error - bound.promised) / bound.rest);
  const double most = bound.most();
  // A bound that is not finite would accept anything.
  if (error <= most && std::isfinite(most)) return;
  compared_ = numbers;
  std::ostringstream text;
  text.precision(17);
  text << what << ": " << error << ", bound " << most << (detail.empty() ? "" : "; ") << detail;
  if (const auto worst = worst_entry(numbers))
    text << "; worst entry " << *worst << ": " << numbers.actual[*worst] << ", expected "
         << numbers.expected[*worst];
  wrong(what + " is " + times_the_limit(error, most), text.str(),
        hint_for_students(checks::find_hint(as_span(numbers.actual), as_span(numbers.expected),
                                            numbers.bound.value_or(most), numbers.block,
                                            as_span(numbers.before))),
        in_limits(error, most));
}

void Trial::expect_near(const Compared& numbers, Bound bound, const std::string& what) {
  const auto worst = worst_entry(numbers);
  expect_at_most(worst ? std::abs(numbers.actual[*worst] - numbers.expected[*worst]) : 0, bound, what,
                 numbers);
}

void Trial::expect_close(const Compared& numbers, Bound bound, const std::string& what) {
  expect_at_most((numbers.actual - numbers.expected).norm(), bound, what, numbers);
}

void Trial::wrong(const std::string& feedback, const std::string& detail, const std::string& hint,
                  double error_in_limits) {
  if (when_wrong_ == WhenWrong::stop) fail(Status::wrong, feedback, detail, hint, error_in_limits);
  if (!case_failed_) ++failed_;
  case_failed_ = true;
}

void Trial::fail(Status status, const std::string& feedback, const std::string& detail,
                 const std::string& hint, double error_in_limits) const {
  std::string text = description_ + (description_.empty() || detail.empty() ? "" : ": ") + detail;
  if (!call_.empty()) text += (text.empty() ? "" : "; ") + call_;
  throw CaseFailed{status, feedback, text, hint, error_in_limits};
}

void Trial::ask_aside(const std::function<void()>& questions) {
  const WhenWrong when_wrong = std::exchange(when_wrong_, WhenWrong::stop);
  const bool aside = std::exchange(aside_, true);
  const int cases = cases_;
  const bool case_failed = case_failed_;
  const std::map<std::string, double> nearest = nearest_;
  try {
    questions();
  } catch (const CaseFailed&) {
    // A question without an answer excuses nothing.
  }
  when_wrong_ = when_wrong;
  aside_ = aside;
  compared_ = {};
  cases_ = cases;
  case_failed_ = case_failed;
  nearest_ = nearest;
}

std::optional<CaseCount> count_of(const Category& category, Student& student, const Random& source) {
  Trial trial(student, source, WhenWrong::count);
  try {
    category.run(trial);
  } catch (const CaseFailed&) {
    return {};
  } catch (const std::exception&) {  // a malformed message, or wrong answers that we can't use
    return {};
  }
  if (trial.failed() == 0) return {};
  const int cases = std::max(trial.cases(), trial.failed());
  return CaseCount{cases, cases - trial.failed()};
}

}  // namespace grader::judge
