// What CVODE and ARKODE of SUNDIALS (version 6) have in common: their objects with owners, and an emitted model as their callbacks.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_SUNDIALS_HPP
#define GAUSS_INTEGRATE_SUNDIALS_HPP

#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/state_arrays.hpp"
#include "gauss/integrate/step_result.hpp"

static_assert(SUNDIALS_VERSION_MAJOR == 6, "SUNDIALS 6 is expected: other versions call things by other names");

namespace gauss::integrate {

/// SUNDIALS forms the Jacobian by differences of rates: one evaluation for each component of the state, and half of the digits.
struct ByDifferences {};

/// The emitted Jacobian of a model with the output `jacobian`:
/// `EmittedJacobian<gauss::pendulum::Jacobian<double>, gauss::pendulum::JacobianByState>`.
template <class JacobianType, class PatternType>
struct EmittedJacobian {
  using Jacobian = JacobianType;
  using Pattern = PatternType;
};

/// Of a model that knows at run time whether it has one: `has_jacobian()`, and `jacobian(t, state, fill)`, which calls fill(row, column, value) for what may not
/// be 0. Differences, where it has none.
struct OwnJacobian {};

namespace sundials {

template <class Handle>
using Target = std::remove_pointer_t<Handle>;

struct Free {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};

template <class Handle>
using Owner = std::unique_ptr<Target<Handle>, Free>;

/// SUNDIALS creates null where memory is short, and there only: its other arguments are ours.
template <class Handle>
Handle created(Handle handle) {
  if (handle == nullptr) throw std::bad_alloc();
  return handle;
}

inline SUNContext new_context() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  return created(context);
}

/// The state, and what Newton's method needs. Members are freed in the opposite order.
struct Workspace {
  explicit Workspace(sunindextype size)
      : context(new_context()),
        state(created(N_VNew_Serial(size, context.get()))),
        matrix(created(SUNDenseMatrix(size, size, context.get()))),
        solver(created(SUNLinSol_Dense(state.get(), matrix.get(), context.get()))) {}

  Owner<SUNContext> context;
  Owner<N_Vector> state;
  Owner<SUNMatrix> matrix;
  Owner<SUNLinearSolver> solver;
};

// What an outcome reports is no business of the terminal.
inline void be_quiet(int, const char*, const char*, char*, void*) {}

/// The model as SUNDIALS calls it. `user_data` is the problem.
template <class Model, class Derivatives>
class Problem {
 public:
  using State = typename Model::State;
  static_assert(std::is_same_v<typename Model::Scalar, sunrealtype>, "SUNDIALS computes in double");
  static constexpr bool has_jacobian = !std::is_same_v<Derivatives, ByDifferences>;

  /// Rates; 1 where the model has a status that stops a motion, which a shorter step may avoid.
  static int rates(sunrealtype t, N_Vector y, N_Vector result, void* user_data) {
    return self(user_data).guarded([&](Problem& problem) {
      auto derivative = Arrays::rates(*problem.model_);
      ++problem.calls_;
      const Status status = problem.model_->derivative(t, state_of(y), derivative);
      std::copy(std::begin(derivative.values), std::end(derivative.values), N_VGetArrayPointer(result));
      return status;
    });
  }

  static int jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix result, void* user_data, N_Vector, N_Vector,
                      N_Vector) {
    static_assert(has_jacobian, "only for a model that was generated with `jacobian`");
    return self(user_data).guarded([&](Problem& problem) {
      ++problem.jacobians_;
      SUNMatZero(result);
      const auto fill = [&](std::size_t row, std::size_t column, double value) {
        SM_ELEMENT_D(result, static_cast<sunindextype>(row), static_cast<sunindextype>(column)) = value;
      };
      return problem.fill_jacobian(t, state_of(y), fill);
    });
  }

  /// Calls fill(row, column, value).
  template <class Fill>
  Status fill_jacobian(double t, const State& state, const Fill& fill) const {
    if constexpr (std::is_same_v<Derivatives, OwnJacobian>) {
      return model_->jacobian(t, state, fill);
    } else {
      using Pattern = typename Derivatives::Pattern;
      static_assert(Pattern::rows == Model::size, "the pattern is not that of this model");
      typename Derivatives::Jacobian entries;
      const Status status = model_->derivatives(t, state, entries);
      for (int i = 0; i < Pattern::rows; ++i)
        for (int k = Pattern::row_begin[i]; k < Pattern::row_begin[i + 1]; ++k)
          fill(static_cast<std::size_t>(i), static_cast<std::size_t>(Pattern::column[k]), entries.by_state[k]);
      return status;
    }
  }

  /// Whether `jacobian` may be called.
  static bool is_jacobian_there([[maybe_unused]] const Model& model) {
    if constexpr (std::is_same_v<Derivatives, OwnJacobian>) {
      return model.has_jacobian();
    } else {
      return has_jacobian;
    }
  }

  /// Calls back into the model; what that throws must not fly through C.
  template <class Callback>
  int guarded(Callback&& callback) {
    try {
      const Status status = callback(*this);
      if (is_motion_known(trouble_) && status != Status::ok) trouble_ = status;
      return is_motion_known(status) ? 0 : 1;
    } catch (...) {
      thrown_ = std::current_exception();
      return -1;
    }
  }

  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

  static State state_of(N_Vector y) {
    const double* const values = N_VGetArrayPointer(y);
    if constexpr (HasOwnArrays<Model>::value) {
      return {typename Arrays::Array(values, values + N_VGetLength(y))};
    } else {
      State state;
      std::copy_n(values, Model::size, state.values);
      return state;
    }
  }
  static void copy(const State& state, N_Vector y) {
    std::copy(std::begin(state.values), std::end(state.values), N_VGetArrayPointer(y));
  }
  static Problem& self(void* user_data) { return *static_cast<Problem*>(user_data); }

  void set_model(const Model& model) { model_ = &model; }
  const Model& model() const { return *model_; }
  /// The first status that stops a motion since the last forget_trouble(), or else a milder one.
  Status trouble() const { return trouble_; }
  void forget_trouble() { trouble_ = Status::ok; }
  long calls() const { return calls_; }
  long jacobians() const { return jacobians_; }

 private:
  using Arrays = StateArrays<Model>;

  const Model* model_ = nullptr;
  Status trouble_ = Status::ok;
  std::exception_ptr thrown_;
  long calls_ = 0;
  long jacobians_ = 0;
};

}  // namespace sundials

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_SUNDIALS_HPP
