#include "paper.hpp"

#include "ir/substitute.hpp"
#include "lower/derivation.hpp"
#include "lower/symbol_map.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

/// The route is derived with parameters as symbols; where they are folded, numbers are put in for them.
class ParameterValues {
 public:
  ParameterValues(Mechanics& mechanics, bool fold) : graph_(mechanics.graph), put_in_(mechanics.graph) {
    if (!fold) return;
    for (std::size_t i = 0; i < mechanics.model.parameters.size(); ++i) {
      put_in_.replace(mechanics.symbols.parameters[i], mechanics.expressions(mechanics.model.parameters[i].value));
    }
  }

  strategy::Vector operator()(const std::vector<ir::NodeId>& nodes) {
    strategy::Vector result;
    for (const ir::NodeId node : nodes) result.push_back(put_in_(ir::Expr(graph_, node)));
    return result;
  }

 private:
  ir::Graph& graph_;
  ir::Substitution put_in_;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void report_obstacle(const model::Model& model, const std::string& obstacle, support::Diagnostics& diagnostics) {
  diagnostics.error(support::code::k_no_paper_route, model.name.span,
                    "the paper's route does not take this model: " + obstacle,
                    "the emitted route does: leave --route=paper away");
}

}  // namespace

lower::PaperRoute paper_route(Mechanics& mechanics) {
  return lower::build_paper_route(mechanics.model, mechanics.graph, lower::symbols_of(mechanics.graph));
}

std::string derivation_text(const model::Model& model, bool latex, support::Diagnostics& diagnostics) {
  const lower::Derivation derivation = lower::derive(model);
  if (!derivation.obstacle.empty()) {
    report_obstacle(model, derivation.obstacle, diagnostics);
    return "";
  }
  return latex ? lower::as_latex(derivation) : lower::as_markdown(derivation);
}

std::string dump_paper(const model::Model& model) {
  const lower::Derivation derivation = lower::derive(model);
  return derivation.obstacle.empty() ? lower::as_plain_text(derivation)
                                     : "no paper's route: " + derivation.obstacle + "\n";
}

bool take_paper_route(Mechanics& mechanics, bool fold, support::Diagnostics& diagnostics) {
  const lower::PaperRoute route = paper_route(mechanics);
  if (!route.obstacle.empty()) {
    report_obstacle(mechanics.model, route.obstacle, diagnostics);
    return false;
  }
  ParameterValues with_values(mechanics, fold);
  mechanics.solution.accelerations = with_values(route.accelerations);
  mechanics.solution.multipliers = with_values(route.lambda);
  mechanics.held_reactions = with_values(route.R_x);
  mechanics.solution.description =
      "the paper's route: Z with Christoffel symbols of G, " +
      (route.dependent.empty() ? std::string("stationarity (1.15)")
                               : "elimination (3.6)-(3.8) with dependent speeds " + joined(route.dependent)) +
      "; inverses by factorisation";
  return true;
}

}  // namespace gaussgen
