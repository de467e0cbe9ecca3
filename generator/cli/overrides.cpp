#include "cli/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "cli/assignments.hpp"
#include "model/constant.hpp"
#include "model/constant_check.hpp"
#include "model/evaluate.hpp"
#include "model/parser.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

model::Ast parse_value(const std::string& option, const std::string& text) {
  const support::Source source(option, text);
  support::Diagnostics diagnostics;
  const std::optional<model::Ast> ast = model::parse_expression(spec::located(text), diagnostics);
  if (ast) model::check_constants(*ast, diagnostics);
  if (!ast || diagnostics.has_errors())
    throw UsageError(support::render(diagnostics, source), option, diagnostics.all());
  return *ast;
}

const std::string* absent_effect_of(const std::string& name, const model::Model& model) {
  constexpr std::string_view k_rate = "_dot";
  std::string of = name;
  const bool is_dot = name.rfind("dot(", 0) == 0 && name.back() == ')';
  if (is_dot) of = trimmed(name.substr(4, name.size() - 5));
  const auto& absent = model.words_of_absent_effects;
  const bool is_rate = !is_dot && of.size() > k_rate.size() && of.substr(of.size() - k_rate.size()) == k_rate;
  // An effect may mention what the model has: that, and its rate, are there all the same.
  if (is_rate && model.symbols.count(of) == 0 && absent.count(of) == 0) of.resize(of.size() - k_rate.size());
  const auto found = absent.find(of);
  return found == absent.end() || model.symbols.count(of) > 0 ? nullptr : &found->second.front();
}

namespace {

void refuse_other_symbols(const std::string& option, const model::Ast& ast, const model::Model& model) {
  if (ast.kind == model::AstKind::symbol) {
    const auto symbol = model.symbols.find(ast.name);
    const bool is_known = symbol != model.symbols.end() && (symbol->second.kind == model::SymbolKind::parameter ||
                                                            symbol->second.kind == model::SymbolKind::pi);
    if (ast.name == "nan" || ast.name == "inf")
      throw UsageError(fmt::format("{}: '{}' is no finite number", option, ast.name));
    if (!is_known)
      throw UsageError(fmt::format("{}: '{}' is not a parameter of the model{}", option, ast.name,
                                   ast.name == "t" ? "; what changes in time stands in the model itself" : ""));
  }
  if (ast.kind == model::AstKind::call && ast.name == "dot")
    throw UsageError(option + ": dot(...) has no meaning in a value");
  for (const model::Ast& child : ast.children) refuse_other_symbols(option, child, model);
}

bool has_symbol(const model::Ast& ast) {
  if (ast.kind == model::AstKind::symbol && ast.name != "pi") return true;
  for (const model::Ast& child : ast.children) {
    if (has_symbol(child)) return true;
  }
  return false;
}

class Override {
 public:
  Override(std::string name, model::Ast value, model::Model& model)
      : name_(std::move(name)), value_(std::move(value)), model_(model) {}

  void apply() {
    const bool is_dot = name_.rfind("dot(", 0) == 0 && name_.back() == ')';
    if (is_dot) return set_dot(trimmed(name_.substr(4, name_.size() - 5)));
    if (set_rate(name_)) return;
    const auto symbol = model_.symbols.find(name_);
    if (symbol == model_.symbols.end()) throw UsageError(unknown());
    set(symbol->second);
  }

 private:
  void set_dot(const std::string& coordinate) {
    if (set_rate(coordinate + "_dot")) return;
    std::vector<std::string> names;
    for (const model::Coordinate& candidate : model_.coordinates) names.push_back(candidate.name.text);
    const std::string near = support::closest(coordinate, names);
    throw UsageError(fmt::format("--set: the model has no coordinate '{}'{}", coordinate,
                                 near.empty() ? "" : fmt::format(", did you mean 'dot({})'?", near)));
  }

  bool set_rate(const std::string& rate) {
    for (model::Coordinate& coordinate : model_.coordinates) {
      if (coordinate.name.text + "_dot" != rate) continue;
      if (coordinate.held_at) throw UsageError(held());
      if (coordinate.speed)
        throw UsageError(fmt::format("--set: '{}' follows from the speeds of the model; set these", name_));
      coordinate.initial_rate = value_;
      return true;
    }
    return false;
  }

  void set(const model::SymbolRef& ref) {
    switch (ref.kind) {
      case model::SymbolKind::parameter:
        // A formula here could close a circle with the formulas of the model.
        if (has_symbol(value_)) throw UsageError(fmt::format("--set: give parameter '{}' a number", name_));
        model_.parameters[ref.index].value = value_;
        model_.parameters[ref.index].is_formula = false;
        return;
      case model::SymbolKind::input:
        model_.inputs[ref.index].value = value_;
        model_.inputs[ref.index].is_load = true;
        return;
      case model::SymbolKind::coordinate:
        if (model_.coordinates[ref.index].held_at) throw UsageError(held());
        model_.coordinates[ref.index].initial = value_;
        model_.coordinates[ref.index].guess.reset();
        return;
      case model::SymbolKind::quaternion_component:
        model_.orientations[ref.index / 4].initial[ref.index % 4] = value_;
        return;
      case model::SymbolKind::speed:
        model_.coordinates[model_.coordinate_of_speed(ref.index)].initial_rate = value_;
        return;
      case model::SymbolKind::angular_velocity:
        model_.orientations[ref.index / 3].initial_angular_velocity[ref.index % 3] = value_;
        return;
      default: throw UsageError(fmt::format("--set: '{}' cannot be set; for the time use --time", name_));
    }
  }

  std::string held() const {
    return fmt::format("--set: '{}' is held by the model; change the parameters in its held_at", name_);
  }

  std::string unknown() const {
    std::vector<std::string> names;
    for (const auto& symbol : model_.symbols) names.push_back(symbol.first);
    for (const model::Coordinate& coordinate : model_.coordinates) names.push_back(coordinate.name.text + "_dot");
    const auto& absent = model_.words_of_absent_effects;
    if (const auto found = absent.find(name_); found != absent.end())
      return fmt::format("--set: '{}' is of the effect '{}', which does not act", name_, found->second.front());
    const std::string near = support::closest(name_, names);
    return fmt::format("--set: the model has no '{}'{}", name_, near.empty() ? "" : ", did you mean '" + near + "'?");
  }

  std::string name_;
  model::Ast value_;
  model::Model& model_;
};

}  // namespace

support::Rational parse_time(const std::string& text) {
  const auto time = model::exact_value(parse_value("--time", text));
  if (!time) throw UsageError(fmt::format("--time: expected a number, not '{}'", text));
  return *time;
}

namespace {

/// Later stages know the text of the model only: what they say of a value that was set points at the name of the model.
void relocate(model::Ast& ast, support::Span span) {
  ast.span = span;
  for (model::Ast& child : ast.children) relocate(child, span);
}

/// dot(x) is x_dot.
std::string as_symbol(const std::string& name) {
  const bool is_dot = name.rfind("dot(", 0) == 0 && name.back() == ')';
  return is_dot ? trimmed(name.substr(4, name.size() - 5)) + "_dot" : name;
}

void refuse_second(const char* option, const std::string& name, std::set<std::string>& seen) {
  refuse_second_of(option, name, as_symbol(name), seen);
}

/// What emitted code calls the acceleration of a coordinate, an angular velocity component or a speed.
std::string acceleration_name(const std::string& name, const model::Model& model) {
  const auto symbol = model.symbols.find(name);
  const bool is_known = symbol != model.symbols.end();
  if (is_known && symbol->second.kind == model::SymbolKind::coordinate) {
    const model::Coordinate& coordinate = model.coordinates[symbol->second.index];
    if (!coordinate.held_at && !coordinate.speed) return name + "_ddot";
  }
  const bool is_speed = is_known && (symbol->second.kind == model::SymbolKind::angular_velocity ||
                                     symbol->second.kind == model::SymbolKind::speed);
  if (is_speed) return name + "_dot";
  for (const char* ending : {"_ddot", "_dot"}) {
    const std::size_t stem = name.size() - std::min(name.size(), std::string_view(ending).size());
    const auto owner = model.symbols.find(name.substr(0, stem));
    if (name.substr(stem) != ending || owner == model.symbols.end()) continue;
    throw UsageError(fmt::format("--accelerate: write '{}' for its acceleration, as in --accelerate {}=1, not '{}'",
                                 owner->first, owner->first, name));
  }
  throw UsageError(fmt::format("--accelerate: '{}' is no free coordinate, angular velocity component or speed", name));
}

}  // namespace

std::map<std::string, support::Rational> parse_accelerations(const std::vector<std::string>& assignments,
                                                             const model::Model& model) {
  std::map<std::string, support::Rational> wanted;
  std::set<std::string> seen;
  for (const std::string& text : assignments) {
    const NameAndText given = at_equals("--accelerate", text);
    const auto value = model::exact_value(parse_value("--accelerate " + given.name, given.text));
    if (!value) throw UsageError(fmt::format("--accelerate {}: a number is needed", given.name));
    const std::string acceleration = acceleration_name(given.name, model);
    refuse_second("--accelerate", given.name, seen);
    wanted[acceleration] = *value;
  }
  return wanted;
}

std::string not_finite(double value) {
  return fmt::format("with the values of the parameters this is {}",
                     std::isnan(value) ? "not a real number" : "infinite");
}

void Overrides::set(const std::string& option, const std::string& name, model::Ast value) {
  refuse_other_symbols(option, value, model_);
  relocate(value, model_.name.span);
  Override(name, value, model_).apply();
  refuse_second("--set", name, seen_);
  all_.push_back({option, std::move(value)});
}

void Overrides::check() const {
  const model::Values values = model::parameter_values(model_);
  for (const Given& given : all_) {
    const auto value = model::value_of(given.value, values);
    if (!value || std::isfinite(*value)) continue;
    throw UsageError(given.option + ": " + not_finite(*value));
  }
}

namespace {

std::string all_of(const std::vector<UsageError>& errors) {
  std::string text;
  for (const UsageError& error : errors) text += (text.empty() ? "" : "\n") + std::string(error.what());
  return text;
}

}  // namespace

void apply_overrides(const std::vector<std::string>& assignments, model::Model& model) {
  Overrides overrides(model);
  std::vector<UsageError> wrong;
  for (const std::string& text : assignments) {
    try {
      const NameAndText given = at_equals("--set", text);
      const std::string option = "--set " + given.name;
      overrides.set(option, given.name, parse_value(option, given.text));
    } catch (const UsageError& error) {
      wrong.push_back(error);
    }
  }
  if (wrong.size() == 1) throw wrong.front();
  if (!wrong.empty()) throw UsageError(all_of(wrong));
  overrides.check();
}

}  // namespace gaussgen::cli
