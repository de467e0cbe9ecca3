#include "paper.hpp"

#include <stdexcept>

#include "early_check.hpp"
#include "generic_point.hpp"
#include "ir/substitute.hpp"
#include "lower/derivation.hpp"
#include "lower/symbol_map.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

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

/// 'x', 'y' and 's'
std::string quoted(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "'" : i + 1 == names.size() ? " and '" : ", '") + names[i] + "'";
  }
  return text;
}

/// Why the paper's route does not take a model that the emitted one takes.
struct Obstacle {
  std::string what;
  support::Span span;
  std::string remedy = {};  ///< empty where there is none but the other route
};

std::optional<Obstacle> obstacle_in_metric(Mechanics& mechanics) {
  strategy::Matrix G;
  for (const auto& row : mechanics.covariant->G) G.push_back(row.values());
  std::vector<std::string> names;
  for (const std::size_t A : dependent_columns(GenericPoint(mechanics)(G))) {
    names.push_back(mechanics.symbols.label(kinematics::FullIndex{A}));
  }
  if (names.empty()) return std::nullopt;
  const std::string idle = names.size() == 1
                               ? "no body moves with " + quoted(names)
                               : "no body moves when " + quoted(names) + " change together in a certain way";
  return Obstacle{"the metric G of all coordinates, held ones too, has no inverse: " + idle,
                  span_of_speed(mechanics.model, names.front()),
                  "every coordinate, held ones included, needs a mass that moves with it"};
}

std::optional<Obstacle> obstacle_in_constraints(Mechanics& mechanics) {
  if (mechanics.dynamics.l() == 0) return std::nullopt;
  const auto dependent = dependent_columns(evaluate::transposed(GenericPoint(mechanics)(mechanics.dynamics.b)));
  if (dependent.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t mu : dependent) names.push_back(mechanics.dynamics.constraints[mu]);
  return Obstacle{"the constraints " + quoted(names) +
                      " depend on each other, so that no choice of dependent speeds has an inverse b",
                  mechanics.model.constraints[dependent.back()].name.span,
                  "remove constraints that follow from others"};
}

/// What would divide by zero in GiNaC, found before it is tried.
std::optional<Obstacle> obstacle_in(Mechanics& mechanics) {
  const std::string size = lower::paper_route_obstacle(mechanics.model);
  if (!size.empty()) return Obstacle{size, mechanics.model.name.span};
  if (auto found = obstacle_in_metric(mechanics)) return found;
  return obstacle_in_constraints(mechanics);
}

/// What obstacle_in cannot see, since nothing has a value near the start (sinh of 1e200): GiNaC divides by zero there.
template <class Make>
auto derived(Make make) -> decltype(make()) {
  try {
    return make();
  } catch (const std::domain_error&) {
    decltype(make()) result;
    result.obstacle = "the metric G or the block b of the constraints has no inverse";
    return result;
  }
}

/// What only the derivation itself can find.
Obstacle at_start(const model::Model& model, const std::string& what) {
  return {what, model.constraints.empty() ? model.name.span : model.constraints.front().name.span};
}

void report_obstacle(const Obstacle& obstacle, support::Diagnostics& diagnostics) {
  diagnostics.error(support::code::k_no_paper_route, obstacle.span,
                    "the paper's route does not take this model: " + obstacle.what,
                    (obstacle.remedy.empty() ? "" : obstacle.remedy + "; or ") +
                        "take the emitted route: gauss-gen without 'derivation' and without --route=paper");
}

/// With the rates that speeds of the model's own replace: the paper's route is written in rates.
lower::SymbolMap symbols_with_rates(const Mechanics& mechanics) {
  lower::SymbolMap symbols = lower::symbols_of(mechanics.graph);
  kinematics::ConfigurationIndex next{0};
  for (const model::Coordinate& coordinate : mechanics.model.coordinates) {
    if (coordinate.held_at) continue;
    if (coordinate.speed) {
      const ir::Expr rate = mechanics.kinematics.configuration_rates[next];
      symbols.values.emplace(coordinate.name.text + "_dot", rate.id());
    }
    ++next.value;
  }
  return symbols;
}

}  // namespace

lower::PaperRoute paper_route(Mechanics& mechanics) {
  VanishesEverywhere vanishes(mechanics);
  return lower::build_paper_route(mechanics.model, mechanics.graph, symbols_with_rates(mechanics),
                                  [&](ir::Expr expression) { return vanishes(expression); });
}

std::string derivation_text(const model::Model& model, bool latex, support::Diagnostics& diagnostics) {
  check_early(model, {}, diagnostics);
  if (diagnostics.has_errors()) return "";
  Mechanics mechanics(model, {});
  check_structure(mechanics, diagnostics);
  if (diagnostics.has_errors()) return "";
  report_redundant(mechanics, diagnostics);
  if (const auto obstacle = obstacle_in(mechanics)) {
    report_obstacle(*obstacle, diagnostics);
    return "";
  }
  const lower::Derivation derivation = derived([&] { return lower::derive(model); });
  if (!derivation.obstacle.empty()) {
    report_obstacle(at_start(model, derivation.obstacle), diagnostics);
    return "";
  }
  return latex ? lower::as_latex(derivation) : lower::as_markdown(derivation);
}

std::string dump_paper(Mechanics& mechanics) {
  if (const auto obstacle = obstacle_in(mechanics)) return "no paper's route: " + obstacle->what + "\n";
  const lower::Derivation derivation = derived([&] { return lower::derive(mechanics.model); });
  return derivation.obstacle.empty() ? lower::as_plain_text(derivation)
                                     : "no paper's route: " + derivation.obstacle + "\n";
}

bool take_paper_route(Mechanics& mechanics, bool fold, support::Diagnostics& diagnostics) {
  if (const auto obstacle = obstacle_in(mechanics)) {
    report_obstacle(*obstacle, diagnostics);
    return false;
  }
  const lower::PaperRoute route = derived([&] { return paper_route(mechanics); });
  if (!route.obstacle.empty()) {
    report_obstacle(at_start(mechanics.model, route.obstacle), diagnostics);
    return false;
  }
  ParameterValues with_values(mechanics, fold);
  mechanics.solution.accelerations = with_values(route.accelerations);
  mechanics.solution.multipliers = with_values(route.lambda);
  mechanics.solution.motion.reset();
  mechanics.held_reactions = with_values(route.R_x);
  mechanics.solution.description =
      "the paper's route: Z with Christoffel symbols of G, " +
      (route.dependent.empty() ? std::string("stationarity (1.15)")
                               : "elimination (3.6)-(3.8) with dependent speeds " + support::joined(route.dependent)) +
      "; inverses by factorisation";
  return true;
}

}  // namespace gaussgen
