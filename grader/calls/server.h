// STAFF ONLY. Serves an exercise's calls: reads a request, calls the function, writes the reply. A Host calls
// it:
//
//   Host::Vector(numbers)     numbers in memory of the host's, with view(), a vector
//   host.call<Call>(arguments...)  calls the call's function
//   host.bound(sweeps, size)  bounds the work of a call, for a vector of `size` numbers
//   host.served(force)        true if the other side serves `force` in this request
//   host.ask                  see remote.h
//
// Hosts are a worker, which calls a student's function (grader/worker/worker_host.h), and the suite, which
// calls the reference's for a worker (grader/judge/student/provided.cpp.in).
#pragma once

#include <cstring>
#include <optional>

#include "grader/calls/call.h"
#include "grader/calls/remote.h"

namespace grader::inline calls {

// Holds numbers of a host that trusts its functions.
class UnguardedVector {
 public:
  explicit UnguardedVector(const std::vector<double>& numbers)
      : numbers_(numbers), view_(numbers_.data(), static_cast<Eigen::Index>(numbers_.size())) {}
  Eigen::Map<Eigen::VectorXd>& view() { return view_; }

 private:
  std::vector<double> numbers_;
  Eigen::Map<Eigen::VectorXd> view_;
};

// This has the members of parameters that need no others.
struct StoredParameter {
  void prepare(Eigen::Index) {}             // runs last; gets the size of the call's vectors
  Eigen::Index size() const { return -1; }  // is the length of a vector, see size_of
  void write(MessageWriter&) {}             // adds to the reply
  bool changed() const { return false; }    // true: the function wrote to an input
};

// This is a parameter P of a call: it reads the value from the request, keeps it, and has view(), the
// function's argument. If it reads once more, the same object holds other numbers.
template <class P, class Host, Contract contract>
class Stored : public StoredParameter {
  using T = std::remove_cvref_t<P>;
  static constexpr bool kReturned =
      std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;

 public:
  explicit Stored(Host&) {}
  void read(MessageReader& request) {
    decode(request, value_);
    if constexpr (kReturned) sent_ = value_;
  }
  T& view() { return value_; }
  Eigen::Index size() const { return numbers_of(value_); }
  void write(MessageWriter& reply) {
    if constexpr (kReturned) {
      fit(value_, sent_);
      encode(reply, value_);
    }
  }

 private:
  T value_{}, sent_{};
};

template <class Item, class Host, Contract contract>
class Stored<std::span<const Item>, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host&) {}
  void read(MessageReader& request) { decode(request, items_); }
  std::span<const Item> view() const { return items_; }

 private:
  std::vector<Item> items_;
};

// Keeps the numbers of a vector in the host's memory. The second time they must be as many.
template <class Host>
class StoredVector : public StoredParameter {
 public:
  void read(MessageReader& request) {
    if (!memory_) {
      sent_ = request.get_doubles();
      memory_.emplace(sent_);
    } else {
      sent_ = request.get_doubles(sent_.size());
      std::copy(sent_.begin(), sent_.end(), view().data());
    }
  }
  Eigen::Map<Eigen::VectorXd>& view() { return memory_->view(); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(sent_.size()); }

 protected:
  std::vector<double> sent_;

 private:
  std::optional<typename Host::Vector> memory_;
};

template <class Host, Contract contract>
class Stored<particles::Input, Host, contract> : public StoredVector<Host> {
 public:
  explicit Stored(Host&) {}
  // NaN equals itself.
  bool changed() {
    return !this->sent_.empty() &&
           std::memcmp(this->view().data(), this->sent_.data(), this->sent_.size() * sizeof(double)) != 0;
  }
};

template <class Host, Contract contract>
class Stored<particles::Output, Host, contract> : public StoredVector<Host> {
 public:
  explicit Stored(Host&) {}
  void read(MessageReader& request) {
    if constexpr (contract.may_share) shared_ = request.get<int>();
    StoredVector<Host>::read(request);
  }
  int shared() const { return shared_; }  // is the number of its Input, counted from 1; 0: none
  void share(Eigen::Map<Eigen::VectorXd>& input) { input_ = &input; }
  Eigen::Map<Eigen::VectorXd>& view() { return input_ != nullptr ? *input_ : StoredVector<Host>::view(); }
  void write(MessageWriter& reply) { encode(reply, view()); }

 private:
  int shared_ = 0;
  Eigen::Map<Eigen::VectorXd>* input_ = nullptr;
};

// This is a matrix: scratch, or an output.
template <class Host, Contract contract>
class Stored<particles::Scratch, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host&) {}
  void read(MessageReader& request) {
    if constexpr (contract.scratch_columns > 0) {
      columns_ = request.get<int>();
      filling_ = request.get<double>();
    } else {
      Eigen::MatrixXd matrix;
      decode(request, matrix);
      make(matrix.rows(), matrix.cols(), {matrix.data(), matrix.data() + matrix.size()});
    }
  }
  void prepare(Eigen::Index size) {
    if constexpr (contract.scratch_columns > 0) {
      const Eigen::Index columns = columns_;
      const Eigen::Index least = contract.scratch_columns + (contract.scratch_of_size ? size : 0);
      if (columns < least || columns > 4 * least)
        throw MalformedMessage("scratch of " + std::to_string(columns) + " columns; expected " +
                               std::to_string(least));
      make(size, columns, std::vector<double>(static_cast<std::size_t>(size * columns), filling_));
    }
  }
  Eigen::Map<Eigen::MatrixXd>& view() { return *view_; }
  void write(MessageWriter& reply) {
    if constexpr (contract.scratch_columns == 0) encode(reply, view());
  }

 private:
  void make(Eigen::Index rows, Eigen::Index columns, const std::vector<double>& numbers) {
    memory_.emplace(numbers);
    view_.emplace(memory_->view().data(), rows, columns);
  }

  int columns_ = 0;
  double filling_ = 0;
  std::optional<typename Host::Vector> memory_;
  std::optional<Eigen::Map<Eigen::MatrixXd>> view_;
};

template <class Host, Contract contract>
class Stored<const particles::Force&, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host& host) : host_(host) {}
  void read(MessageReader& request) { provided_ = request.get<std::uint8_t>() != 0; }
  void prepare(Eigen::Index size) {
    if (!force_) host_.served(force_.emplace(host_, size, provided_));
  }
  const particles::Force& view() const { return *force_; }

 private:
  Host& host_;
  bool provided_ = false;
  std::optional<RemoteForce<Host>> force_;
};

template <class Host, Contract contract>
class Stored<particles::Dynamics&, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host& host) : host_(host) {}
  void read(MessageReader&) {}
  void prepare(Eigen::Index size) { dynamics_.emplace(host_, size); }
  particles::Dynamics& view() { return *dynamics_; }

 private:
  Host& host_;
  std::optional<RemoteDynamics<Host>> dynamics_;
};

template <class Host, Contract contract>
class Stored<implicitMatrix&, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host& host) : host_(host) {}
  void read(MessageReader&) {}
  void prepare(Eigen::Index size) {
    if (!matrix_) matrix_.emplace(host_, 0, static_cast<int>(size), static_cast<int>(size));
  }
  implicitMatrix& view() { return *matrix_; }

 private:
  Host& host_;
  std::optional<RemoteMatrix<Host>> matrix_;
};

template <class Host, Contract contract>
class Stored<Operator, Host, contract> : public StoredParameter {
 public:
  explicit Stored(Host& host) : host_(host) {}
  void read(MessageReader& request) {
    const int which = request.get<int>(), rows = request.get<int>(), cols = request.get<int>();
    if (rows < 0 || cols < 0) throw MalformedMessage("an operator of fewer than no rows or columns");
    if (!matrix_) matrix_.emplace(host_, which, rows, cols);
    operator_ = {rows, cols, &*matrix_};
  }
  Operator view() const { return operator_; }

 private:
  Host& host_;
  std::optional<RemoteMatrix<Host>> matrix_;
  Operator operator_{};
};

// This is a request of one call.
template <class Call, class Host, class Parameters = typename Call::Signature::Parameters>
class Request;
template <class Call, class Host, class... P>
class Request<Call, Host, std::tuple<P...>> {
 public:
  explicit Request(Host& host)
      : host_(host), stored_((static_cast<void>(std::type_identity<P>{}), host)...) {}

  void serve(MessageReader& request, MessageWriter& reply) {
    read(request);
    if constexpr (Call::Signature::returns_matrix) {
      multiply(request, reply);
    } else {
      request.expect_end();
      each([&](auto&... stored) {
        if constexpr (std::is_void_v<typename Call::Signature::Result>)
          host_.template call<Call>(stored.view()...);
        else
          encode(reply, host_.template call<Call>(stored.view()...));
        (stored.write(reply), ...);
        reply.put(static_cast<std::uint8_t>((stored.changed() || ...)));
      });
    }
  }

 private:
  template <class Do>
  decltype(auto) each(Do&& what) {
    return std::apply(what, stored_);
  }

  void read(MessageReader& request) {
    each([&](auto&... stored) { (stored.read(request), ...); });
    each([&](auto&... stored) {
      Eigen::Index size = -1;
      ((size = size < 0 ? stored.size() : size), ...);
      if (size_.value_or(size) != size) throw MalformedMessage("other arguments of another size");
      size_ = size;
      (stored.prepare(std::max<Eigen::Index>(size, 0)), ...);
      Call::Check::check(plain(stored.view())...);
      if constexpr (Call::contract.sweeps >= 0)
        host_.bound(std::get<Call::contract.sweeps>(stored_).view(), size);
    });
    if constexpr (Call::contract.may_share) each([&](auto&... stored) { (share(stored), ...); });
  }

  template <class S>
  void share(S& stored) {
    if constexpr (requires { stored.shared(); }) {
      int number = 0;
      const auto look = [&](auto& other) {
        ++number;
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(other)>,
                                     Stored<particles::Input, Host, Call::contract>>)
          if (number == stored.shared() && other.view().size() == stored.view().size())
            stored.share(other.view());
      };
      each([&](auto&... others) { (look(others), ...); });
    }
  }

  // The matrix is made of the arguments that came first. Others may follow, and replace them before it
  // multiplies: so the result shows if the matrix keeps the values of its arguments. Their sizes stay. Each
  // product is one of the same x, in a buffer with any content.
  void multiply(MessageReader& request, MessageWriter& reply) {
    const std::unique_ptr<implicitMatrix> matrix =
        each([&](auto&... stored) { return host_.template call<Call>(stored.view()...); });
    const std::array<Eigen::Index, 2> shape = this->shape();
    if (request.get<std::uint8_t>() != 0) {
      read(request);
      if (this->shape() != shape) throw MalformedMessage("other arguments, of a matrix of another size");
    }
    typename Host::Vector x(request.get_doubles());
    const std::vector<double> filling = request.get_doubles();
    const auto times = request.get<std::uint8_t>();
    request.expect_end();
    if (x.view().size() != shape[1] || static_cast<Eigen::Index>(filling.size()) != shape[0])
      throw MalformedMessage("a product of another size than the matrix");
    for (int i = 0; i < times; ++i) {
      typename Host::Vector product(filling);
      matrix->matVecMult(x.view().data(), product.view().data());
      encode(reply, product.view());
    }
    encode(reply, x.view());
  }

  std::array<Eigen::Index, 2> shape() {
    return each([](auto&... stored) { return Call::Check::shape(plain(stored.view())...); });
  }

  // Checks see values.
  template <class View>
  static const View& plain(const View& view) {
    return view;
  }

  Host& host_;
  std::tuple<Stored<P, Host, Call::contract>...> stored_;
  std::optional<Eigen::Index> size_;  // is the length of a vector
};

template <class Calls, class Host>
void serve(Host& host, MessageReader& request, MessageWriter& reply) {
  const int number = request.get<int>();
  const auto serve_one = [&]<int i>() {
    if (number == i) Request<typename Calls::template At<i>, Host>(host).serve(request, reply);
  };
  if (number < 0 || number >= Calls::count) throw MalformedMessage("a function that is not there");
  [&]<int... i>(std::integer_sequence<int, i...>) {
    (serve_one.template operator()<i>(), ...);
  }
  (std::make_integer_sequence<int, Calls::count>());
}

}  // namespace grader::calls
