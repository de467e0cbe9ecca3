#pragma once
// The methods that gauss-sim offers, by name.

#include <memory>
#include <string>
#include <vector>

#include "sim/drive/integrator.hpp"

namespace gausssim {

struct MethodInfo {
  std::string name;
  std::string library;
  int order = 0;
  bool takes_step = false;  ///< steps of one length instead of a tolerance
  std::string about;
};

const std::vector<MethodInfo>& methods();
const MethodInfo* find_method(const std::string& name);

/// Which states are put back onto what constraints ask for, after each step.
enum class Projection { off, full, positions, velocities };

template <class S>
struct MethodSettings {
  S tolerance = S(1e-9);
  S step = S(1e-3);
  S longest_step = S(0);  ///< 0: any
  Projection projection = Projection::full;
  long most_steps = 100'000'000;
  int order = 0;  ///< of series; 0: by the tolerance
};

/// Null where the method does not take the model; `why` says it then.
template <class S>
std::unique_ptr<Integrator<S>> make_integrator(const std::string& method, const MotionModel<S>& model,
                                               const Numbers<S>& start, const S& t, const MethodSettings<S>& settings,
                                               std::string& why);

}  // namespace gausssim
