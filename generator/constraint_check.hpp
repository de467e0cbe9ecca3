#pragma once
// What is said of constraints that follow from each other, or contradict each other, at the initial state.

#include <optional>
#include <set>

#include "dependence.hpp"
#include "support/diagnostics.hpp"
#include "violation.hpp"

namespace gaussgen {

class ConstraintCheck {
 public:
  /// At the state that is bound in `values`. A contradiction is an error if code starts there.
  ConstraintCheck(Mechanics& mechanics, ModelValues& values, bool is_emitted, support::Diagnostics& diagnostics);

  /// Equations of positions that nothing near satisfies, if there are violated ones among `violated`.
  void report_positions(const std::vector<Violation>& violated);

  /// Of this one everything is said.
  void pass_over(std::size_t constraint) { passed_over_.insert(constraint); }

  /// Velocities or accelerations that nothing satisfies.
  void report_contradictions();

  /// Constraints that follow from others and agree with them.
  void report_redundant();

  /// Whether a contradiction with the constraint in it is reported; its own violation says nothing more.
  bool is_contradictory(std::size_t constraint) const { return contradictory_.count(constraint) > 0; }

  bool has_dependent() const { return !dependences_.empty(); }

  /// Whether accelerations follow from inertia and those constraints that do not follow from others, also where neither determines them alone.
  bool has_general_solution() const;

  /// Whether they agree, and neither they nor inertia determine some acceleration: the rows that are left say too little.
  bool leave_undetermined() const;

 private:
  /// Rows of one entry of the model.
  struct Redundancy {
    std::vector<std::size_t> rows;
    std::set<std::size_t> others;
    bool everywhere = false;
    bool by_another = false;
    bool is_exact = true;
    std::optional<bool> agrees_elsewhere;
  };

  /// No state is known at which they hold together.
  bool is_agreement_unknown(const Redundancy& found) const;

  /// Rows that do not follow from others here.
  std::vector<std::size_t> independent() const;

  void report(const std::vector<std::size_t>& constraints, const std::string& message, const std::string& hint);
  void report_redundant(const Redundancy& found);

  Mechanics& mechanics_;
  ModelValues& values_;
  bool is_emitted_;
  support::Diagnostics& diagnostics_;
  std::vector<Dependence> dependences_;
  std::set<std::size_t> violated_;  ///< at the initial state
  std::set<std::size_t> contradictory_;
  std::set<std::size_t> passed_over_;
  mutable std::optional<bool> is_undetermined_;  ///< once somebody asks
};

}  // namespace gaussgen
