#pragma once
// What the emitted route says at one state, in fifty digits, through the artefacts that are emitted.

#include <map>

#include "evaluate/arithmetic_cln.hpp"
#include "evaluation.hpp"
#include "gauss/oracle/bare_models.hpp"

namespace gaussgen::oracle {

class EmittedNumbers {
 public:
  explicit EmittedNumbers(const Case& c, MechanicsOptions options = {});
  explicit EmittedNumbers(Case&& c, MechanicsOptions options = {}) = delete;  // refers to the model

  Mechanics& mechanics() { return mechanics_; }

  Real operator()(ir::NodeId node);
  Vec operator()(const std::vector<ir::NodeId>& nodes);
  Vec operator()(const strategy::Vector& nodes);

  /// Members of the result struct of an emitted function, "group.field" or "field".
  std::map<std::string, Vec> fields(const std::string& function);
  /// What fills a Derivative, or a State.
  Vec derivative(const std::string& function);
  Vec state(const std::string& function);
  /// The conditions of its status that hold, by the names of Status; `ok` is none of them.
  std::vector<std::string> troubles(const std::string& function);

  void bind(ir::SymbolId symbol, const Real& value);
  void bind_accelerations(const Vec& free);
  void bind_configuration(const Vec& q);

 private:
  /// What a function that calls others leaves: the state, and the conditions that held in one of them.
  struct Searched {
    Vec state;
    std::vector<std::string> troubles;
  };
  Searched searched(const emit::Artefact& caller);
  std::vector<ir::SymbolId> state_symbols() const;
  std::vector<std::string> troubles(const emit::StatusNodes& nodes);
  const emit::Artefact& artefact(const std::string& function);

  Mechanics mechanics_;
  evaluate::Evaluator<cln::cl_F> evaluator_;
  std::map<std::string, emit::Artefact> artefacts_;
  std::map<std::uint32_t, cln::cl_F> bound_;
};

/// The larger of deviations by component.
double deviation(const Vec& a, const Vec& b);

}  // namespace gaussgen::oracle
