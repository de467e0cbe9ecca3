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
#include "sim/regimes/guarded_step.hpp"
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
  Regime<S>* regime_at(const Modes& modes, std::string& why);
  bool start();
  bool enter(const Modes& modes);
  void step(const S& end);
  S cap(const S& end, std::string& halting) const;
  void note_speeds(const Array& x);
  /// What counts as standing still: speeds beside the largest one so far.
  S slow() const { return S(1e-10) * fastest_; }
  void happen(const S& t, const Array& x, const std::vector<std::size_t>& fired);

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
  std::size_t coordinates_ = 0;
  std::set<std::string> closed_;  ///< contacts, beside those that open at this instant
  Modes modes_;
  Regime<S>* regime_ = nullptr;
  std::unique_ptr<Integrator<S>> inner_;
  std::vector<const FrictionSwitch*> slipping_;  ///< in two directions
  std::optional<GuardedStep<S>> last_step_;
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
