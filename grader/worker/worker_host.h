// STAFF ONLY. A worker as the host of a server (grader/calls/server.h): it calls a student's functions.
#pragma once

#include "grader/calls/server.h"
#include "grader/worker/session.h"
#include "particles/vectors.h"

namespace grader {

// In front of a protected page.
class GuardedVector {
 public:
  explicit GuardedVector(const std::vector<double>& values)
      : buffer_(values), view_(buffer_.data(), static_cast<Eigen::Index>(values.size())) {}

  Eigen::Map<Eigen::VectorXd>& view() { return view_; }
  std::span<const double> values() const { return buffer_.values(); }

 private:
  GuardedBuffer buffer_;
  Eigen::Map<Eigen::VectorXd> view_;
};

class WorkerHost {
 public:
  using Vector = GuardedVector;
  struct Ours : Session::Uncounted {
    explicit Ours(const WorkerHost& host) : Uncounted(host.session_) {}
  };

  explicit WorkerHost(Session& session) : session_(session) {}

  void ask(const Question& question) { session_.product(question.which, question.numbers, question.answer); }
  template <class Call, class... Arguments>
  decltype(auto) call(Arguments&&... arguments) {
    const auto function = [&]() -> decltype(auto) { return Call::function(arguments...); };
    // Of a function that makes a matrix it is the product.
    if constexpr (Call::contract.allocates_nothing && !Call::Signature::returns_matrix)
      return session_.counted(function);
    else
      return function();
  }
  template <class Product>
  void multiply(bool allocates_nothing, Product&& product) {
    allocates_nothing ? session_.counted(product) : product();
  }
  void bound(int&, Eigen::Index) {}
  void served(const particles::Force& force) { session_.served_force = &force; }

 private:
  Session& session_;
};

}  // namespace grader
