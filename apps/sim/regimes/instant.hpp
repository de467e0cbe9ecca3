#pragma once
// Where a motion through regimes is, and what is known there beside its state.

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "sim/drive/integrator.hpp"
#include "sim/regimes/regime.hpp"

namespace gausssim {

template <class S>
struct Instant {
  S t = 0, start = 0, last_event = 0;
  Numbers<S> x;
  std::size_t coordinates = 0;       ///< of the state, which stand before its speeds
  Numbers<S> sizes;                  ///< largest of each component so far
  S fastest = 0;                     ///< speed so far
  S rounded_speed = 0;               ///< of what falls from as far as places are, the part that has no digits
  Numbers<S> rounding;               ///< of rates, where forces cancel that accelerate a body while nothing holds it
  std::map<std::string, S> reaches;  ///< of gaps of contacts: Regime::reaches
  std::set<std::string> closed;      ///< contacts, beside those that open at this instant
  std::set<std::string> halted;  ///< frictions whose slip has come to its end here, whatever rounding has left of it
  std::set<std::string> broken;

  /// What counts as standing still: speeds beside the largest one so far, and what rounding leaves.
  S slow() const { return std::max(S(S(1e-10) * fastest), rounded_speed); }
  void note_sizes(const Numbers<S>& state) {
    sizes.resize(state.size(), S(0));
    for (std::size_t i = 0; i < state.size(); ++i) sizes[i] = std::max(sizes[i], gauss::event::magnitude_of(state[i]));
    fastest = std::max(fastest, largest_of(state.data() + coordinates, state.size() - coordinates));
  }

  /// In which rates of change are told by differences: part of the time in this regime, or in one that has just begun.
  S a_while(const S& part, const S& least) const { return part * std::max(S(t - last_event), least); }

  /// What touches and does not part, whether it has a reaction or others hold it there.
  bool touches(const std::string& contact, const S& gap, const S& gap_rate) const {
    if (gap_rate > slow()) return false;
    return closed.count(contact) > 0 || (gap <= S(1e-9) * reaches.at(contact) && !(gap_rate < -slow()));
  }

  /// What an integrator cannot know of the motion before it.
  void tell(Integrator<S>& integrator) const {
    integrator.know_sizes(sizes);
    integrator.know_rounding(rounding);
  }

  Modes ground_modes(const Switches& switches) const {
    Modes modes = ground_of(switches);
    for (const std::string& link : broken) modes[link] = "broken";
    return modes;
  }
};

}  // namespace gausssim
