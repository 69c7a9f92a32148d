// STAFF ONLY. Makes an exercise's calls: ask<Calls, function>(asker, arguments...) sends a request, answers
// the questions about the caller's objects, and puts the reply into the arguments. Answers are untrusted:
// their lengths are checked, and numbers may be anything. An Asker is the client's way to the server:
//
//   asker.start<function>(request, arguments...)  writes the beginning of a request, before the call's number
//   asker.ask(request, products)  sends it, and returns the reply; `products` answers questions
//   asker.served(force)           true if the other side serves `force` already and asks itself
//   asker.scratch(scratch, n)     `scratch` is the caller's; the contract gives the function n columns of it
//   asker.changed()               reports that the function wrote to an input
//
// Askers are cases (grader/judge/cases/case_asker.h), whole runs (grader/judge/run/proxies.h), and a worker's
// code that calls a provided function (grader/worker/provided.h). A server that counts questions may replace
// an object of the caller's: ForceServer, DynamicsServer; Served for an Operator or a matrix. Filling
// replaces Scratch.
#pragma once

#include <limits>

#include "grader/calls/call.h"
#include "grader/calls/object_servers.h"
#include "grader/wire/message.h"

namespace grader::inline calls {

struct Served {
  int rows, cols;
  Products products;
};

// This is scratch with the contract's columns and some more, all filled with one number.
struct Filling {
  int more_columns = 0;
  double number = std::numeric_limits<double>::quiet_NaN();
};

// Answers questions during a request.
class Answering {
 public:
  int add_operator(Products products) {
    operators_.push_back(std::move(products));
    return static_cast<int>(operators_.size()) - 1;
  }
  void set_force(Products products) { force_ = std::move(products); }

  bool operator()(int which, const std::vector<double>& x, std::vector<double>& y) const {
    if (which >= kForceEnergy && force_) return force_(which, x, y);
    if (which < 0 || which >= static_cast<int>(operators_.size()))
      throw MalformedMessage("an operator that is not there");
    return operators_[static_cast<std::size_t>(which)](which, x, y);
  }

 private:
  std::vector<Products> operators_;
  Products force_;
};

inline constexpr int kNoLimit = std::numeric_limits<int>::max();  // the submission's budget limits it

// Send parameters of type P, and take() their returned values.
template <class P, Contract contract, class Asker>
class Sender {
 public:
  Sender(MessageWriter& request, Answering& answering, Asker& asker, Eigen::Index size)
      : request_(request), answering_(answering), asker_(asker), size_(size) {}

  // `own` is its number among all arguments.
  template <int own, class Given>
  void send(Given& given, auto&... all) {
    if constexpr (std::is_same_v<P, particles::Output>) {
      if constexpr (contract.may_share) request_.put(place_of<own>(given, all...));
      encode(request_, given);
    } else if constexpr (std::is_same_v<P, particles::Scratch>) {
      send_matrix(given);
    } else if constexpr (std::is_same_v<P, const particles::Force&>) {
      send_force(given);
    } else if constexpr (std::is_same_v<P, particles::Dynamics&>) {
      send_dynamics(given);
    } else if constexpr (std::is_same_v<P, implicitMatrix&>) {
      send_square(given);
    } else if constexpr (std::is_same_v<P, Operator>) {
      send_operator(given);
    } else {
      const std::remove_cvref_t<P>& value = given;
      encode(request_, value);
    }
  }

 private:
  // Returns the number, counted from 1, of another argument in the same memory; 0 if there is none.
  template <int own, class Given>
  static int place_of(Given& given, auto&... all) {
    int number = 0, found = 0;
    const auto look = [&](auto& other) {
      ++number;
      if constexpr (requires { other.data() == given.data(); })
        if (found == 0 && number != own + 1 && other.data() == given.data()) found = number;
    };
    (look(all), ...);
    return found;
  }

  template <class Given>
  void send_matrix(Given& given) {
    const int columns = contract.scratch_columns + (contract.scratch_of_size ? static_cast<int>(size_) : 0);
    if constexpr (contract.scratch_columns == 0) {
      encode(request_, given);
    } else if constexpr (std::is_same_v<std::remove_const_t<Given>, Filling>) {
      request_.put(columns + given.more_columns).put(given.number);
    } else {
      asker_.scratch(given, columns);
      request_.put(columns).put(std::numeric_limits<double>::quiet_NaN());
    }
  }

  template <class Given>
  void send_force(Given& given) {
    if constexpr (std::is_base_of_v<particles::Force, Given>) {
      request_.put(static_cast<std::uint8_t>(asker_.served(given)));
      answering_.set_force(ForceServer(given, static_cast<int>(size_ / 3), kNoLimit));
    } else {  // a reference_wrapper of a ForceServer
      request_.put(std::uint8_t{0});
      answering_.set_force(given);
    }
  }

  template <class Given>
  void send_dynamics(Given& given) {
    if constexpr (std::is_base_of_v<particles::Dynamics, Given>)
      answering_.add_operator(DynamicsServer(given, static_cast<int>(size_ / 3), kNoLimit));
    else
      answering_.add_operator(given);
  }

  static Products products_of(const Operator& given) {
    return [given](int, const std::vector<double>& x, std::vector<double>& y) {
      if (static_cast<int>(x.size()) != given.cols) throw MalformedMessage("a question that makes no sense");
      std::vector<double> input = x;
      y.resize(static_cast<std::size_t>(given.rows));
      given.matrix->matVecMult(input.data(), y.data());
      return true;
    };
  }

  template <class Given>
  void send_operator(Given& given) {
    if constexpr (std::is_same_v<std::remove_const_t<Given>, Operator>)
      request_.put(answering_.add_operator(products_of(given)));
    else
      request_.put(answering_.add_operator(given.products));
    request_.put(given.rows).put(given.cols);
  }

  // The other side knows its number, 0, and its size.
  template <class Given>
  void send_square(Given& given) {
    if constexpr (std::is_base_of_v<implicitMatrix, Given>)
      answering_.add_operator(products_of({static_cast<int>(size_), static_cast<int>(size_), &given}));
    else
      answering_.add_operator(given.products);
  }

  MessageWriter& request_;
  Answering& answering_;
  Asker& asker_;
  Eigen::Index size_;
};

template <class P>
inline constexpr bool kIsAsked =
    std::is_same_v<P, particles::Dynamics&> || std::is_same_v<P, implicitMatrix&>;
// This is the returned value of a parameter of type P; void if there is none.
template <class P, bool with_scratch>
using Returned = std::conditional_t<
    std::is_same_v<P, particles::Output>, Eigen::VectorXd,
    std::conditional_t<std::is_same_v<P, particles::Scratch>,
                       std::conditional_t<with_scratch, void, Eigen::MatrixXd>,
                       std::conditional_t<std::is_lvalue_reference_v<P> &&
                                              !std::is_const_v<std::remove_reference_t<P>> && !kIsAsked<P>,
                                          std::remove_cvref_t<P>, void>>>;

// Puts it into the caller's argument. Throws MalformedMessage for another length.
template <class Value, class Given>
void take_back(MessageReader& reply, Given& given) {
  if constexpr (!std::is_void_v<Value>) {
    Value value = given;
    decode(reply, value);
    expect_like<Value>(value, given);
    given = value;
  }
}

template <class Calls, auto function>
class Client {
  using Call = typename Calls::template Of<function>;
  template <std::size_t i>
  using P = ParameterOf<function, i>;

 public:
  template <class Asker, class... Given>
  static ResultOf<function> ask(Asker& asker, Given&&... given) {
    MessageWriter request;
    Answering answering;
    asker.template start<function>(request, given...);
    request.put(Calls::template number_of<function>());
    send(request, answering, asker, given...);
    MessageReader reply = asker.ask(request, answering);
    if constexpr (std::is_void_v<ResultOf<function>>) {
      take(reply, asker, given...);
    } else {
      ResultOf<function> result;
      decode(reply, result);
      take(reply, asker, given...);
      return result;
    }
  }

  // Calls a function that returns a matrix: `times` products with x, and x after them. `filling` fills their
  // buffers before. With `after`, the matrix is made of `made`, which `after` then replaces.
  struct Products {
    std::vector<Eigen::VectorXd> products;
    Eigen::VectorXd x;
  };
  template <class Asker, class... Made, class... After>
  static Products multiply(Asker& asker, int times, const Eigen::VectorXd& x, const Eigen::VectorXd& filling,
                           const std::tuple<Made...>& made,
                           const std::tuple<After...>& after = std::tuple<>()) {
    MessageWriter request;
    Answering answering;
    std::apply([&](auto&... given) { asker.template start<function>(request, given...); }, made);
    request.put(Calls::template number_of<function>());
    std::apply([&](auto&... given) { send(request, answering, asker, given...); }, made);
    request.put(static_cast<std::uint8_t>(sizeof...(After) > 0));
    if constexpr (sizeof...(After) > 0)
      std::apply([&](auto&... given) { send(request, answering, asker, given...); }, after);
    encode(request, x);
    encode(request, filling);
    request.put(static_cast<std::uint8_t>(times));
    MessageReader reply = asker.ask(request, answering);
    Products answer;
    for (int i = 0; i < times; ++i) {
      decode(reply, answer.products.emplace_back());
      expect_like(answer.products.back(), filling);
    }
    decode(reply, answer.x);
    expect_like(answer.x, x);
    reply.expect_end();
    return answer;
  }

 private:
  template <class Asker, class... Given>
  static void send(MessageWriter& request, Answering& answering, Asker& asker, Given&... given) {
    const Eigen::Index size = size_of(given...);
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (Sender<P<i>, Call::contract, Asker>(request, answering, asker, size)
           .template send<static_cast<int>(i)>(given, given...),
       ...);
    }
    (std::index_sequence_for<Given...>());
  }

  template <class Asker, class... Given>
  static void take(MessageReader& reply, Asker& asker, Given&... given) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (take_back<Returned<P<i>, (Call::contract.scratch_columns > 0)>>(reply, given), ...);
    }
    (std::index_sequence_for<Given...>());
    bool changed = false;
    decode(reply, changed);
    if (changed) asker.changed();
    reply.expect_end();
  }
};

// This is the matrix that a function returns: each product is a request of its own. It refers to the
// arguments, as contracts allow. AskedMatrix keeps its own view of a vector: the caller's is gone when the
// function returns.
template <class P>
using Kept = std::conditional_t<std::is_same_v<P, particles::Input>, Eigen::Ref<const Eigen::VectorXd>, P>;
template <class Calls, auto function, class Asker, class Parameters>
class AskedMatrix;
template <class Calls, auto function, class Asker, class... P>
class AskedMatrix<Calls, function, Asker, std::tuple<P...>> : public implicitMatrix {
 public:
  explicit AskedMatrix(const Asker& asker, P... arguments) : asker_(asker), arguments_(arguments...) {}

  void matVecMult(double x[], double b[]) override {
    const auto [rows, cols] = std::apply(
        [](const auto&... arguments) { return Calls::template Of<function>::Check::shape(arguments...); },
        arguments_);
    Eigen::Map<Eigen::VectorXd> input(x, cols), product(b, rows);
    auto answer =
        Client<Calls, function>::multiply(asker_, 1, input, Eigen::VectorXd::Zero(rows), arguments_);
    input = answer.x;
    product = answer.products.front();
  }

 private:
  Asker asker_;
  std::tuple<Kept<P>...> arguments_;
};

template <class Calls, auto function, class Asker, class... Arguments>
std::unique_ptr<implicitMatrix> matrix_of(const Asker& asker, Arguments&... arguments) {
  using Parameters = typename Signature<decltype(function)>::Parameters;
  return std::make_unique<AskedMatrix<Calls, function, Asker, Parameters>>(asker, arguments...);
}

template <class... All>
auto alone(std::tuple<All...> all) {
  if constexpr (sizeof...(All) == 1)
    return std::get<0>(std::move(all));
  else
    return all;
}

template <class Calls, auto function, class Asker, class... Given>
ResultOf<function> ask(Asker& asker, Given&&... given) {
  return Client<Calls, function>::ask(asker, given...);
}

// Does the same for values: returns the function's result, then each output; a single value alone, or a
// tuple.
template <class Output, class Held>
auto output_of(Held& held) {
  if constexpr (std::is_void_v<Output>)
    return std::tuple<>();
  else
    return std::tuple<Output>(std::move(held));
}

template <class Calls, auto function, class Asker, std::size_t... i, class... Given>
auto answers_in(std::index_sequence<i...>, Asker& asker, const Given&... given) {
  constexpr bool scratch = Calls::template Of<function>::contract.scratch_columns > 0;
  std::tuple<std::conditional_t<std::is_void_v<Returned<ParameterOf<function, i>, scratch>>, const Given&,
                                Returned<ParameterOf<function, i>, scratch>>...>
  held(given...);
  const auto outputs = [&held] {
    return std::tuple_cat(output_of<Returned<ParameterOf<function, i>, scratch>>(std::get<i>(held))...);
  };
  if constexpr (std::is_void_v<ResultOf<function>>) {
    ask<Calls, function>(asker, std::get<i>(held)...);
    return alone(outputs());
  } else {
    std::tuple result(ask<Calls, function>(asker, std::get<i>(held)...));
    return alone(std::tuple_cat(std::move(result), outputs()));
  }
}

template <class Calls, auto function, class Asker, class... Given>
auto answers(Asker& asker, const Given&... given) {
  return answers_in<Calls, function>(std::index_sequence_for<Given...>(), asker, given...);
}

}  // namespace grader::calls
