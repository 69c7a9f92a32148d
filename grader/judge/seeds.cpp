// STAFF ONLY. Runs hidden cases under many seeds, for the suite's bounds: a right program must pass under
// all of them, and a wrong one must fail under all of them.
//
//   hairseeds EXERCISE FIRST COUNT KIT OBJECT...
//
// The objects are loaded in their order, the exercise's last, in a process without a sandbox: only trusted
// programs may run so. Prints a line for each category that fails: the number of seeds, and the first failure
// as staff read it; for each bound the largest error / bound, its seed, the category, and the quantity; and
// for each category a hash of the bits that it asked and answered. The exit code is 0 if no category fails, 1
// if one does.
#include <sodium.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <map>

#include "grader/judge/cases/suite_table.h"
#include "grader/judge/student/recording.h"

namespace {

struct Failures {
  int count = 0;
  std::string first;
};

// Hashes a category's requests, and the suite's products for them.
class Hash {
 public:
  Hash() { crypto_generichash_init(&state_, nullptr, 0, 8); }

  void add(const grader::Recording& recording) {
    for (const grader::Recording::Request& request : recording.requests()) {
      add(std::span<const std::byte>(request.message.bytes()));
      for (const grader::Recording::Product& product : request.products)
        add(std::as_bytes(std::span(product.result)));
    }
  }
  std::string in_hex() {
    std::array<unsigned char, 8> bytes;
    crypto_generichash_final(&state_, bytes.data(), bytes.size());
    std::array<char, 17> text;
    return sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  }

 private:
  void add(std::span<const std::byte> bytes) {
    crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  }

  crypto_generichash_state state_;
};

grader::Student without_sandbox(const std::string& exercise, const std::string& kit,
                                const std::vector<std::filesystem::path>& objects) {
  grader::WorkerSetup setup;
  setup.kit = std::filesystem::absolute(kit);
  setup.exercise = exercise;
  for (const std::filesystem::path& object : objects) {
    setup.objects.push_back(std::filesystem::absolute(object));
    // The kit's provided/S1.so calls the suite.
    if (object.parent_path().filename() == "provided") setup.provided.push_back(object.stem());
  }
  setup.log = "/dev/null";
  setup.isolation = grader::Isolation::none;
  setup.cpu_seconds = 1'000'000;
  for (const grader::BudgetField& field : grader::budget_fields())
    setup.allowance->limit.*field.value = std::numeric_limits<double>::infinity();
  setup.allowance->limit.worker_cpu_seconds = setup.cpu_seconds;
  setup.allowance->limit.idle_seconds = setup.cpu_seconds;
  return grader::Student(setup);
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 6 || sodium_init() < 0) {
    std::cerr << "hairseeds EXERCISE FIRST COUNT KIT OBJECT...\n";
    return 2;
  }
  const std::string exercise = argv[1];
  const int first = std::stoi(argv[2]), count = std::stoi(argv[3]);
  std::map<std::string, Failures> failures;
  std::map<std::string, std::pair<double, int>> nearest;  // holds the ratio and the seed
  std::map<std::string, Hash> asked;
  for (int seed = first; seed < first + count; ++seed) {
    // A worker has a limit of wall time, and in a build without optimisation sweeps along a hair take seconds
    // for each seed.
    grader::Student student = without_sandbox(exercise, argv[4], {argv + 5, argv + argc});
    for (const grader::Category& category : grader::categories(exercise)) {
      grader::Trial trial(student, grader::Random(std::to_string(seed), category.name));
      grader::Recording recording;
      student.record(&recording);
      try {
        category.run(trial);
      } catch (const grader::CaseFailed& failure) {
        Failures& of = failures[category.name];
        if (++of.count == 1)
          of.first = "seed " + std::to_string(seed) + ", " + failure.feedback + "; " + failure.detail;
      }
      asked[category.name].add(recording);
      for (const auto& [quantity, ratio] : trial.nearest()) {
        std::pair<double, int>& largest = nearest[category.name + " | " + quantity];
        largest = std::max(largest, {ratio, seed});
      }
    }
    student.finish();
  }
  std::cout << exercise << ": " << count << " seeds, " << failures.size() << " categories fail\n";
  for (const auto& [category, of] : failures)
    std::cout << "  " << category << ": " << of.count << "; first: " << of.first << "\n";
  for (const auto& [bound, largest] : nearest)
    std::cout << largest.first << " " << largest.second << " " << bound << "\n";
  for (auto& [category, hash] : asked) std::cout << "asked " << hash.in_hex() << " " << category << "\n";
  return failures.empty() ? 0 : 1;
}
