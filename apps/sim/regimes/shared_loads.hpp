#pragma once
// Guards of reactions that are not unique: what they are of the share of the load that leaves the most to all (docs/regimes.md).

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gauss/event/load_shares.hpp"
#include "sim/engine/binding.hpp"
#include "sim/regimes/parts.hpp"
#include "sim/regimes/switches.hpp"

namespace gausssim {

template <class S>
class SharedLoads {
 public:
  /// `load_system`: as the generator emits it of regimes that hold more than is needed; without a function all guards stand.
  /// `guards` and `fixed` outlive this.
  SharedLoads(Callable<S> load_system, std::size_t speeds, const std::vector<GuardOf>& guards,
              const std::vector<char>& fixed)
      : load_system_(std::move(load_system)), speeds_(speeds), guards_(guards), fixed_(fixed) {}

  bool are_possible() const { return static_cast<bool>(load_system_); }

  /// Of a state, the contacts that nothing presses but friction.
  using Unloaded = std::function<std::set<std::string>(const S& t, const Numbers<S>& x)>;
  void ask_unloaded(Unloaded unloaded) { unloaded_ = std::move(unloaded); }

  /// Puts margins in place of values of such guards: in N, or N*m, and below 0 where no share holds.
  void judge(const S& t, const Numbers<S>& x, std::vector<S>& values) const {
    if (!load_system_) return;
    std::vector<std::size_t> places;
    for (std::size_t g = 0; g < guards_.size(); ++g)
      if (!guards_[g].rows.empty()) places.push_back(g);
    const std::size_t n = speeds_, l = fixed_.size(), k = places.size();
    std::vector<S> filled(n * n + l * n + l + k + k * l, S(0));
    if (!gauss::integrate::is_motion_known(load_system_(t, x.data(), filled.data()))) return;
    gauss::event::LoadProblem<S> problem;
    problem.speeds = n;
    problem.is_fixed = fixed_;
    std::vector<S> limits, per_reaction;
    take_parts<S>(filled, {{&problem.metric, n * n},
                           {&problem.rows, l * n},
                           {&problem.reactions, l},
                           {&limits, k},
                           {&per_reaction, k * l}});
    for (std::size_t i = 0; i < k; ++i) {
      const GuardOf& guard = guards_[places[i]];
      const auto own = per_reaction.begin() + static_cast<std::ptrdiff_t>(i * l);
      problem.judged.push_back(
          {guard.rows, guard.has_limit, limits[i], {own, own + static_cast<std::ptrdiff_t>(l)}, guard.is_brittle});
    }
    std::optional<std::set<std::string>> unloaded;
    problem.is_unloaded = [&](std::size_t i) {
      if (!unloaded) unloaded = unloaded_ ? unloaded_(t, x) : std::set<std::string>();
      return unloaded->count(guards_[places[i]].of) > 0;
    };
    gauss::event::LoadShares<S> shares(problem);
    // Contacts alone move a body alike by any share: they have the least one, which is reported.
    const bool has_limits = std::any_of(problem.judged.begin(), problem.judged.end(),
                                        [](const auto& one) { return one.has_limit || one.is_brittle; });
    const std::vector<std::optional<S>> margins = has_limits ? shares.margins() : std::vector<std::optional<S>>(k);
    for (std::size_t i = 0; i < k; ++i) {
      S& value = values[places[i]];
      if (margins[i]) {
        value = *margins[i];
      } else if (!problem.judged[i].has_limit) {
        const S largest = largest_of_contacts(problem);
        const S left = gauss::event::magnitude_of(value - problem.reactions[guards_[places[i]].rows.front()]);
        // Forces contain the reactions of constraints that were chosen when code was generated: here these say less than they did. (The direction of a
        // slip that begins has few digits.)
        if (left > S(1e-2) * largest) value = S(std::numeric_limits<double>::quiet_NaN());
        // Of a share that stands, as that which sliding friction has, a reaction that is none is that but for rounding.
        if (shares.is_shared(i)) value += S(1e-9) * largest;
      }
    }
  }

 private:
  static S largest_of_contacts(const gauss::event::LoadProblem<S>& problem) {
    S largest = 0;
    for (const auto& one : problem.judged)
      if (!one.has_limit) largest = std::max(largest, gauss::event::magnitude_of(problem.reactions[one.rows.front()]));
    return largest;
  }

  Callable<S> load_system_;
  std::size_t speeds_;
  const std::vector<GuardOf>& guards_;
  const std::vector<char>& fixed_;
  Unloaded unloaded_;
};

}  // namespace gausssim
