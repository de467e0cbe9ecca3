#include "value_check.hpp"

#include <cln/exception.h>
#include <cln/float.h>
#include <fmt/format.h>

#include <utility>

#include "emit/header.hpp"
#include "generic_point.hpp"
#include "ir/substitute.hpp"
#include "ir/traverse.hpp"
#include "model/constant.hpp"
#include "model/expressions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen {

namespace {

using ir::Expr;
using model::Ast;
using model::AstKind;

class ValueCheck {
 public:
  ValueCheck(ModelGraph& mechanics, support::Diagnostics& diagnostics)
      : mechanics_(mechanics), diagnostics_(diagnostics), hold_(held_values(mechanics)) {}

  void run() {
    bool is_good = true;
    model::for_each_expression(mechanics_.model, [&](const Ast& ast, const model::Place&) {
      if (has_value(ast)) return;
      is_good = false;
      report(innermost(ast));
    });
    if (is_good) check_speeds();
  }

  // Each expression has a value, but a derivative of one has none: sqrt(s) with s held at 0.
  void check_equations(const strategy::Vector& accelerations) {
    const model::Model& model = mechanics_.model;
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      if (has_value(accelerations[i.value])) continue;
      diagnostics_.error(
          support::code::k_undefined_value, model.name.span,
          fmt::format("the acceleration of '{}' has no value in any configuration", mechanics_.symbols.speeds[i].label),
          "a derivative has a pole at the values that coordinates are held at");
      return;
    }
  }

 private:
  void check_speeds() {
    const kinematics::Expressions& expressions = mechanics_.expressions;
    if (mechanics_.model.speeds.empty()) return;
    const bool is_found = expressions.has_rates();
    if (is_found &&
        generic_rank(GenericPoint(mechanics_)(expressions.speed_matrix())) == mechanics_.model.speeds.size())
      return;
    diagnostics_.error(
        support::code::k_speeds, mechanics_.model.speeds.front().name.span, "the rates do not follow from the speeds",
        is_found ? "one of them follows from the others; say something else by it"
                 : "speeds are linear in rates, independent of each other, and no more than four rates are "
                   "coupled in their definitions");
  }

  Expr held(const Ast& ast) { return hold_(mechanics_.expressions(ast)); }
  bool has_value(Expr expression) const { return !mechanics_.graph.is_undefined(expression.id()); }
  bool has_value(const Ast& ast) { return has_value(held(ast)); }

  const Ast& innermost(const Ast& ast) {
    for (const Ast& child : ast.children) {
      if (!has_value(child)) return innermost(child);
    }
    return ast;
  }

  void report(const Ast& ast) {
    const bool is_quotient = ast.kind == AstKind::reciprocal;
    const char* const what = is_quotient                  ? "division by what is zero whatever the values"
                             : ast.kind == AstKind::power ? "this power has no real value in any configuration"
                                                          : "this has no real value in any configuration";
    const bool has_held = !mechanics_.symbols.held.values().empty();
    diagnostics_.error(support::code::k_undefined_value, is_quotient ? ast.children[0].span : ast.span, what,
                       has_held ? "check names and signs in it; held coordinates have their values here"
                                : "check names and signs in it");
  }

  ModelGraph& mechanics_;
  support::Diagnostics& diagnostics_;
  ir::Substitution hold_;
};

bool is_in_range(const ir::Node& node) {
  if (node.kind == ir::Kind::power) return true;  // its value is an exponent
  if (!model::is_in_range_of_double(node.value)) return false;
  for (const support::Rational& coefficient : node.coefficients) {
    if (!model::is_in_range_of_double(coefficient)) return false;
  }
  return true;
}

std::vector<ir::NodeId> outputs_of(const emit::Unit& unit) {
  std::vector<ir::NodeId> nodes;
  for (const emit::Artefact& artefact : unit.artefacts) {
    nodes.insert(nodes.end(), artefact.derivative.begin(), artefact.derivative.end());
    nodes.insert(nodes.end(), artefact.state.begin(), artefact.state.end());
    const emit::StatusNodes& status = artefact.status;
    nodes.insert(nodes.end(), {status.singular_mass_matrix, status.dependent_constraints, status.violated_constraints});
    for (const emit::Group& group : artefact.groups) {
      for (const emit::Field& field : group.fields) nodes.insert(nodes.end(), field.values.begin(), field.values.end());
    }
  }
  return nodes;
}

/// What the model or the derivation calls the first thing that `faulty` is part of; empty if nothing has a name.
std::string name_around(const ir::Graph& graph, const std::vector<ir::NodeId>& order, ir::NodeId faulty) {
  ir::NodeSet around;
  around.insert(faulty);
  for (const ir::NodeId id : order) {
    for (const ir::NodeId child : graph[id].children) {
      if (around.contains(child)) around.insert(id);
    }
    if (around.contains(id) && !graph.label(id).empty()) return graph.label(id);
  }
  return "";
}

void refuse_range(const model::Name& model, const std::string& name, support::Diagnostics& diagnostics) {
  diagnostics.error(support::code::k_not_finite, model.span,
                    "the numbers of the model multiply to one that double cannot hold" +
                        (name.empty() ? "" : fmt::format(", in {}", name)),
                    "choose units in which masses, lengths and forces are of moderate size");
}

}  // namespace

ir::Substitution held_values(ModelGraph& mechanics) {
  ir::Substitution hold(mechanics.graph);
  for (const kinematics::HeldCoordinate& held : mechanics.symbols.held) {
    const Expr c = mechanics.expressions(*mechanics.model.coordinates[held.model_index].held_at);
    const Expr c_dot = mechanics.expressions.rate(c);
    hold.replace(held.symbol, c);
    hold.replace(held.rate, c_dot);
    hold.replace(held.acceleration, mechanics.expressions.rate(c_dot));
  }
  return hold;
}

void check_values(ModelGraph& mechanics, support::Diagnostics& diagnostics) {
  ValueCheck(mechanics, diagnostics).run();
}

void check_equations(Mechanics& mechanics, support::Diagnostics& diagnostics) {
  ValueCheck(mechanics, diagnostics).check_equations(mechanics.solution.accelerations);
}

void check_range(const ir::Graph& graph, const emit::Unit& unit, const model::Name& model,
                 support::Diagnostics& diagnostics) {
  check_range(graph, outputs_of(unit), model, diagnostics);
}

void check_range(const ir::Graph& graph, const std::vector<ir::NodeId>& values, const model::Name& model,
                 support::Diagnostics& diagnostics) {
  const std::vector<ir::NodeId> order = ir::post_order(graph, values);
  for (const ir::NodeId id : order) {
    if (!is_in_range(graph[id])) return refuse_range(model, name_around(graph, order, id), diagnostics);
  }
}

emit::Header header_in_range(ir::Graph graph, const emit::Unit& unit, const model::Name& model,
                             support::Diagnostics& diagnostics) {
  try {
    return emit::build_header(std::move(graph), unit);
  } catch (const cln::floating_point_exception&) {
    refuse_range(model, "", diagnostics);
    return {};
  }
}

}  // namespace gaussgen
