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
  /// `change`: of values of parameters and inputs, as `bind` takes it.
  RegimePool(std::shared_ptr<RegimeSource> source, Change<S> change)
      : source_(std::move(source)), change_(std::move(change)) {}

  const Switches& switches() const { return source_->switches(); }

  /// Derived and compiled when it is first asked for. Null, and why: there is no such regime.
  Regime<S>* at(const Modes& modes, std::string& why) {
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
  std::map<Modes, std::unique_ptr<Regime<S>>> regimes_;
  Seconds making_;
};

}  // namespace gausssim
