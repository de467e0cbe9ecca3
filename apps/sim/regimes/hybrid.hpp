#pragma once
// A motion through regimes: each is integrated by itself, until a guard of it falls through 0 (docs/regimes.md).

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/drive/integrator.hpp"
#include "sim/drive/stopwatch.hpp"
#include "sim/methods/methods.hpp"
#include "sim/regimes/event.hpp"
#include "sim/regimes/standing.hpp"

namespace gausssim {

template <class S>
class Hybrid final : public Integrator<S> {
 public:
  using Array = Numbers<S>;
  struct Setting {
    std::string method;  ///< for regimes that it takes, else that of any model
    MethodSettings<S> of_method;
    Change<S> change;
  };

  Hybrid(std::shared_ptr<RegimeSource> source, Array start, const S& t, Setting setting);

  /// Of an earlier run that ended here, or later: what was broken is so, and events are counted for both.
  void go_on_after(const std::vector<Event>& earlier);

  bool advance_to(const S& end) override;
  S time() const override { return t_; }
  const Array& state() const override { return x_; }
  Progress<S> progress() const override;

  /// The columns of the run at a state that is in the regime which is in force now.
  gauss::Status sample(const S& t, const S* x, S* row) { return regime_->sample(t, x, row); }

  const std::vector<Event>& events() const { return events_; }

  /// Time that went into deriving and compiling regimes.
  const Seconds& making() const { return making_; }
  const Modes& modes() const { return modes_; }

 private:
  /// An end of a step.
  struct Place {
    S t = 0;
    Array x;
    std::vector<S> values, rates;  ///< of guards; rates per second
  };
  struct Watched {
    std::size_t guard;
    S sense;       ///< of a slip that is 0 at the end of its sliding; 1 for others
    bool is_told;  ///< its rate is the guard behind it
  };

  Regime<S>* regime_at(const Modes& modes, std::string& why);
  bool start();
  bool enter(const Modes& modes);
  void step(const S& end);
  S cap(const S& end, std::string& halting) const;
  void note_speeds(const Array& x);
  /// What counts as standing still: speeds beside the largest one so far.
  S slow() const { return S(1e-10) * fastest_; }
  void look_at_guards(Place& place) const;
  void watch();
  std::optional<S> crossing(const Watched& one) const;
  bool is_hit(const Watched& one, const S& at) const;
  std::optional<Place> dip(const Watched& one, const Place& low, const Place& high, int depth) const;
  std::optional<Place> place_at(const S& t) const;
  std::optional<Array> state_at(const S& t) const;
  S value_at(const S& t, const Watched& one) const;
  void happen(const S& t, const std::vector<Watched>& fired);

  Regime<S>* ground();
  /// At the present state.
  bool look(Standing<S>& standing);
  void hit(const std::set<std::string>& closing);
  bool settle(const std::map<std::string, std::string>& banned);
  bool is_consistent(const Modes& modes, const std::set<std::string>& open_at_rest, Array& x, std::string& why);
  std::vector<S> slip_accelerations(const Modes& modes, const std::string& friction, const Array& x);
  void stop(gauss::simulate::Outcome outcome, std::string why);
  void note(const std::string& what, double impulse = 0);
  Modes ground_modes() const;

  std::shared_ptr<RegimeSource> source_;
  Setting setting_;
  std::map<Modes, std::unique_ptr<Regime<S>>> regimes_;
  Seconds making_;
  std::set<std::string> broken_;
  std::set<std::string>
      halted_;     ///< frictions whose slip has come to its end at this instant, whatever rounding has left of it
  S fastest_ = 0;  ///< speed so far
  std::size_t ground_size_ = 0;   ///< coordinates
  std::set<std::string> closed_;  ///< contacts, beside those that open at this instant
  Modes modes_;
  Regime<S>* regime_ = nullptr;
  std::unique_ptr<Integrator<S>> inner_;
  std::vector<Watched> watched_;                 ///< guards of the regime that may end it
  std::vector<const FrictionSwitch*> slipping_;  ///< in two directions
  Place from_, to_;                              ///< of the last step
  bool is_from_known_ = false;
  S t_, start_;
  Array x_;
  bool is_started_ = false;
  Progress<S> before_;  ///< of inner integrators that are no more
  gauss::simulate::Outcome outcome_ = gauss::simulate::Outcome::running;
  std::string why_;
  std::vector<Event> events_;
  S last_event_ = 0;
  int without_time_ = 0;  ///< events in a row between which no time went by
};

}  // namespace gausssim
