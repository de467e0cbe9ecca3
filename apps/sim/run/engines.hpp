#pragma once
// The functions of one model in the number types that turn out to be needed.

#include <map>
#include <memory>
#include <string>

#include "sim/run/build_engine.hpp"

namespace gausssim {

class Engines {
 public:
  /// `prepared` outlives this.
  Engines(const PreparedModel& prepared, EngineChoice choice) : prepared_(prepared), choice_(choice) {}

  /// As scenes call number types; built when it is asked for first. Null: `why()`. Throws as `build_engine`.
  const Engine* of(const std::string& number) {
    const auto known = engines_.find(number);
    if (known != engines_.end()) return known->second.get();
    EngineTimes times;
    auto engine = build_engine(prepared_, choice_, {scalar_of(number)}, times, why_);
    times_.compile += times.compile;
    times_.was_cached = times.was_cached;
    times_.why_interpreted = times.why_interpreted;
    return (engines_[number] = std::move(engine)).get();
  }

  const std::string& why() const { return why_; }
  const EngineTimes& times() const { return times_; }

 private:
  const PreparedModel& prepared_;
  EngineChoice choice_;
  std::map<std::string, std::unique_ptr<Engine>> engines_;
  EngineTimes times_;
  std::string why_;
};

}  // namespace gausssim
