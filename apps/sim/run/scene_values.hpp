#pragma once
// The values that scenes give to models.

#include "cli/overrides.hpp"
#include "model/model.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Of one kind, as the model calls them.
std::vector<std::string> names_of(const gaussgen::model::Model& in, gaussgen::model::SymbolKind kind);

/// A hint: where a scene gives a value to what is no parameter, or no input.
std::string place_of(const gaussgen::model::Model& in, const std::string& name,
                     const gaussgen::model::SymbolRef& symbol);

/// A hint: the name that was meant, or all of them where they are few.
std::string near_or_all(const std::string& name, const std::vector<std::string>& names);

/// Gives a model other values; what is wrong with them is reported at its place in the scene. What is wrong leaves the model as it is.
class ModelValues {
 public:
  ModelValues(gaussgen::model::Model& model, gaussgen::support::Diagnostics& diagnostics)
      : model_(model), diagnostics_(diagnostics) {}

  /// Names as `--set` has them; the hint is for one that may not be, if it needs one.
  void give(const Given& given, const std::string& hint = "");

  /// False for parameters and inputs, which is reported.
  bool may_have_initial(const std::string& name, gaussgen::support::Span span);

  /// Every value must be one with the parameters as they are now.
  void check();

  void error(gaussgen::support::Span span, const std::string& message, const std::string& hint = "");

 private:
  gaussgen::model::Model& model_;
  gaussgen::support::Diagnostics& diagnostics_;
  gaussgen::cli::Overrides overrides_{model_};
  std::vector<Given> given_;
};

/// Parameters, inputs and initial values of the scene.
void give_values(const Scene& scene, gaussgen::model::Model& to, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
