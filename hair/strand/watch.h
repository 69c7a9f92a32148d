// Watches a simulation for numbers that are finite and wrong; blow-ups are separate. Each concern has a size,
// for one strand after one step, and a bound; a size above the bound causes a warning.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace hair {

class EnergyWatch;

enum class Concern {
  energy,
  contact_energy,
  loss,
  unmoved,
  stretching,
  stretch,
  stretch_rate,
  segment,
  penetration,
  mends,
  unconverged,
  solves,
  passes
};

struct ConcernRow {
  Concern concern;
  const char* id;          // in run.json: "contact energy"
  const char* says;        // in a sentence: "contacts gave it energy"
  const char* measure;     // the meaning of the size
  double bound;            // the largest size without a warning
  bool adds_up = false;    // the size is a part of all steps, from the first one where it is not 0
  bool of_solver = false;  // an exercise solves
};

std::span<const ConcernRow> concerns();  // in the order of the enumeration

// The sizes of all concerns, of a body after a step. 0: it does not apply.
inline constexpr int kConcerns = 13;
struct Sizes {
  std::array<double, kConcerns> of = {};

  double& operator[](Concern concern) { return of[static_cast<std::size_t>(concern)]; }
  double operator[](Concern concern) const { return of[static_cast<std::size_t>(concern)]; }
};

// Takes the sizes of a body's energy balance (hair/strand/energy_watch.h).
void add(const EnergyWatch& energy, Sizes& sizes);

// More than a few solves of a body end above their tolerance: 1 % of them, and six at least.
inline double share_of(long unconverged, long solves) {
  return static_cast<double>(unconverged) / static_cast<double>(std::max(solves, 501L));
}

struct Warning {
  const ConcernRow* concern;
  int strand;   // the first one above the bound,
  long step;    // and its step, counted from 1
  int strands;  // how many there are
  double size;  // the largest of all
  std::string_view body = "strand";
  std::string_view solver = {};  // the exercise whose solves these are, if the concern is of those
};

// The worst that was seen, of all strands.
class Watch {
 public:
  explicit Watch(int strands = 0) : above_(strands), begun_(strands) {}

  // After each step, of each strand. Allocates nothing.
  void see(int strand, long step, const Sizes& sizes);

  double worst(Concern concern) const { return seen_[static_cast<std::size_t>(concern)].size; }
  std::vector<Warning> warnings() const;  // in the order of the enumeration

 private:
  struct Seen {
    double size = 0;
    int strand = -1;  // none
    long step = 0;
    int strands = 0;
  };
  std::array<Seen, kConcerns> seen_ = {};
  std::vector<std::array<bool, kConcerns>> above_;  // one for each strand
  std::vector<std::array<long, kConcerns>> begun_;  // the step at which a size that adds up was no longer 0
};

}  // namespace hair
