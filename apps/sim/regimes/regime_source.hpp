#pragma once
// Models of regimes, derived when a motion first comes to them.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "pipeline.hpp"
#include "sim/engine/binding.hpp"
#include "sim/engine/engine.hpp"
#include "sim/output/columns.hpp"
#include "sim/regimes/switches.hpp"
#include "support/source.hpp"

namespace gausssim {

/// One regime, for any number type.
struct RegimeModel {
  Described model;
  std::vector<GuardOf> guards;
  std::vector<char> fixed_reactions;  ///< of constraints, which forces contain
  Columns columns;                    ///< of those that are wanted, what this regime has
  std::vector<std::size_t> in_row;    ///< their places in a row of the run
  std::unique_ptr<const Engine> engine;
};

/// What a model is derived and executed with, apart from its regime. Shared by runs, which may be on several threads.
class RegimeSource {
 public:
  using MakeEngine = std::function<std::unique_ptr<const Engine>(const Described&, const Columns&)>;

  RegimeSource(gaussgen::support::Source text, gaussgen::PipelineOptions options,
               std::function<void(gaussgen::model::Model&)> adjust, Switches switches);
  ~RegimeSource();

  const Switches& switches() const { return switches_; }

  /// Columns of the runs, and how functions are executed: once, before the first regime. What `while_making` returns lives as long as one is made.
  void prepare(std::vector<Column> columns, MakeEngine make, std::function<std::shared_ptr<void>()> while_making);

  /// Null, and why: a regime that cannot be derived, as one in which constraints contradict each other.
  std::shared_ptr<const RegimeModel> at(const Modes& modes, std::string& why);

  /// Without an engine: what can be asked for of a regime. Nothing where it cannot be derived.
  std::optional<Described> described(const Modes& modes);

  /// Derived so far.
  std::size_t count() const;

 private:
  bool slides_in_two_directions(const Modes& modes) const;

  struct Known;
  std::unique_ptr<Known> known_;
  gaussgen::support::Source text_;
  gaussgen::PipelineOptions options_;
  std::function<void(gaussgen::model::Model&)> adjust_;
  Switches switches_;
  std::vector<Column> columns_;
  MakeEngine make_engine_;
  std::function<std::shared_ptr<void>()> while_making_;
};

}  // namespace gausssim
