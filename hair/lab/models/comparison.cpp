#include "hair/lab/models/comparison.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/work_precision.h"
#include "hair/lab/stub.h"
#include "hair/simulation/simulation.h"
#include "solver/not_implemented.h"
#include "solver/timing.h"

namespace hair::model_study {

namespace {

constexpr double kFrame = 1.0 / 60;  // s
constexpr int kFinest = 6;           // halvings of it
constexpr double kMostSeconds = 20;  // of CPU time for a second of motion: no finer run then
constexpr int kMostTimes = 5;        // that a short run is repeated
constexpr double kEnough = 0.02;     // s of CPU time, of all its repeats
constexpr double kMoment = kComparedTime / kMoments;

class Runner {
 public:
  Runner(const ComparedHair& hair, const FineMotion& truth, const std::atomic<bool>& interrupted)
      : hair_(hair), truth_(truth), interrupted_(interrupted) {}

  // Empty if interrupted.
  std::optional<ModelRun> run(const Family& family, int elements, double longest_step) {
    const long steps = std::lround(std::ceil(kMoment / longest_step * (1 - 1e-9)));
    ModelRun run;
    run.elements = elements;
    run.step = kMoment / static_cast<double>(steps);
    std::vector<double> seconds;
    double sum = 0;
    do {
      Simulation simulation(description_of(family, hair_.spec, elements, run.step));
      seconds.push_back(0);
      if (!play(simulation, steps, run, seconds.back())) return {};
      sum += seconds.back();
    } while (run.trouble.empty() && sum < kEnough && seconds.size() < kMostTimes);
    run.seconds = timing::median(seconds) / kComparedTime;
    return run;
  }

 private:
  bool play(Simulation& simulation, long steps, ModelRun& run, double& seconds) {
    const Body& body = simulation.body(0);
    Eigen::VectorXd q(body.size()), rate(body.size()), x(3 * body.points()), v(x.size());
    const Eigen::VectorXd at = body.arc_lengths();
    const bool long_steps = run.step > 0.99 * kFrame;
    std::vector<Eigen::VectorXd> lines;
    run.lengths.clear();
    run.trouble.clear();
    for (int moment = 0; moment < kMoments; ++moment) {
      for (long k = 0; k < steps; ++k) {
        if (interrupted_) return false;
        const double start = timing::cpu_seconds();
        const auto blow_up = simulation.step();
        seconds += timing::cpu_seconds() - start;
        if (blow_up) {
          run.trouble = "blows up after " + std::to_string(blow_up->step) + " steps";
          return true;
        }
        if (!long_steps && k + 1 < steps) continue;
        body.read(q, rate);
        body.centre_line(q, rate, x, v);
        if (long_steps) run.lengths.push_back(length_of(x) / at[at.size() - 1]);
      }
      lines.push_back(compared_points(hair_, x, at));
    }
    run.error = rms_distance(lines, truth_.lines);
    if (!(run.error < hair_.spec.length)) run.trouble = "is farther off than the hair is long";
    return true;
  }

  static double length_of(const Eigen::VectorXd& x) {
    double sum = 0;
    for (Eigen::Index k = 3; k < x.size(); k += 3) sum += (x.segment<3>(k) - x.segment<3>(k - 3)).norm();
    return sum;
  }

  const ComparedHair& hair_;
  const FineMotion& truth_;
  const std::atomic<bool>& interrupted_;
};

// Steps from a frame's down to where finer ones are no better, or take too long.
bool sweep(Runner& runner, const ComparedHair& hair, bool quick, FamilyRuns& family) {
  const bool is_explicit = row_of(family.family.method).is_explicit;
  const bool helices = std::string_view(family.family.model) == "super_helix";
  for (const int elements : helices ? hair.helices : hair.elements) {
    double step = is_explicit ? explicit_step(family.family, hair.spec, elements) : kFrame;
    std::vector<double> errors;
    for (int halved = 0; halved <= (is_explicit ? 0 : quick ? 2 : kFinest); ++halved, step /= 2) {
      const auto run = runner.run(family.family, elements, step);
      if (!run) return false;
      errors.push_back(run->trouble.empty() ? run->error : std::nan(""));
      family.runs.push_back(*run);
      if (stalls(errors) || run->seconds > kMostSeconds) break;
    }
  }
  return true;
}

template <typename Runs>
bool add_family(const Family& family, const std::string& left_out, std::vector<FamilyRuns>& families,
                Runs make_runs) {
  FamilyRuns& added = families.emplace_back(FamilyRuns{family, {}, left_out});
  if (!added.left_out.empty()) return true;
  try {
    return make_runs(added);
  } catch (const NotImplemented& stub) {
    added.left_out = "needs " + missing_part(stub);
    added.runs.clear();
    return true;
  }
}

}  // namespace

std::optional<Comparison> compare_models(const std::vector<ComparedHair>& hairs, bool quick,
                                         const std::vector<std::string>& absent,
                                         const std::atomic<bool>& interrupted,
                                         const std::function<void(const std::string&)>& say) {
  Comparison comparison;
  for (const ComparedHair& hair : hairs) {
    say(hair.title + ": the fine motion");
    const auto truth = fine_motion(hair, interrupted);
    if (!truth) return {};
    HairComparison& one = comparison.hairs.emplace_back();
    one.hair = hair;
    one.uncertainty = truth->uncertainty;
    one.fine_seconds = truth->seconds;
    Runner runner(hair, *truth, interrupted);
    for (const Family& family : families()) {
      say(hair.title + ": " + family.name);
      if (!add_family(family, left_out(family, hair.spec, absent), one.families,
                      [&](FamilyRuns& runs) { return sweep(runner, hair, quick, runs); }))
        return {};
    }
    if (hair.id != "straight") continue;
    for (const Family& family : stiff_families()) {
      say(hair.title + ": " + family.name);
      if (!add_family(family, left_out(family, hair.spec, absent), one.stiff, [&](FamilyRuns& runs) {
            for (const int elements : hair.elements) {
              const auto run = runner.run(family, elements, kFrame);
              if (!run) return false;
              runs.runs.push_back(*run);
            }
            return true;
          }))
        return {};
    }
  }
  if (std::find(absent.begin(), absent.end(), "H8") == absent.end()) {
    say("super-helices: what a step costs");
    try {
      const auto costs = helix_costs(quick, interrupted);
      if (!costs) return {};
      comparison.helix_costs = *costs;
    } catch (const NotImplemented&) {  // the families say so
    }
  }
  return comparison;
}

}  // namespace hair::model_study
