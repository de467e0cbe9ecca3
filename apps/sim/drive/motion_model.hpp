#pragma once
// A model at run time, in the form that integrators of src/gauss/ take.

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "gauss/integrate/corrections.hpp"
#include "gauss/math.hpp"
#include "sim/drive/functions.hpp"
#include "sim/drive/numbers.hpp"
#include "sim/drive/projection.hpp"

namespace gausssim {

namespace detail {

/// The container of the same kind for something else.
template <class Array, class T>
struct Rebound;
template <class S, class T>
struct Rebound<Numbers<S>, T> {
  using type = boost::container::small_vector<T, k_in_place>;
};
template <class S, std::size_t room, class T>
struct Rebound<InPlace<S, room>, T> {
  using type = InPlace<T, room>;
};

}  // namespace detail

/// In the sense of gauss/integrate/state_arrays.hpp. Functions of a model neither read nor fill what an array has beyond its state.
template <class S, class ArrayType = Numbers<S>>
class MotionModel {
 public:
  using Scalar = S;
  using Status = gauss::Status;
  using Array = ArrayType;
  template <class T>
  using Of = typename detail::Rebound<Array, T>::type;
  struct State {
    Array values;
  };
  struct Derivative {
    Array values;
  };
  struct Energy {
    S kinetic = 0, total = 0;
  };

  explicit MotionModel(std::shared_ptr<const Functions<S>> functions) : functions_(std::move(functions)) {}
  /// The same, with other arrays.
  template <class Other>
  explicit MotionModel(const MotionModel<S, Other>& model)
      : functions_(model.functions_), how_(model.how_), level_(model.level_), has_level_(model.has_level_) {}

  std::size_t size() const { return functions_->size(); }
  std::size_t coordinates() const { return functions_->n_q; }
  const char* unit(std::size_t component) const {
    return component < functions_->units.size() ? functions_->units[component].c_str() : "beyond the state";
  }
  const Functions<S>& functions() const { return *functions_; }
  const std::shared_ptr<const Functions<S>>& shared_functions() const { return functions_; }

  Status rates(const S& t, const Array& x, Array& dxdt) const { return functions_->rates(t, x.data(), dxdt.data()); }
  Status derivative(const S& t, const State& state, Derivative& result) const {
    gauss::integrate::fit(result.values, size());
    return rates(t, state.values, result.values);
  }
  Status energy(const S& t, const State& state, Energy& result) const {
    const EnergyLayout& layout = functions_->energy_layout;
    Numbers<S> values(layout.size, S(0));
    const Status status = functions_->energy(t, state.values.data(), values.data());
    result = {values[layout.kinetic], values[layout.total]};
    return status;
  }

  bool has_jacobian() const { return static_cast<bool>(functions_->jacobian); }
  /// As gauss::integrate::OwnJacobian says.
  template <class Fill>
  Status jacobian(const S& t, const State& state, const Fill& fill) const {
    const JacobianLayout& layout = functions_->jacobian_layout;
    Numbers<S> values(layout.size, S(0));
    const Status status = functions_->jacobian(t, state.values.data(), values.data());
    for (std::size_t i = 0; i + 1 < layout.row_begin.size(); ++i)
      for (std::size_t k = layout.row_begin[i]; k < layout.row_begin[i + 1]; ++k)
        fill(i, layout.column[k], values[layout.first + k]);
    return status;
  }

  /// The same model, whose energy is to be kept at a level that is known from an earlier start.
  MotionModel keeping(const S& level) const {
    MotionModel result = *this;
    result.level_ = level;
    result.has_level_ = true;
    return result;
  }
  /// The same model, which projects otherwise. `start`: its energy is the one to be kept, where no other is.
  MotionModel projecting(Projection how, const S& t, const Array& start) const {
    MotionModel result = *this;
    result.how_ = how;
    if (how != Projection::energy || has_level_) return result;
    State state{start};
    Energy found;
    const bool is_known = gauss::integrate::is_motion_known(onto(functions_->projection, t, state)) &&
                          gauss::integrate::is_motion_known(energy(t, state, found));
    // What is not known is not kept, and the first step says why there is no motion.
    result.level_ = is_known ? found.total : std::numeric_limits<S>::quiet_NaN();
    return result;
  }
  /// The energy that projection keeps, of a model that projects so.
  const S& level() const { return level_; }
  bool projects() const {
    if (how_ == Projection::off || how_ == Projection::gains) return false;
    return how_ == Projection::energy || (functions_->projection && functions_->is_constrained);
  }

  bool keeps_energy() const { return how_ == Projection::energy; }
  /// All constraints; a model without any stays where it is.
  Status constraint_projection(const S& t, State& state) const {
    const Status status = onto(functions_->projection, t, state);
    if (functions_->projection) forget_remains(state);
    return status;
  }
  /// As it was chosen.
  Status projection(const S& t, State& state) const {
    using namespace gauss::integrate;
    const Whole whole{*this};
    switch (how_) {
      case Projection::positions: return ToPositions::apply(whole, t, state);
      case Projection::velocities: return functions_->speeds ? ToSpeeds::apply(whole, t, state) : to_all(t, state);
      default: return to_all(t, state);
    }
  }

 private:
  template <class, class>
  friend class MotionModel;

  /// What a level of projection asks a model for.
  struct Whole {
    using Scalar = S;
    using State = typename MotionModel::State;
    const MotionModel& model;

    Status projection(const S& t, State& state) const { return onto(model.functions_->projection, t, state); }
    Status position_step(const S& t, State& state) const { return onto(model.functions_->positions, t, state); }
    Status speed_step(const S& t, State& state) const { return onto(model.functions_->speeds, t, state); }
  };

  Status to_all(const S& t, State& state) const {
    const Status status = constraint_projection(t, state);
    if (keeps_energy() && gauss::integrate::is_motion_known(status))
      gauss::integrate::detail::to_energy<Energy>(*this, t, level_, state);
    return status;
  }

  /// What has come to rest is slower after each projection, until squares of its speeds have no digits, and whether rows agree is told by these.
  void forget_remains(State& state) const {
    const S root = gauss::Math<S>::epsilon() * gauss::Math<S>::epsilon(), least = root * root;
    for (std::size_t i = functions_->n_q; i < state.values.size(); ++i)
      if (gauss::integrate::magnitude(state.values[i]) < least) state.values[i] = S(0);
  }

  static Status onto(const Callable<S>& function, const S& t, State& state) {
    if (!function) return Status::ok;
    const State before = state;
    return function(t, before.values.data(), state.values.data());
  }

  std::shared_ptr<const Functions<S>> functions_;
  Projection how_ = Projection::full;
  S level_ = 0;  ///< of the energy
  bool has_level_ = false;
};

}  // namespace gausssim
