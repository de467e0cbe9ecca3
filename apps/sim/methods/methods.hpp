#pragma once
// The methods that gauss-sim offers, by name.

#include <memory>
#include <string>
#include <vector>

#include "sim/drive/integrator.hpp"
#include "sim/drive/projection.hpp"

namespace gausssim {

/// What a method is, and what it asks of a model.
struct MethodInfo {
  std::string name;
  std::string library;      ///< whose code the method itself is
  int least_order = 0;      ///< of methods that choose one; else the same as
  int order = 0;            ///< the largest: what the error of a step of length h goes down with, as h^(order + 1)
  bool takes_step = false;  ///< steps of one length instead of a tolerance
  bool is_stiff = false;    ///< for what decays, or is held, much faster than it moves
  bool projects = true;     ///< onto constraints after each step
  bool sees_jumps = true;   ///< of forces, within a step: its estimate of the error does not always, where it is false
  bool has_long_double = true, has_float = false, has_float128 = false;
  bool ends_at_samples = true;     ///< a step each; else it knows the motion within its steps
  bool tells_steps = false;        ///< can be asked for one step at a time, so that events are found within
  bool is_separable = false;       ///< takes only models whose accelerations depend on coordinates alone
  std::vector<std::string> takes;  ///< outputs of the generator, where a model has them
  std::string about;
  std::string missing;  ///< why it is not built in; empty: it is
};

const std::vector<MethodInfo>& methods();
const MethodInfo* find_method(const std::string& name);

template <class S>
struct MethodSettings {
  S tolerance = S(1e-9);
  S step = S(1e-3);
  S longest_step = S(0);  ///< 0: any
  Projection projection = Projection::full;
  long most_steps = 100'000'000;
  bool (*ends)() = nullptr;         ///< asked before each step: whether none is taken any more
  int order = 0;                    ///< of series; 0: by the tolerance
  bool crosses_lost_digits = true;  ///< as gauss::simulate::Settings has it

  /// In another number type.
  template <class To>
  MethodSettings<To> in() const {
    return {To(tolerance), To(step), To(longest_step), projection, most_steps, ends, order, crosses_lost_digits};
  }
};

/// Why a model cannot be projected so; empty where it can.
template <class S>
std::string why_not_projected(const Functions<S>& functions, Projection how);

/// Null where the method does not take the model, or the model not the projection; `why` says it then.
template <class S>
std::unique_ptr<Integrator<S>> make_integrator(const std::string& name, const MotionModel<S>& model,
                                               const Numbers<S>& start, const S& t, const MethodSettings<S>& settings,
                                               std::string& why);

}  // namespace gausssim
