// speeds: quasi-velocities, which stand in the state instead of the rates that they are made of.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/constant.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/functions.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;

namespace {

/// Whether every name in it has its meaning; the others are reported.
bool is_understood(const Ast& ast, const Reading& reading) {
  if (ast.kind == AstKind::symbol)
    return reading.model.symbols.count(ast.name) > 0 && reading.refused.count(ast.name) == 0;
  return std::all_of(ast.children.begin(), ast.children.end(),
                     [&](const Ast& child) { return is_understood(child, reading); });
}

/// Free coordinates whose rates are in the expression.
void collect_rates(const Ast& ast, bool inside_dot, const Model& model, std::set<std::size_t>& coordinates) {
  if (ast.kind == AstKind::symbol && inside_dot) {
    const auto symbol = model.symbols.find(ast.name);
    const bool is_coordinate = symbol != model.symbols.end() && symbol->second.kind == SymbolKind::coordinate;
    if (is_coordinate && !model.coordinates[symbol->second.index].held_at) coordinates.insert(symbol->second.index);
  }
  const bool inside = inside_dot || (ast.kind == AstKind::call && ast.name == k_dot);
  for (const Ast& child : ast.children) collect_rates(child, inside, model, coordinates);
}

/// Whether a rate is in it for certain: what a place moves with is found out later.
bool has_rate(const Ast& ast, bool inside_dot, const Model& model) {
  if (ast.kind == AstKind::symbol) {
    const auto found = model.symbols.find(ast.name);
    if (found == model.symbols.end()) return false;
    const SymbolRef symbol = found->second;
    const bool is_free = symbol.kind == SymbolKind::quaternion_component ||
                         (symbol.kind == SymbolKind::coordinate && !model.coordinates[symbol.index].held_at);
    return symbol.kind == SymbolKind::angular_velocity || (inside_dot && is_free);
  }
  const bool inside = inside_dot || (ast.kind == AstKind::call && ast.name == k_dot);
  return std::any_of(ast.children.begin(), ast.children.end(),
                     [&](const Ast& child) { return has_rate(child, inside, model); });
}

bool is_one(const Ast& exponent) {
  const auto value = exact_value(exponent);
  return value && *value == 1;
}

/// The part of an expression that is not linear in rates: a product of two of them, a power, a function; or null.
const Ast* nonlinear_part(const Ast& ast, const Model& model) {
  const auto is_rate = [&](const Ast& part) { return has_rate(part, false, model); };
  const auto rates = std::count_if(ast.children.begin(), ast.children.end(), is_rate);
  const bool is_dot = ast.kind == AstKind::call && ast.name == k_dot;
  if (rates == 0 || is_dot) return nullptr;
  const bool is_linear_power = ast.kind == AstKind::power && is_one(ast.children[1]);
  const bool is_whole = ast.kind == AstKind::call || ast.kind == AstKind::reciprocal ||
                        (ast.kind == AstKind::power && !is_linear_power) || (ast.kind == AstKind::product && rates > 1);
  if (is_whole) return &ast;
  for (const Ast& child : ast.children) {
    if (const Ast* part = nonlinear_part(child, model)) return part;
  }
  return nullptr;
}

/// Initial values of a speed, until it has its place in the state.
struct Start {
  std::optional<Ast> initial;
  std::optional<Ast> guess;
};

class SpeedReader {
 public:
  explicit SpeedReader(Reading& reading) : reading_(reading), model_(reading.model) {}

  void read(const Entry& entry) {
    const std::string where = fmt::format("speed '{}'", entry.key.text);
    Speed speed;
    speed.name = name_of(entry.key);
    Start start;
    speed.is = broken_expression();
    if (expect_map(entry.value, entry.key.span, where, reading_)) {
      check_keys(entry.value, where, format::keys_of(format::speed()), reading_);
      if (const spec::Node* is = required(entry.value, "is", entry.key.span, where, reading_))
        speed.is = read_expression(*is, entry.key.span, reading_);
      read_unit(entry.value, speed, reading_);
      speed.about = text_field(entry.value, "about", reading_);
      start = read_start(entry.value);
    }
    declare(speed.name, SymbolKind::speed, model_.speeds.size(), "the speed", reading_);
    model_.speeds.push_back(std::move(speed));
    starts_.push_back(std::move(start));
  }

  /// Each takes the place of one of the rates that they are made of, in the order of both.
  void place() {
    std::set<std::size_t> coordinates;
    bool are_understood = !reading_.unread.any();
    for (const Speed& speed : model_.speeds) {
      const bool is_known = is_understood(speed.is, reading_);
      are_understood = are_understood && is_known;
      std::set<std::size_t> own;
      collect_rates(speed.is, false, model_, own);
      if (own.empty() && is_known && !reading_.unread.any()) refuse_without_rates(speed);
      if (is_known) check_linear(speed);
      coordinates.insert(own.begin(), own.end());
    }
    if (!are_understood || has_speed_without_rates_) return;
    if (coordinates.size() != model_.speeds.size()) return refuse_count(coordinates);
    std::size_t index = 0;
    for (const std::size_t i : coordinates) {
      Coordinate& coordinate = model_.coordinates[i];
      if (coordinate.initial_rate || coordinate.rate_guess) refuse_rate(coordinate);
      coordinate.speed = index;
      coordinate.initial_rate = std::move(starts_[index].initial);
      coordinate.rate_guess = std::move(starts_[index].guess);
      ++index;
    }
  }

 private:
  Start read_start(const spec::Node& map) {
    Start start{expression_field(map, "initial", reading_), expression_field(map, "initial_guess", reading_)};
    if (start.initial && start.guess) {
      reading_.diagnostics.error(code::k_conflicting_keys, map.entries.back().key.span,
                                 "'initial_guess' beside 'initial', which determines the value",
                                 "remove one of the two keys");
    }
    return start;
  }

  void refuse_without_rates(const Speed& speed) {
    has_speed_without_rates_ = true;
    reading_.diagnostics.error(code::k_speeds, speed.name.span,
                               fmt::format("no rate of a free coordinate is in the speed '{}'", speed.name.text),
                               "write rates as dot(x), as in 'is: dot(x)*cos(psi) + dot(y)*sin(psi)'");
  }

  void check_linear(const Speed& speed) {
    const Ast* part = nonlinear_part(speed.is, model_);
    if (part == nullptr) return;
    reading_.diagnostics.error(
        code::k_speeds, part->span, fmt::format("the speed '{}' is not linear in the rates", speed.name.text),
        "a speed is a sum of rates, each times what depends on coordinates and time alone, as in "
        "'dot(x)*cos(psi) + dot(y)*sin(psi)'");
  }

  void refuse_count(const std::set<std::size_t>& coordinates) {
    std::vector<std::string> rates;
    for (const std::size_t i : coordinates) rates.push_back("dot(" + model_.coordinates[i].name.text + ")");
    const bool lacks = coordinates.size() > model_.speeds.size();
    reading_.diagnostics.error(
        code::k_speeds, model_.speeds.front().name.span,
        fmt::format("the number of speeds is {}, and that of the rates in them {}: {}", model_.speeds.size(),
                    rates.size(), support::joined(rates)),
        lacks ? fmt::format("the rates have to follow from the speeds: add one, as in '{}_rate: {{is: {}}}'",
                            model_.coordinates[*coordinates.rbegin()].name.text, rates.back())
              : "remove speeds that follow from the others");
  }

  void refuse_rate(const Coordinate& coordinate) {
    const Ast& value = coordinate.initial_rate ? *coordinate.initial_rate : *coordinate.rate_guess;
    reading_.diagnostics.error(
        code::k_conflicting_keys, value.span,
        fmt::format("the rate of '{}' follows from the speeds, and has an initial value here", coordinate.name.text),
        "give the speeds their initial values instead");
  }

  Reading& reading_;
  Model& model_;
  std::vector<Start> starts_;
  bool has_speed_without_rates_ = false;
};

}  // namespace

void read_speeds(const spec::Node& root, Reading& reading) {
  SpeedReader reader(reading);
  read_section(root, "speeds", reading, [&](const Entry& entry) { reader.read(entry); });
  if (!reading.model.speeds.empty()) reader.place();
}

}  // namespace gaussgen::model
