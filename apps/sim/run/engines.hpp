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

  /// As scenes call number types; built when it is asked for first. Null: `why()`.
  const Engine* of(const std::string& number) {
    const auto [place, is_new] = engines_.try_emplace(number);
    if (is_new) {
      EngineTimes times;
      place->second = build_engine(prepared_, choice_, {scalar_of(number)}, times, why_);
      times_.compile += times.compile;
      times_.was_cached = times.was_cached;
      times_.why_interpreted = times.why_interpreted;
    }
    return place->second.get();
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
