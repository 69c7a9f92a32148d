// STAFF ONLY. A worker as the host of a server (grader/exercise/server.h): it calls a student's functions.
#pragma once

#include "grader/exercise/server.h"
#include "grader/worker/guarded_vectors.h"
#include "grader/worker/session.h"

namespace grader {

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
