// What a simulation watches beside blow-ups: numbers that are finite and wrong. Each concern has a size, of one strand
// after one step, and a bound; above it there is a warning. No shipped scene comes above two fifths of a bound.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace hair {

enum class Concern {
  energy,
  contact_energy,
  stretching,
  stretch,
  stretch_rate,
  penetration,
  mends,
  unconverged,
  passes
};

struct ConcernRow {
  Concern concern;
  const char* id;       // in run.json: "contact energy"
  const char* says;     // in a sentence: "contacts gave it energy"
  const char* measure;  // what the size is
  double bound;         // of that size
};

std::span<const ConcernRow> concerns();  // in the order of the enumeration

// The sizes of all concerns, of a body after a step. 0: it does not apply.
inline constexpr int kConcerns = 9;
struct Sizes {
  std::array<double, kConcerns> of = {};

  double& operator[](Concern concern) { return of[static_cast<std::size_t>(concern)]; }
  double operator[](Concern concern) const { return of[static_cast<std::size_t>(concern)]; }
};

struct Warning {
  const ConcernRow* concern;
  int strand;   // the first one above the bound,
  long step;    // and its step, counted from 1
  int strands;  // how many there are
  double size;  // the largest of all
};

// The worst that was seen, of all strands.
class Watch {
 public:
  explicit Watch(int strands = 0) : above_(strands) {}

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
  std::vector<std::array<bool, kConcerns>> above_;  // of each strand
};

}  // namespace hair
