#include "hair/truth/cvode.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace hair {

namespace {

constexpr int kInterruptedHere = -7;  // a callback's result below 0 ends CVODE at once
constexpr int kTryShorter = 1;        // above 0: a shorter step may do

using Values = Eigen::Map<Eigen::VectorXd>;

Values values(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

// The data of callbacks. No exception may pass through CVODE, which is C: it is kept, and thrown when CVODE
// has returned.
struct Call {
  Ode& ode;
  const std::atomic<bool>& interrupted;
  BandMatrix matrix;
  std::exception_ptr thrown = nullptr;

  template <typename Work>
  int guard(const Work& work) {
    try {
      if (interrupted) return kInterruptedHere;
      return work() ? 0 : kTryShorter;
    } catch (...) {
      thrown = std::current_exception();
      return -1;
    }
  }
};

int rates(sunrealtype t, N_Vector y, N_Vector dy, void* data) {
  Call& call = *static_cast<Call*>(data);
  return call.guard([&] {
    Values result = values(dy);
    call.ode.rates(t, values(y), result);
    return result.allFinite();
  });
}

int jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
             N_Vector) {
  Call& call = *static_cast<Call*>(data);
  return call.guard([&] {
    BandMatrix& df = call.matrix;
    df.columns.setZero();
    call.ode.jacobian(t, values(y), df);
    const int n = static_cast<int>(df.columns.cols());
    for (int j = 0; j < n; ++j) {
      sunrealtype* column = SUNBandMatrix_Column(matrix, j);  // column[i - j] is entry (i, j)
      for (int i = std::max(0, j - df.above); i <= std::min(n - 1, j + df.below); ++i)
        column[i - j] = df(i, j);
    }
    return df.columns.allFinite();
  });
}

template <auto free_it>
struct Free {
  template <typename T>
  void operator()(T* it) const {
    free_it(it);
  }
};
void free_cvode(void* memory) {
  CVodeFree(&memory);
}
void free_context(SUNContext context) {
  SUNContext_Free(&context);
}
template <typename Handle, auto free_it>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free<free_it>>;

SUNContext make_context() {
  SUNContext context = nullptr;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_Create(SUN_COMM_NULL, &context);
  SUNContext_ClearErrHandlers(context);
#else
  SUNContext_Create(nullptr, &context);
#endif
  return context;
}

#if SUNDIALS_VERSION_MAJOR < 7
void say_nothing(int, const char*, const char*, char*, void*) {}
#endif

class CvodeSolver {
 public:
  CvodeSolver(Ode& ode, const CvodeWay& way, const std::atomic<bool>& interrupted)
      : call_{ode, interrupted, {}},
        context_(make_context()),
        y_(N_VNew_Serial(ode.size(), context_.get())),
        scales_(N_VNew_Serial(ode.size(), context_.get())),
        cvode_(CVodeCreate(way.method == CvodeMethod::bdf ? CV_BDF : CV_ADAMS, context_.get())) {
    values(y_.get()) = ode.start();
    values(scales_.get()) = way.tolerance * ode.scales();
    ode.start_span(0);
    check(CVodeInit(cvode_.get(), rates, 0, y_.get()));
#if SUNDIALS_VERSION_MAJOR < 7
    check(CVodeSetErrHandlerFn(cvode_.get(), say_nothing, nullptr));
#endif
    check(CVodeSetUserData(cvode_.get(), &call_));
    check(CVodeSVtolerances(cvode_.get(), 0, scales_.get()));
    check(CVodeSetMaxNumSteps(cvode_.get(), -1));
    if (way.method == CvodeMethod::bdf)
      solve_by_newton(ode);
    else
      solve_by_fixed_point();
  }

  // Advances to y(until). `fresh`: f was not smooth at the present time. Returns false if interrupted.
  bool advance(double until, bool fresh) {
    if (fresh) call_.ode.start_span(time_);
    if (fresh) check(CVodeReInit(cvode_.get(), time_, y_.get()));
    check(CVodeSetStopTime(cvode_.get(), until));
    const int flag = CVode(cvode_.get(), until, y_.get(), &time_, CV_NORMAL);
    if (call_.interrupted) return false;
    check(flag);
    count();
    time_ = until;
    return true;
  }

  particles::State state() {
    return call_.ode.state(time_, values(y_.get()));
  }

  // CVODE counts from its last restart.
  void add_to(CvodeRun& run) {
    run.evaluations += std::exchange(evaluations_, 0);
  }

 private:
  void solve_by_newton(Ode& ode) {
    const int n = ode.size(), above = ode.above(), below = ode.below();
    matrix_.reset(SUNBandMatrix(n, above, below, context_.get()));
    linear_.reset(SUNLinSol_Band(y_.get(), matrix_.get(), context_.get()));
    check(CVodeSetLinearSolver(cvode_.get(), linear_.get(), matrix_.get()));
    call_.matrix = {Eigen::MatrixXd::Zero(above + 1 + below, n), above, below};
    if (ode.jacobian(0, ode.start(), call_.matrix)) check(CVodeSetJacFn(cvode_.get(), jacobian));
  }

  void solve_by_fixed_point() {
    nonlinear_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get()));
    check(CVodeSetNonlinearSolver(cvode_.get(), nonlinear_.get()));
  }

  void count() {
    long all_evaluations = 0, of_differences = 0;
    CVodeGetNumRhsEvals(cvode_.get(), &all_evaluations);
    if (linear_) CVodeGetNumLinRhsEvals(cvode_.get(), &of_differences);
    evaluations_ = all_evaluations + of_differences;
  }

  void check(int flag) {
    if (call_.thrown) std::rethrow_exception(call_.thrown);
    if (flag >= 0) return;
    const std::unique_ptr<char, Free<std::free>> name(CVodeGetReturnFlagName(flag));
    std::array<char, 32> time;
    std::snprintf(time.data(), time.size(), "%.6g", time_);
    throw std::runtime_error("CVODE gives up after " + std::string(time.data()) + " s (" + name.get() +
                             "): forces that are not finite there, or not smooth, leave nothing to follow");
  }

  Call call_;
  Owned<SUNContext, free_context> context_;
  Owned<N_Vector, N_VDestroy> y_, scales_;
  Owned<SUNMatrix, SUNMatDestroy> matrix_;
  Owned<SUNLinearSolver, SUNLinSolFree> linear_;
  Owned<SUNNonlinearSolver, SUNNonlinSolFree> nonlinear_;
  std::unique_ptr<void, Free<free_cvode>> cvode_;
  sunrealtype time_ = 0;
  long evaluations_ = 0;
};

struct Stop {
  double time;
  bool is_moment, is_break;
};

std::vector<Stop> stops(const Ode& ode, double duration, int moments) {
  std::vector<Stop> all;
  for (int k = 1; k <= moments; ++k) all.push_back({duration * k / moments, true, false});
  for (const double time : ode.breaks()) {
    const double same = 1e-12 * duration;  // CVODE can't advance between two times within rounding
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const Stop& stop) { return time <= stop.time + same; });
    if (at == all.end() || time <= same) continue;
    // The end of a span must not be earlier than the begin of the next one, not even by a rounding error.
    if (time >= at->time - same)
      *at = {time, at->is_moment, true};
    else
      all.insert(at, {time, false, true});
  }
  return all;
}

}  // namespace

std::optional<CvodeRun> run_cvode(Ode& ode, double duration, int moments, const CvodeWay& way,
                                  const std::atomic<bool>& interrupted) {
  CvodeRun run;
  if (ode.size() == 0) {
    for (int k = 0; k <= moments; ++k)
      run.states.push_back(ode.state(duration * k / moments, Eigen::VectorXd()));
    return run;
  }
  CvodeSolver solver(ode, way, interrupted);
  run.states.push_back(solver.state());
  bool fresh = false;
  for (const Stop& stop : stops(ode, duration, moments)) {
    if (!solver.advance(stop.time, fresh)) return {};
    if (stop.is_moment) run.states.push_back(solver.state());
    fresh = stop.is_break;
    if (fresh) solver.add_to(run);
  }
  if (!fresh) solver.add_to(run);
  return run;
}

bool have_cvode() {
  return true;
}

std::string cvode_version() {
  return SUNDIALS_VERSION;
}

}  // namespace hair
