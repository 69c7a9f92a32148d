// STAFF ONLY. S1, asked of the student's worker: the request of grader/worker/serve_S1.cpp. The matrix stays here.
#include <algorithm>
#include <limits>

#include "grader/play/asking.h"
#include "grader/wire/report_message.h"
#include "solver/linearSolver.h"

double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {
  const auto size = static_cast<std::size_t>(n);
  grader::MessageWriter request;
  request.put(n).put(epsilon).put(*steps);
  request.put(std::span<const double>(x, size)).put(std::span<const double>(b, size));
  grader::MessageReader reply = grader::ask_student(
      request, [&](int which, const std::vector<double>& question, std::vector<double>& answer) {
        if (which != 0 || question.size() != size)
          throw grader::MalformedMessage("a question that makes no sense");
        std::vector<double> direction = question;
        answer.resize(size);
        A->matVecMult(direction.data(), answer.data());
        return true;
      });
  const double value = reply.get<double>();
  *steps = grader::get_steps(reply);
  for (double* vector : {x, b}) {
    const std::vector<double> values = reply.get_doubles(size);
    std::copy(values.begin(), values.end(), vector);
  }
  if (grader::overlapped(reply)) std::fill(x, x + size, grader::kNoNumber);
  return value;
}
