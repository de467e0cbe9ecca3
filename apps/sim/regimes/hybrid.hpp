#pragma once
// A motion through regimes: each is integrated by itself, until a guard of it falls through 0 (docs/regimes.md).

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/drive/integrator.hpp"
#include "sim/methods/methods.hpp"
#include "sim/regimes/event.hpp"
#include "sim/regimes/guarded_step.hpp"
#include "sim/regimes/instant.hpp"
#include "sim/regimes/next_regime.hpp"
#include "sim/regimes/regime_pool.hpp"
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
  S time() const override { return here_.t; }
  const Array& state() const override { return here_.x; }
  Progress<S> progress() const override;

  /// The columns of the run at a state that is in the regime which is in force now.
  gauss::Status sample(const S& t, const S* x, S* row) { return regime_->sample(t, x, row); }

  const std::vector<Event>& events() const { return events_; }

  /// Time that went into deriving and compiling regimes.
  const Seconds& making() const { return pool_.making(); }
  const Modes& modes() const { return modes_; }
  /// That is in force.
  const Regime<S>& regime() const { return *regime_; }

 private:
  bool start();
  void enter(NextRegime<S> next);
  void find_rounding();
  void integrate_by(const std::string& method);
  void step(const S& end);
  S cap(const S& end, std::string& halting) const;
  void watch_stiffness(const S& step);
  void happen(const S& t, const Array& x, const std::vector<std::size_t>& fired);

  Regime<S>* ground();
  /// At the present state.
  bool look(Standing<S>& standing);
  void hit_at(const std::set<std::string>& closing);
  using Bans = std::map<std::string, std::string>;
  bool settle(const Bans& banned, const Bans& ended_here);
  void stop(gauss::simulate::Outcome outcome, std::string why);
  void note(const std::string& what, double impulse = 0);

  RegimePool<S> pool_;
  Setting setting_;
  Instant<S> here_;
  Modes modes_;
  Regime<S>* regime_ = nullptr;
  std::string method_;  ///< that is in force
  std::unique_ptr<Integrator<S>> inner_;
  std::vector<const FrictionSwitch*> slipping_;  ///< in two directions
  int unwatched_ = 0;                            ///< steps since the last look at how stiff they are
  std::optional<GuardedStep<S>> last_step_;
  bool is_started_ = false;
  Progress<S> before_;  ///< of inner integrators that are no more
  gauss::simulate::Outcome outcome_ = gauss::simulate::Outcome::running;
  std::string why_;
  std::vector<Event> events_;
  int without_time_ = 0;                           ///< events in a row between which no time went by
  std::map<std::string, std::string> ended_here_;  ///< modes that came to their end at this instant
};

}  // namespace gausssim
