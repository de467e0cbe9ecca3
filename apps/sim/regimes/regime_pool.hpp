#pragma once
// The regimes of one run, with its numbers.

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "sim/drive/stopwatch.hpp"
#include "sim/regimes/regime.hpp"

namespace gausssim {

template <class S>
class RegimePool {
 public:
  /// `change`: of values of parameters and inputs, as `bind` takes it. `ends`: whether no regime is made any more; may be null.
  RegimePool(std::shared_ptr<RegimeSource> source, Change<S> change, bool (*ends)())
      : source_(std::move(source)), change_(std::move(change)), ends_(ends) {}

  const Switches& switches() const { return source_->switches(); }

  bool has_ended() const { return ends_ != nullptr && ends_(); }

  /// Derived and compiled when it is first asked for. Null, and why: there is no such regime.
  Regime<S>* at(const Modes& modes, std::string& why) {
    if (regimes_.count(modes) == 0 && has_ended()) return why = "interrupted", nullptr;
    const auto [place, is_new] = regimes_.try_emplace(modes);
    if (is_new) {
      const Stopwatch watch;
      if (auto model = source_->at(modes, why)) place->second = std::make_unique<Regime<S>>(std::move(model), change_);
      making_ += watch.seconds();
    }
    return place->second.get();
  }

  /// Time that went into deriving and compiling them.
  const Seconds& making() const { return making_; }

 private:
  std::shared_ptr<RegimeSource> source_;
  Change<S> change_;
  bool (*ends_)();
  std::map<Modes, std::unique_ptr<Regime<S>>> regimes_;
  Seconds making_;
};

}  // namespace gausssim
