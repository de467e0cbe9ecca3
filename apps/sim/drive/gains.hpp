#pragma once
// Baumgarte's gains, which run inside a plugin (engine/gains_glue.hpp).

#include "sim/drive/functions.hpp"

namespace gausssim {

/// Rates of a model with gains, as long as this lives. `functions` outlives it, and has entries for gains.
template <class S>
class PulledRates {
 public:
  PulledRates(Functions<S>& functions, S gain) : entries_(functions.gains) {
    void* const arguments[] = {&self_, functions.prepared.data(), functions.inputs.data(), &gain};
    entries_.begin(arguments);
    Callable<S> rates({entries_.rates.call, self_}, {ArgumentIs::time, ArgumentIs::state, ArgumentIs::first_result});
    rates.bind(nullptr, nullptr);
    functions.rates = rates;
    functions.jacobian = {};  // it is that of the model without gains
  }
  PulledRates(const PulledRates&) = delete;
  PulledRates& operator=(const PulledRates&) = delete;
  ~PulledRates() {
    void* const arguments[] = {self_};
    entries_.end(arguments);
  }

 private:
  GainsEntries entries_;
  void* self_ = nullptr;
};

}  // namespace gausssim
