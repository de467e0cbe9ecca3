#include "model/regime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/ast_build.hpp"
#include "model/checks.hpp"

namespace gaussgen::model {

namespace {

constexpr std::pair<Mode, const char*> k_names[] = {
    {Mode::open, "open"},     {Mode::closed, "closed"},     {Mode::sticks, "sticks"},
    {Mode::slides, "slides"}, {Mode::forwards, "forwards"}, {Mode::backwards, "backwards"},
    {Mode::free, "free"},     {Mode::holds, "holds"},       {Mode::broken, "broken"}};

/// Only such terms are in it that contain the reaction of an open contact.
bool vanishes(const Ast& ast, const Model& model) {
  const auto is_nothing = [&](const Ast& child) { return vanishes(child, model); };
  switch (ast.kind) {
    case AstKind::symbol: return is_reaction_of_open_contact(ast.name, model);
    case AstKind::product: return std::any_of(ast.children.begin(), ast.children.end(), is_nothing);
    case AstKind::negate:
    case AstKind::sum: return std::all_of(ast.children.begin(), ast.children.end(), is_nothing);
    default: return false;
  }
}

/// Whatever the motion is: parameters and reactions of contacts are not negative where they are checked (E046), or while these press.
bool is_never_negative(const Ast& ast, const Model& model) {
  const auto is_so = [&](const Ast& child) { return is_never_negative(child, model); };
  switch (ast.kind) {
    case AstKind::number: return ast.number >= 0;
    case AstKind::symbol: {
      const auto known = model.symbols.find(ast.name);
      if (known != model.symbols.end() && known->second.kind == SymbolKind::parameter) return true;
      return ast.name == "pi" || std::any_of(model.contacts.begin(), model.contacts.end(), [&](const Contact& contact) {
               return ast.name == contact.name.text + ".reaction";
             });
    }
    case AstKind::sum:
    case AstKind::product:
    case AstKind::reciprocal: return std::all_of(ast.children.begin(), ast.children.end(), is_so);
    case AstKind::power: return is_so(ast.children.front());
    case AstKind::call:
      return ast.name == "exp" || ast.name == "abs" || ast.name == "sqrt" ||
             (ast.name == "max" && std::any_of(ast.children.begin(), ast.children.end(), is_so));
    default: return false;
  }
}

/// limit² - Σ r²
Ast margin_of(const Ast& limit, const std::vector<Name>& rows) {
  std::vector<Ast> terms{square_of(limit)};
  for (const Name& row : rows) terms.push_back(negative_of(square_of(symbol_of(row.text + ".reaction", row.span))));
  return node_of(AstKind::sum, limit.span, std::move(terms));
}

class Guards {
 public:
  explicit Guards(Reading& reading) : model_(reading.model) {}

  void run() {
    for (const Contact& contact : model_.contacts) of(contact);
    for (const DryFriction& friction : model_.frictions) of(friction);
    for (const Constraint& row : model_.constraints) of(row);
  }

 private:
  Guard& add(const Name& of, const std::string& what, Guard::Kind kind, Ast value) {
    return model_.guards.emplace_back(Guard{of.text + "_" + what, of, kind, std::move(value)});
  }

  void add_limited(const Name& of, const std::string& what, const Ast& limit, std::vector<Name> rows) {
    Guard& guard = add(of, what, Guard::Kind::falls, margin_of(limit, rows));
    guard.rows = std::move(rows);
    guard.limit = limit;
  }

  void of(const Contact& contact) {
    if (contact.mode == Mode::closed) {
      add(contact.name, "opens", Guard::Kind::falls, symbol_of(contact.name.text + ".reaction", contact.name.span))
          .rows = {contact.name};
      return;
    }
    add(contact.name, "closes", Guard::Kind::falls, contact.gap);
    add(contact.name, "gap_rate", Guard::Kind::rate_of_gap, call_of("dot", contact.gap));
  }

  void of(const DryFriction& friction) {
    if (friction.is_idle) return;
    const bool has_own = friction.mode == Mode::sticks && friction.static_limit;
    const Ast& limit = has_own ? *friction.static_limit : friction.law.limit;
    if (!is_never_negative(limit, model_)) add(friction.name, "limit", Guard::Kind::falls, limit);
    if (friction.mode == Mode::sticks) return add_limited(friction.name, "slides", limit, friction.rows);
    for (std::size_t i = 0; i < friction.law.slips.size(); ++i) {
      const std::string slip = fmt::format("slip{}", i + 1);
      add(friction.name, slip, Guard::Kind::slip, symbol_of(friction.name.text + "." + slip, friction.name.span));
    }
  }

  /// Once for all rows of a constraint.
  void of(const Constraint& row) {
    const std::string name = name_in_file(row);
    if (!row.breaks_at || std::any_of(model_.guards.begin(), model_.guards.end(),
                                      [&](const Guard& guard) { return guard.name == name + "_breaks"; }))
      return;
    std::vector<Name> rows;
    for (const Constraint& other : model_.constraints) {
      if (name_in_file(other) == name) rows.push_back(other.name);
    }
    add_limited({name, row.name.span}, "breaks", *row.breaks_at, std::move(rows));
  }

  Model& model_;
};

}  // namespace

std::string name_of(Mode mode) {
  for (const auto& [known, name] : k_names) {
    if (known == mode) return name;
  }
  return "";
}

Mode mode_of(const std::string& name, const std::vector<Mode>& modes, Reading& reading) {
  reading.switches.insert(name);
  const auto chosen = reading.choices.regime.find(name);
  if (chosen == reading.choices.regime.end()) return modes.front();
  for (const Mode mode : modes) {
    if (name_of(mode) == chosen->second) return mode;
  }
  std::vector<std::string> known;
  for (const Mode mode : modes) known.push_back(name_of(mode));
  throw WrongRegime(fmt::format("'{}' is never '{}': it is one of {}", name, chosen->second, fmt::join(known, ", ")));
}

void check_regime(const Reading& reading) {
  for (const auto& [name, mode] : reading.choices.regime) {
    if (reading.switches.count(name) > 0 || reading.unread.may_declare(name)) continue;
    throw WrongRegime(
        reading.switches.empty()
            ? fmt::format("'{}' is nothing that changes its mode: the model has no contacts, dry friction or "
                          "links that break",
                          name)
            : fmt::format("'{}' is nothing that changes its mode; there are {}", name,
                          fmt::join(reading.switches, ", ")));
  }
}

bool is_reaction_of_open_contact(const std::string& symbol, const Model& model) {
  return std::any_of(model.contacts.begin(), model.contacts.end(), [&](const Contact& contact) {
    return contact.mode == Mode::open && symbol == contact.name.text + ".reaction";
  });
}

void take_friction(DryFriction friction, Force force, Reading& reading) {
  Model& model = reading.model;
  const std::size_t count = friction.law.slips.size();
  std::vector<Mode> modes{Mode::sticks, Mode::slides, Mode::free};
  if (count == 1) modes = {Mode::sticks, Mode::forwards, Mode::backwards, Mode::free};
  if (reading.choices.is_ground) std::rotate(modes.begin(), modes.end() - 1, modes.end());
  friction.mode = mode_of(friction.name.text, modes, reading);
  friction.is_idle = friction.mode == Mode::free || vanishes(friction.law.limit, model);
  for (std::size_t i = 0; i < count; ++i) {
    model.symbols[fmt::format("{}.slip{}", friction.name.text, i + 1)] = {SymbolKind::slip,
                                                                          2 * model.frictions.size() + i};
    if (friction.mode != Mode::sticks || friction.is_idle) continue;
    Constraint row;
    row.name = {friction.name.text + (count == 1 ? "" : fmt::format("_{}", i + 1)), friction.name.span};
    row.about = friction.about;
    row.span = friction.name.span;
    std::visit([&](const auto& law) { row.law = law; }, friction.law.slips[i]);
    row.may_vanish = count > 1;
    friction.rows.push_back(row.name);
    model.constraints.push_back(std::move(row));
  }
  if (friction.mode != Mode::sticks && !friction.is_idle) {
    friction.law.sense = friction.mode == Mode::backwards ? -1 : 1;
    force.law = friction.law;
    model.forces.push_back(std::move(force));
  }
  model.frictions.push_back(std::move(friction));
}

void make_guards(Reading& reading) { Guards(reading).run(); }

}  // namespace gaussgen::model
