#pragma once
// Runs of a scene with any of its effects, each made once.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/effects/moves.hpp"
#include "sim/run/run.hpp"
#include "sim/run/tighter_runs.hpp"

namespace gausssim {

/// What effects cost, and what comes of them.
struct Measured {
  EffectSet acting;
  std::string why;                 ///< there is no motion with them; empty: there is one
  int operations = 0;              ///< of the rates; with contacts, while all are open
  double ns = 0;                   ///< of a call of the rates, at the start
  double seconds = 0;              ///< of the run, the median of some
  long calls = 0;                  ///< of the rates in it
  DeliveredError change;           ///< of the motion, against that of all effects
  std::vector<std::string> lacks;  ///< columns of all effects that are none of these
};

/// With all effects that a scene calls for, and the runs that are compared with it.
class Workbench {
 public:
  explicit Workbench(const RunOptions& options) : options_(options) {}

  /// The run that others are compared with. Otherwise an exit code; why has been said.
  int begin();

  /// Run when it is asked for first.
  const Measured& measured(const EffectSet& acting);

  const std::string& name() const { return name_; }
  const std::string& about() const { return about_; }  ///< of the scene, else of the model
  const std::string& model_file() const { return model_file_; }
  const std::vector<gaussgen::model::Effect>& effects() const { return effects_; }
  const EffectSet& all() const { return all_; }
  /// What the run with all effects is off by, as tighter ones say; nothing where they say nothing, for this reason.
  const std::optional<DeliveredError>& noise() const { return noise_; }
  const std::string& why_no_noise() const { return why_no_noise_.text; }
  const std::string& method() const { return method_; }
  const std::string& engine() const { return engine_; }
  double duration() const { return duration_; }

 private:
  Measured measure(const PreparedModel& prepared, const EffectSet& acting);
  Rows in_columns_of_all(const Rows& rows, const std::vector<Column>& columns, std::vector<std::string>& lacks) const;

  RunOptions options_;
  std::string name_, about_, model_file_, method_, engine_;
  double duration_ = 0;
  std::vector<gaussgen::model::Effect> effects_;
  EffectSet all_;
  std::vector<Column> columns_;
  Yardstick yardstick_;
  Rows rows_{0, 0};  ///< of the run with all effects
  std::optional<DeliveredError> noise_;
  WhyNone why_no_noise_;
  std::map<EffectSet, Measured> known_;
};

}  // namespace gausssim
