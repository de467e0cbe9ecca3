#include "sensitivities.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

namespace {

/// Names on the command line stand nowhere in the file: the model itself is meant.
void check(const std::string& name, const model::Model& model, support::Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const model::Parameter& parameter : model.parameters) known.push_back(parameter.name.text);
  const auto found = std::find(known.begin(), known.end(), name);
  const auto report = [&](const std::string& message, const std::string& hint) {
    diagnostics.error(support::code::k_wrong_reference, model.name.span, "--sensitivities: " + message, hint);
  };
  if (found == known.end()) {
    const std::string near = support::did_you_mean(name, known);
    report(fmt::format("there is no parameter '{}'", name), near.empty() ? "name parameters of the model" : near);
  } else if (model.parameters[static_cast<std::size_t>(found - known.begin())].is_formula) {
    report(fmt::format("'{}' follows from other parameters by its formula", name),
           "name those: what follows from them counts");
  }
}

}  // namespace

void choose_sensitivities(const std::vector<std::string>& names, model::Model& model,
                          support::Diagnostics& diagnostics) {
  model.sensitivities.clear();
  for (const std::string& name : names) {
    check(name, model, diagnostics);
    model.sensitivities.push_back({name, model.name.span});
  }
}

}  // namespace gaussgen
