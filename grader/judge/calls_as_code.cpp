// STAFF ONLY. Serves recorded requests to hosts (grader/calls/server.h) that call nothing: they write the
// call, with the names of the contract's header and the values of the request.
#include "grader/judge/calls_as_code.h"

#include <algorithm>

#include "all_calls.h"
#include "grader/calls/client.h"
#include "grader/calls/in_words.h"
#include "grader/calls/server.h"

namespace grader::inline judge {
namespace {

// Gives visit(i, value) the returned value, i = -1, and each argument i that comes back.
template <class Call, class Visit>
void for_each_returned(MessageReader reply, const Visit& visit) {
  const auto next = [&]<class Value>(int i, std::type_identity<Value>) {
    if constexpr (!std::is_void_v<Value>) {
      Value value{};
      decode(reply, value);
      visit(i, value);
    }
  };
  next(-1, std::type_identity<typename Call::Signature::Result>());
  [&]<class... P>(std::type_identity<std::tuple<P...>>) {
    int i = 0;
    (next(i++, std::type_identity<Returned<P, (Call::contract.scratch_columns > 0)>>()), ...);
  }(std::type_identity<typename Call::Signature::Parameters>());
}

// This is a host without objects and bounds.
struct Writing {
  using Vector = UnguardedVector;
  void ask(const Question&) {}
  void bound(int&, Eigen::Index) {}
  void served(const particles::Force&) {}
};

struct WrittenMatrix : implicitMatrix {
  std::function<void(double*, double*)> product;
  void matVecMult(double x[], double b[]) override { product(x, b); }
};

template <class View>
inline constexpr bool kIsObject = std::is_abstract_v<View> || std::is_same_v<View, Operator>;

// Copies an argument as a type that keeps its numbers.
template <class View>
auto value_of(const View& view) {
  if constexpr (requires { typename View::PlainObject; })
    return typename View::PlainObject(view);
  else if constexpr (requires { view.size_bytes(); })
    return std::vector<typename View::value_type>(view.begin(), view.end());
  else
    return View(view);
}

std::string text(Eigen::Index number) {
  return std::to_string(number);
}

// Writes a call as a struct of its arguments and statements of main.
struct WrittenCall {
  const Declared& function;
  const Recording::Request& request;
  std::string name;  // "call1"
  CallsAsCode& code;

  std::string members = {}, show = {}, replace = {};
  std::vector<std::string> passed = {}, literals = {};
  std::map<const void*, std::string> at = {};  // names vectors by their places
  std::optional<std::array<Eigen::Index, 2>> shape = {};
  int operators = 0, products = 0;

  // S1 and S2 have objects with their sizes in place of ints that come first in the contract.
  std::size_t sizes() const { return function.parameters.size() - passed.size(); }

  template <class P, Contract contract, class View>
  void argument(const Declared::Parameter& parameter, View& view, Eigen::Index n) {
    const std::string& own = parameter.name;
    std::string pass = (parameter.is_pointer ? "&" : "") + name + "." + own, written;
    const auto object = [&](const char* type, const std::string& arguments) {
      members +=
          std::string("  grader::Remote") + type + "<Recorded> " + own + "{answers, " + arguments + "};\n";
    };
    if constexpr (std::is_same_v<P, const particles::Force&>) {
      object("Force", text(n) + ", false");
    } else if constexpr (std::is_same_v<P, particles::Dynamics&>) {
      object("Dynamics", text(n));
    } else if constexpr (std::is_same_v<P, implicitMatrix&>) {
      object("Matrix", "0, " + text(n) + ", " + text(n));
    } else if constexpr (std::is_same_v<P, Operator>) {
      if (!shape) shape = {view.rows, view.cols};
      object("Matrix", text(operators++) + ", " + text(view.rows) + ", " + text(view.cols));
    } else if constexpr (std::is_same_v<P, particles::Scratch> && contract.scratch_columns > 0) {
      members += "  Eigen::MatrixXd " + own + " = Eigen::MatrixXd::Constant(" + text(view.rows()) + ", " +
                 text(view.cols()) + ", " + number_literal(view.size() > 0 ? view(0, 0) : 0) + ");\n";
    } else {
      const auto value = value_of(view);
      using Value = std::remove_const_t<decltype(value)>;
      written = literal(value);
      std::string declared = std::string(type_name<Value>()) + " " + own + " = " + written;
      if constexpr (DenseNumbers<View>) {
        if (parameter.is_pointer) pass = name + "." + own + ".data()";
        if (contract.may_share && view.size() > 0)
          if (const auto [place, is_new] = at.emplace(view.data(), own); !is_new)
            declared = "Eigen::VectorXd& " + own + " = " + place->second;
      }
      members += "  " + declared + ";\n";
    }
    passed.push_back(pass);
    literals.push_back(written);
  }

  template <class Call, class... View>
  typename Call::Signature::Result call(View&... views) {
    using Result = typename Call::Signature::Result;
    const Eigen::Index n = std::max<Eigen::Index>(0, size_of(views...));
    [&]<class... P>(std::type_identity<std::tuple<P...>>) {
      const Declared::Parameter* next =
          function.parameters.data() + function.parameters.size() - sizeof...(P);
      (argument<P, Call::contract>(*next++, views, n), ...);
    }(std::type_identity<typename Call::Signature::Parameters>());
    std::string called = function.name + "(";
    for (std::size_t i = 2 - sizes(); i < 2; ++i) called += text((*shape)[i]) + ", ";
    for (const std::string& one : passed) called += (&one == &passed.front() ? "" : ", ") + one;
    called += ");\n";
    std::string type = name;
    type[0] = 'C';
    code.statements += "\n  " + type + " " + name + ";\n";

    if constexpr (Call::Signature::returns_matrix) {
      code.statements += "  const auto matrix_of_" + name + " = " + called;
      auto matrix = std::make_unique<WrittenMatrix>();
      const std::array<Eigen::Index, 2> size = Call::Check::shape(views...);
      matrix->product = [this, size, arguments = std::tuple<View&...>(views...)](double* x, double* b) {
        write_product(Eigen::VectorXd::Map(x, size[1]), Eigen::VectorXd::Map(b, size[0]), arguments);
      };
      return matrix;
    } else {
      constexpr bool returns = !std::is_void_v<Result>;
      if constexpr (returns) members += "  " + std::string(type_name<Result>()) + " result{};\n";
      code.statements += "  " + (returns ? name + ".result = " : "") + called;
      if (request.reply)
        for_each_returned<Call>(*request.reply, [&](int i, const auto& value) {
          saw(i < 0 ? "result" : function.parameters[sizes() + static_cast<std::size_t>(i)].name, value);
        });
      if constexpr (returns) return {};  // nobody reads it
    }
  }

  template <class Value>
  void saw(const std::string& path, const Value& value) {
    for_each_leaf(path, value, [&](const std::string& leaf, const std::vector<double>& numbers) {
      code.seen.insert(code.seen.end(), numbers.begin(), numbers.end());
      show += "    seen.add(\"" + name + "." + leaf + "\", " + leaf + ");\n";
    });
  }

  // The matrix may have been made of other arguments than it has at its products.
  template <class Arguments>
  void write_product(const Eigen::VectorXd& x, const Eigen::VectorXd& filling, const Arguments& arguments) {
    const std::string product = "product_" + std::to_string(++products);
    members += "  Eigen::VectorXd " + product + " = " + literal(filling) + ";\n";
    if (products == 1) {
      members += "  Eigen::VectorXd factor = " + literal(x) + ";\n";
      std::size_t i = 0;
      const auto look = [&](const auto& view) {
        if constexpr (!kIsObject<std::remove_cvref_t<decltype(view)>>)
          if (const std::string now = literal(value_of(view)); !literals[i].empty() && now != literals[i]) {
            // A vector stays in its place, which the matrix may know.
            const char* kept = DenseNumbers<std::remove_cvref_t<decltype(view)>> ? ".array()" : "";
            replace += "    " + function.parameters[sizes() + i].name + kept + " = " + now + kept + ";\n";
          }
        ++i;
      };
      std::apply([&](const auto&... views) { (look(views), ...); }, arguments);
      if (!replace.empty()) code.statements += "  " + name + ".replace();\n";
    }
    code.statements += "  matrix_of_" + name + "->matVecMult(" + name + ".factor.data(), " + name + "." +
                       product + ".data());\n";
  }

  void end() {
    if (products > 0 && request.reply) {
      MessageReader reply = *request.reply;
      Eigen::VectorXd numbers;
      for (int i = 1; i <= products; ++i)
        decode(reply, numbers), saw("product_" + std::to_string(i), numbers);
      decode(reply, numbers);
      saw("factor", numbers);
    }
    const std::string number = name.substr(4);
    code.statements += "  " + name + ".show(seen);\n";
    code.inputs += "struct Call" + number + " {\n  Recorded answers{ANSWERS, " + number + "};\n" + members +
                   "\n  void replace() {\n" + replace +
                   "  }\n  void show([[maybe_unused]] Seen& seen) const {\n" + show + "  }\n};\n\n";
    const auto add = [&](const std::vector<double>& numbers) {
      code.answers += " " + std::to_string(numbers.size());
      for (const double one : numbers) code.answers += " " + number_literal(one);
    };
    for (const Recording::Product& product : request.products) {
      if (!product.go_on) continue;  // grading ended the call here
      code.answers += number + " " + std::to_string(product.which);
      add(product.question);
      add(product.result);
      code.answers += "\n";
    }
  }
};

struct CallHost : Writing {
  WrittenCall* written;
  template <class Call, class... View>
  typename Call::Signature::Result call(View&&... views) {
    return written->call<Call>(views...);
  }
};

// Writes the body of a given function for one call: it asks the caller's matrices what grading asked, and
// returns what grading returned.
struct GivenHost : Writing {
  const Declared* function;
  const Recording::GivenCall* given;
  std::string* body;

  template <class Call, class... View>
  typename Call::Signature::Result call(View&&... views) {
    using Result = typename Call::Signature::Result;
    if constexpr (Call::Signature::returns_matrix)
      throw NotWritable("the student's code keeps a matrix of the given function " + function->name);
    const Declared::Parameter* const first =
        function->parameters.data() + function->parameters.size() - sizeof...(View);
    const Eigen::Index n = std::max<Eigen::Index>(0, size_of(views...));
    std::vector<std::pair<std::string, Eigen::Index>> matrices;
    const Declared::Parameter* next = first;
    const auto look = [&](const auto& view) {
      using T = std::remove_cvref_t<decltype(view)>;
      const std::string name = (next->is_pointer ? "*" : "") + next->name;
      if constexpr (std::is_same_v<T, Operator>) matrices.emplace_back(name, view.rows);
      if constexpr (std::is_base_of_v<implicitMatrix, T>) matrices.emplace_back(name, n);
      ++next;
    };
    (look(views), ...);
    for (const auto& [which, question] : given->callbacks)
      if (which >= 0 && static_cast<std::size_t>(which) < matrices.size())
        *body += "      ask(" + matrices[static_cast<std::size_t>(which)].first + ", vector(" +
                 joined(question, number_literal) + "), " +
                 text(matrices[static_cast<std::size_t>(which)].second) + ");\n";
    std::string last = "throw std::runtime_error(\"grading ended in this call\")";
    if constexpr (!Call::Signature::returns_matrix)
      if (given->result) {
        last = "return";
        for_each_returned<Call>(*given->result, [&](int i, const auto& value) {
          if (i < 0) {
            last += " " + literal(value);
            return;
          }
          std::string place = (first[i].is_pointer ? "*" : "") + first[i].name;
          if constexpr (DenseNumbers<std::remove_cvref_t<decltype(value)>>)
            if (first[i].is_pointer)
              place = "Eigen::VectorXd::Map(" + first[i].name + ", " + text(value.size()) + ")";
          *body += "      " + place + " = " + literal(value) + ";\n";
        });
      }
    *body += "      " + last + ";\n";
    if constexpr (!std::is_void_v<Result>) return {};
  }
};

// Serves a message of an exercise to a host that is made for the function.
template <class Make>
void serve_to(const std::string& id, MessageReader message,
              const std::map<std::string, std::vector<Declared>>& functions, const Make& make_host) {
  const auto number = static_cast<std::size_t>(MessageReader(message).get<int>());
  if (number >= functions.at(id).size())
    throw NotWritable("it calls a function of the suite's own, beside those of the contract");
  for_each_exercise([&]<class Calls>() {
    if (id != Calls::id) return;
    MessageWriter nobody_reads;
    auto host = make_host(functions.at(id)[number]);
    serve<Calls>(host, message, nobody_reads);
  });
}

}  // namespace

CallsAsCode as_code(const std::vector<Recording::Request>& requests, const std::string& exercise,
                    const std::map<std::string, std::vector<Declared>>& functions) {
  CallsAsCode code;
  std::map<std::string, std::vector<std::string>> bodies;  // by the function's name
  for (const Recording::Request& request : requests) {
    std::optional<WrittenCall> written;
    const std::string name = "call" + std::to_string(&request - requests.data() + 1);
    serve_to(exercise, MessageReader(request.message.bytes()), functions, [&](const Declared& function) {
      return CallHost{{}, &written.emplace(WrittenCall{function, request, name, code})};
    });
    written->end();
    for (const Recording::GivenCall& call : request.calls) {
      MessageReader message = call.call;
      const std::string id = message.get_text();
      serve_to(id, message, functions, [&](const Declared& function) {
        return GivenHost{{}, &function, &call, &bodies[function.name].emplace_back()};
      });
    }
  }
  for (const auto& [id, all] : functions)
    for (const Declared& function : all) {
      if (id == exercise) continue;
      const std::size_t end = function.name.rfind("::");
      const bool is_in = end != std::string::npos;
      code.given += (is_in ? "\nnamespace " + function.name.substr(0, end) + " {\n" : "\n") + function.text +
                    " {\n  static int call = 0;\n  switch (call++) {\n";
      int place = 0;
      for (const std::string& body : bodies[function.name])
        code.given += "    case " + std::to_string(place++) + ": {\n" + body + "    }\n";
      code.given += "  }\n  throw std::runtime_error(\"grading saw fewer calls of " + function.name +
                    "\");\n}\n" + (is_in ? "}\n" : "");
    }
  return code;
}

}  // namespace grader::judge
