// STAFF ONLY. For tests: sends a request through two servers and two clients. Each one sends what the last
// one read:
//
//   request -> server -> client -> server -> client -> end
//
// The second server must read the same as the first one, and the first client must take the second one's
// reply, whatever the request and the end's reply are. The end may ask about the caller's objects: questions
// go the same way back.
#pragma once

#include <functional>
#include <stdexcept>

#include "grader/calls/client.h"
#include "grader/calls/server.h"

namespace grader::relay {

struct Way {
  std::function<MessageReader(const MessageWriter& request, const Products& products)> end;
  std::function<void(bool kept, const char* promise)> expect;

  // These belong to the last request of the first client.
  std::vector<std::byte> sent, replied;
  bool arrived = false, answered = false;
};

template <class Calls>
class Host;

template <class Calls>
struct Asker {
  Way& way;
  bool second;

  template <auto function>
  void start(MessageWriter&, const auto&...) const {}
  bool served(const particles::Force&) const { return false; }
  void scratch(const auto&, int) const {}
  void changed() const {}

  MessageReader ask(const MessageWriter& request, const Products& products) const {
    if (second) {
      way.arrived = true;
      way.expect(request.bytes() == way.sent, "what a client sends arrives as it was");
      return way.end(request, products);
    }
    way.sent = request.bytes();
    way.arrived = way.answered = false;
    MessageReader reader(way.sent);
    MessageWriter reply;
    Host<Calls> host(way, true, products);
    try {
      serve<Calls>(host, reader, reply);
    } catch (const MalformedMessage&) {
      way.expect(way.arrived, "what a client sends, a server reads");
      throw;
    }
    way.replied = reply.bytes();
    way.answered = true;
    return MessageReader(way.replied);
  }
};

// Calls no function: it asks the next server.
template <class Calls>
class Host {
 public:
  using Vector = UnguardedVector;

  // `products` answers for the client's objects; null: all answers are 0.
  Host(Way& way, bool second, Products products) : asker_{way, second}, products_(std::move(products)) {}

  void ask(const Question& question) {
    std::vector<double> answer(question.answer.size());
    if (products_) products_(question.which, {question.numbers.begin(), question.numbers.end()}, answer);
    if (answer.size() != question.answer.size()) throw MalformedMessage("an answer of another length");
    std::copy(answer.begin(), answer.end(), question.answer.begin());
  }
  template <class Call, class... Arguments>
  typename Call::Signature::Result call(Arguments&&... arguments) {
    if constexpr (Call::Signature::returns_matrix)
      return matrix_of<Calls, Call::function>(asker_, arguments...);
    else
      return grader::ask<Calls, Call::function>(asker_, arguments...);
  }
  void bound(int&, Eigen::Index) {}
  void served(const particles::Force&) {}

 private:
  Asker<Calls> asker_;
  Products products_;
};

// Sends a request on its way. False: a server, or a client, has refused its message; `refused` is called with
// the error.
template <class Calls>
bool send(Way& way, const std::vector<std::byte>& request, const std::function<void(const char*)>& refused) {
  way.arrived = way.answered = false;
  try {
    MessageReader reader(request);
    MessageWriter reply;
    Host<Calls> first(way, false, nullptr);
    serve<Calls>(first, reader, reply);
    return true;
  } catch (const MalformedMessage& error) {
    way.expect(!way.answered, "what a server replies, its client takes");
    refused(error.what());
    return false;
  }
}

}  // namespace grader::relay
