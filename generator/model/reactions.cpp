// `floor.reaction` in the formulas of forces and quantities.

#include <fmt/format.h>

#include <algorithm>

#include "model/checks.hpp"
#include "model/expressions.hpp"
#include "model/regime.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

constexpr std::string_view k_component = ".reaction";

/// Empty: the name is none of a reaction.
std::string owner_in(const std::string& name) {
  const std::size_t size = name.size() - std::min(name.size(), k_component.size());
  return name.substr(size) == k_component ? name.substr(0, size) : "";
}

/// Of what may be a constraint, and is none in this regime.
bool is_absent(const std::string& owner, const Model& model) {
  const bool is_broken = std::any_of(model.broken.begin(), model.broken.end(),
                                     [&](const Constraint& row) { return row.name.text == owner; });
  return is_broken || is_reaction_of_open_contact(owner + std::string(k_component), model);
}

std::optional<NamedReaction> reaction_of(const std::string& owner, const Model& model) {
  const auto is_called = [&](const auto& entry) { return entry.name.text == owner; };
  const auto held = std::find_if(model.coordinates.begin(), model.coordinates.end(), is_called);
  if (held != model.coordinates.end() && held->held_at) return NamedReaction{owner, true};
  const bool is_row = std::any_of(model.constraints.begin(), model.constraints.end(), is_called);
  if (is_row) return NamedReaction{owner, false};
  if (is_absent(owner, model)) {
    NamedReaction none{owner, false};
    none.is_absent = true;
    return none;
  }
  return std::nullopt;
}

class Declaring {
 public:
  explicit Declaring(Model& model) : model_(model) {}

  void in(const Ast& ast, const Place& place) {
    for (const Ast& child : ast.children) in(child, place);
    const std::string owner = ast.kind == AstKind::symbol ? owner_in(ast.name) : "";
    if (owner.empty()) return;
    auto& all = model_.reactions;
    auto known = std::find_if(all.begin(), all.end(), [&](const NamedReaction& one) { return one.of == owner; });
    if (known == all.end()) {
      const std::optional<NamedReaction> found = reaction_of(owner, model_);
      if (!found) return;  // an unknown name, which is reported later
      known = all.insert(known, *found);
      model_.symbols[ast.name] = {SymbolKind::reaction, all.size() - 1};
    }
    known->is_in_force = known->is_in_force || (place.reactions == Reactions::linear && !known->is_absent);
    known->is_of_user = known->is_of_user || place.reactions != Reactions::guards;
  }

 private:
  Model& model_;
};

constexpr int k_not_linear = 2;

/// 0: no reaction is in it, 1: linearly, 2: otherwise.
int degree(const Ast& ast, const Model& model) {
  if (ast.kind == AstKind::symbol) {
    const auto symbol = model.symbols.find(ast.name);
    return symbol != model.symbols.end() && symbol->second.kind == SymbolKind::reaction ? 1 : 0;
  }
  int most = 0;
  int sum = 0;
  bool is_condition_free = true;
  for (const Ast& child : ast.children) {
    const int one = degree(child, model);
    is_condition_free = is_condition_free && (child.kind != AstKind::comparison || one == 0);
    most = std::max(most, one);
    sum += one;
  }
  switch (ast.kind) {
    case AstKind::negate:
    case AstKind::sum: return most;
    case AstKind::product: return std::min(sum, k_not_linear);
    case AstKind::power:
      return ast.children[1].kind == AstKind::number && ast.children[1].number == 1 ? most
             : most == 0                                                            ? 0
                                                                                    : k_not_linear;
    case AstKind::call:
      if (ast.name == "piecewise" && is_condition_free) return most;
      return most == 0 ? 0 : k_not_linear;
    default: return most == 0 ? 0 : k_not_linear;
  }
}

}  // namespace

void declare_reactions(Reading& reading) {
  Declaring declaring(reading.model);
  for_each_expression(reading.model, [&](const Ast& ast, const Place& place) { declaring.in(ast, place); });
}

void check_reactions(Reading& reading) {
  for_each_expression(reading.model, [&](const Ast& ast, const Place& place) {
    if (place.reactions != Reactions::linear || degree(ast, reading.model) < k_not_linear) return;
    reading.diagnostics.error(
        support::code::k_not_linear, ast.span, fmt::format("{} is not linear in reactions", place.name),
        "reactions and forces are found together, from linear equations: write a factor times the reaction, "
        "and let conditions and functions contain other things");
  });
}

}  // namespace gaussgen::model
