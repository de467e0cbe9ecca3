#pragma once
// Which regime goes on from an instant (docs/regimes.md).

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/regimes/instant.hpp"
#include "sim/regimes/regime_pool.hpp"
#include "sim/regimes/standing.hpp"
#include "sim/regimes/unpressed.hpp"

namespace gausssim {

template <class S>
struct NextRegime {
  Modes modes;
  Regime<S>* regime = nullptr;
  Numbers<S> x;                 ///< the state in it
  bool has_fresh_slip = false;  ///< in two directions, which has just begun
};

template <class S>
class RegimeChoice {
 public:
  /// What has just come to its end: modes, which are not tried again, and all together.
  struct Ended {
    std::map<std::string, std::string> modes;
    Modes regime;
  };

  RegimeChoice(RegimePool<S>& pool, Regime<S>& ground, const Standing<S>& standing, const Instant<S>& here,
               const Ended& ended);

  /// Nothing, and why.
  std::optional<NextRegime<S>> find(std::string& why);

  /// Of the links that broke in regimes that were tried, the one whose load was the largest part of its strength; empty: none did.
  const std::string& overloaded() const { return overloaded_; }

  /// Why one of the regimes that were tried could not be derived; empty: all could.
  const std::string& underived() const { return underived_; }

 private:
  using Ways = std::vector<std::pair<std::string, std::vector<std::string>>>;
  using Opens = std::set<std::string>;

  std::vector<Opens> choices_of_contacts();
  const std::optional<Unpressed>& unpressed();
  std::optional<Unpressed> find_unpressed() const;
  void tell_unloaded(const NextRegime<S>& next) const;
  Opens banned_contacts() const;
  bool is_allowed(const Opens& opens) const;
  bool is_banned(const std::string& name, const std::string& mode) const;
  bool rests(std::size_t friction) const;
  bool is_held(const std::string& friction, const Modes& modes) const;
  std::vector<std::string> ways_of(std::size_t friction, const Modes& modes) const;
  std::vector<std::size_t> beginning_slips(const Modes& modes) const;
  std::optional<NextRegime<S>> find_with(const Opens& opens, std::string& why);
  std::optional<NextRegime<S>> consistent(const Modes& modes, const Opens& opens, std::string& why);
  bool holds(const NextRegime<S>& next, const Opens& opens, std::string& why);
  bool is_near(const Numbers<S>& x) const;
  bool stays_held(const NextRegime<S>& next, std::string& why) const;

  RegimePool<S>& pool_;
  const Switches& switches_;
  Regime<S>& ground_;
  const Standing<S>& standing_;
  const Instant<S>& here_;
  const Ended& ended_;
  std::vector<std::size_t> touching_;  ///< contacts that may be closed: they touch, and do not part
  std::optional<std::optional<Unpressed>>
      unpressed_;                      ///< once it is asked for; in it nothing: the principle has no answer
  std::vector<std::vector<S>> slips_;  ///< with the contacts closed that are tried
  S free_ = 0;                         ///< the largest acceleration while nothing holds
  std::size_t tried_ = 0;
  std::string overloaded_, underived_;
  S overload_ = 0;
};

}  // namespace gausssim
