#include "hair/truth/accurate_motion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string_view>
#include <tuple>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/digest.h"
#include "hair/io/files/kept_file.h"
#include "hair/io/plot/page.h"
#include "hair/strand/variation.h"
#include "hair/truth/cvode.h"
#include "hair/truth/rigid_strand_ode.h"
#include "hair/truth/strand_ode.h"
#include "particles/require.h"
#include "solver/timing.h"

namespace hair {
namespace {

// A full matrix that is larger costs more than all the rest.
constexpr double kLargestMatrix = 2e5;  // entries

using Ways = std::array<CvodeWay, 2>;

// The two ways differ as much as CVODE allows; if Newton's method would be too expensive, they are two
// tolerances.
Ways ways_for(const Ode& ode, double tolerance) {
  const double entries = static_cast<double>(ode.size()) * (ode.above() + 1 + ode.below());
  if (entries > kLargestMatrix)
    return {{{CvodeMethod::adams, tolerance}, {CvodeMethod::adams, 10 * tolerance}}};
  return {{{CvodeMethod::adams, tolerance}, {CvodeMethod::bdf, tolerance}}};
}

std::string name_of(const CvodeWay& way) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%s at %.2g", way.method == CvodeMethod::bdf ? "BDF" : "Adams",
                way.tolerance);
  return text.data();
}

bool moves_as_rigid(const Problem& problem) {
  if (problem.is_toy()) return false;
  const Strand& strand = problem.scene.hair.strands[0].strand;
  return strand.segments() > 0 && times_the_ea_of_hair(strand) > kHardToStretch && starts_rigid(problem);
}

std::unique_ptr<Ode> ode_of(const Problem& problem) {
  if (problem.is_toy()) return toy_ode(problem);
  if (moves_as_rigid(problem)) return std::make_unique<RigidStrandOde>(problem);
  return std::make_unique<StrandOde>(problem);
}

// The distance of a stretching strand from the limit, over the largest stretch by its tensions: 1.0 to 1.6
// for a released strand, 2.4 for a moving root. It is not derived, so the factor is larger.
constexpr double kOfStretch = 4;

}  // namespace

double AccurateMotion::least_error() const {
  return std::max(agreement, kLeastError);
}

bool have_accurate_motion() {
  return have_cvode();
}

std::optional<AccurateMotion> accurate_motion(const Problem& problem, const AccurateSettings& settings,
                                              const std::atomic<bool>& interrupted) {
  particles::require_positive("the tolerance of an accurate motion", settings.tolerance);
  const std::unique_ptr<Ode> ode = ode_of(problem);
  const Ways ways = ways_for(*ode, std::max(settings.tolerance, kTightest));
  const auto* rigid = dynamic_cast<const RigidStrandOde*>(ode.get());

  AccurateMotion motion;
  motion.inextensible = rigid != nullptr;
  motion.method = "CVODE " + cvode_version() + ": " + name_of(ways[0]) + ", beside " + name_of(ways[1]) +
                  (rigid ? ", of rigid segments" : "");
  std::string key;
  if (settings.cache) {
    // Equations of its own, because equations that were solved keep a memory.
    key = motion_key(problem, *ode_of(problem),
                     motion.method + ", exactly " + to_exact_text(ways[0].tolerance));
    if (auto kept = find_motion(*settings.cache, key)) return kept;
  }

  const double start = timing::cpu_seconds();
  std::array<Trajectory, std::tuple_size_v<Ways>> found;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    std::optional<CvodeRun> run =
        run_cvode(*ode, problem.duration, problem.scene.frames, ways[k], interrupted);
    if (!run) return {};
    motion.evaluations += run->evaluations;
    found[k] = std::move(run->states);
  }
  motion.cpu_seconds = timing::cpu_seconds() - start;
  motion.agreement = largest_distance(found[0], found[1]);
  if (rigid) motion.agreement = std::max(motion.agreement, kOfStretch * rigid->stretch());
  motion.states = std::move(found[0]);
  if (settings.cache) {
    try {
      keep_motion(*settings.cache, key, motion);
    } catch (const BadInput&) {
      // A folder that can't be written costs time in the next run, and nothing now.
    }
  }
  return motion;
}

double largest_distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  double largest = 0;
  for (Eigen::Index i = 0; i < x.size(); i += 3)
    largest = std::max(largest, (x.segment<3>(i) - y.segment<3>(i)).norm());
  return largest;
}

double largest_distance(const Trajectory& a, const Trajectory& b) {
  double largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    largest = std::max(largest, largest_distance(a[k].x, b[k].x));
  return largest;
}

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
