#include "hair/truth/motion_cache.h"

#include <bit>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "hair/io/digest.h"
#include "hair/io/files/kept_file.h"
#include "hair/strand/variation.h"

namespace hair {

namespace {

constexpr KeptKind kKind{"hairlab: an accurate motion, format 1", ".motion"};

// f at the start, and at states a hundredth of their scales from it, at other times.
std::string forces_of(const Problem& problem, Ode& ode) {
  constexpr int kLooks = 4;
  Digest digest;
  Variation variation(1);
  const Eigen::VectorXd start = ode.start(), scales = ode.scales();
  Eigen::VectorXd y = start, dy(ode.size());
  ode.start_span(0);
  for (int look = 0; look < kLooks; ++look) {
    ode.rates(problem.duration * look / kLooks, y, dy);
    digest.add(dy);
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] = start[i] + variation.uniform(-0.01, 0.01) * scales[i];
  }
  return digest.text();
}

// Writes numbers as their bits, so that reading gives the same numbers on any machine.
void put(std::string& text, std::uint64_t bits) {
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), bits, 16).ptr;
  text.append(digits.data(), end);
  text += ' ';
}

void put(std::string& text, const Eigen::VectorXd& values) {
  for (const double value : values) put(text, std::bit_cast<std::uint64_t>(value));
}

// Reads a file's text. After the first missing part, all later parts are missing, too.
class Rest {
 public:
  explicit Rest(std::string_view text) : text_(text) {}

  std::string_view line() {
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos) return fail();
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    return line;
  }
  std::uint64_t number() {
    std::uint64_t bits = 0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), bits, 16);
    if (error != std::errc() || end == text_.data() + text_.size() || *end != ' ') {
      fail();
      return 0;
    }
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()) + 1);
    return bits;
  }
  double real() { return std::bit_cast<double>(number()); }
  Eigen::VectorXd reals(Eigen::Index count) {
    Eigen::VectorXd values(count);
    for (double& value : values) value = real();
    return values;
  }
  bool is_whole() const { return !failed_ && text_.empty(); }

 private:
  std::string_view fail() {
    failed_ = true;
    text_ = {};
    return {};
  }

  std::string_view text_;
  bool failed_ = false;
};

}  // namespace

std::string motion_key(const Problem& problem, Ode& ode, const std::string& method) {
  return "problem " + content_of(problem) + "; forces " + forces_of(problem, ode) + "; " + method;
}

std::optional<AccurateMotion> find_motion(const std::filesystem::path& folder, const std::string& key) {
  const std::optional<std::string> text = find_kept(folder, kKind, key);
  if (!text) return {};
  Rest rest(*text);
  AccurateMotion motion;
  motion.method = rest.line();
  motion.agreement = rest.real();
  motion.inextensible = rest.number() != 0;
  motion.cpu_seconds = rest.real();
  motion.evaluations = static_cast<long>(rest.number());
  const std::uint64_t states = rest.number(), size = rest.number();
  // Each number takes two bytes at least.
  if (states > text->size() || size > text->size() || states * size > text->size()) return {};
  for (std::uint64_t k = 0; k < states; ++k) {
    Eigen::VectorXd x = rest.reals(static_cast<Eigen::Index>(size));
    Eigen::VectorXd v = rest.reals(static_cast<Eigen::Index>(size));
    motion.states.push_back({std::move(x), std::move(v)});
  }
  if (!rest.is_whole()) return {};
  motion.from_cache = true;
  return motion;
}

void keep_motion(const std::filesystem::path& folder, const std::string& key, const AccurateMotion& motion) {
  std::string text = motion.method + '\n';
  put(text, std::bit_cast<std::uint64_t>(motion.agreement));
  put(text, static_cast<std::uint64_t>(motion.inextensible));
  put(text, std::bit_cast<std::uint64_t>(motion.cpu_seconds));
  put(text, static_cast<std::uint64_t>(motion.evaluations));
  put(text, motion.states.size());
  put(text, static_cast<std::uint64_t>(motion.states.at(0).x.size()));
  for (const particles::State& state : motion.states) {
    put(text, state.x);
    put(text, state.v);
  }
  keep(folder, kKind, key, text);
}

}  // namespace hair
