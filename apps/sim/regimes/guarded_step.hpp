#pragma once
// The last step within a regime, and which of its guards falls through 0 first within it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/methods/methods.hpp"
#include "sim/regimes/instant.hpp"
#include "sim/regimes/regime.hpp"

namespace gausssim {

template <class S>
class GuardedStep {
 public:
  using Array = Numbers<S>;

  struct Fired {
    S t = 0;
    std::vector<std::size_t> guards;  ///< all of this instant
  };

  /// Steps begin `here`, where the regime is entered, and are made by `method`. `regime` and `here` outlive this.
  GuardedStep(const Regime<S>& regime, const Modes& modes, const Instant<S>& here, std::string method,
              const MethodSettings<S>& of_method);

  /// The next step, from the end of the last one on.
  void end_at(const S& t, const Array& x);

  /// A guard that has no value at its end; empty: all have.
  std::string undefined() const;

  /// `slow`: a speed that counts as none.
  std::optional<Fired> first(const S& slow) const;

  /// Within the step, by steps that end there.
  std::optional<Array> state_at(const S& t) const;

 private:
  struct Place {
    S t = 0;
    Array x;
    std::vector<S> values, rates;  ///< of guards; rates per second
  };
  struct Watched {
    std::size_t guard;
    S sense;       ///< of a slip that is 0 at the end of its sliding; 1 for others
    bool is_told;  ///< its rate is the guard behind it
    bool is_slip;
  };

  S uncertainty_of(std::size_t guard, const S& t) const;
  void look_at_guards(Place& place) const;
  std::optional<S> crossing(const Watched& one, const S& slow) const;
  bool is_hit(const Watched& one, const S& at, const S& slow) const;
  std::optional<S> first_hit(const Watched& one, S low, S high, const S& slow, const S& nearness) const;
  std::optional<Place> dip(const Watched& one, const Place& low, const Place& high, const S& slow, int depth) const;
  std::optional<Place> place_at(const S& t) const;
  S value_at(const S& t, const Watched& one) const;

  const Regime<S>& regime_;
  const Instant<S>& here_;
  S entered_;
  std::string method_;
  MethodSettings<S> of_method_;
  std::vector<Watched> watched_;  ///< guards that may end the regime
  Place from_, to_;
};

}  // namespace gausssim
