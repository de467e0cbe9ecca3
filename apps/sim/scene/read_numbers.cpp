#include "sim/scene/read_numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "model/constant.hpp"
#include "model/constant_check.hpp"
#include "model/evaluate.hpp"
#include "support/error_codes.hpp"

namespace gausssim {

namespace model = gaussgen::model;
namespace spec = gaussgen::spec;
using gaussgen::support::Span;

namespace {

/// What most would write.
std::string example_of(const std::string& key) {
  static const std::map<std::string, const char*> k_usual{{"duration", "10"},    {"every", "0.02"}, {"error", "1e-6"},
                                                          {"tolerance", "1e-9"}, {"step", "0.001"}, {"gain", "20"}};
  const auto one = k_usual.find(key);
  return fmt::format("such as {}: {}", key, one == k_usual.end() ? "0.01" : one->second);
}

}  // namespace

void NumberReader::refuse(Span span, const std::string& message, const std::string& hint) {
  if (!is_reported_) reading_.diagnostics.error(gaussgen::support::code::k_out_of_range, span, message, hint);
}

bool NumberReader::is_sound(const model::Ast& ast) {
  gaussgen::support::Diagnostics found;
  model::check_constants(ast, found);
  if (found.has_errors()) reading_.diagnostics.add(found.all().front());
  is_reported_ = model::is_broken(ast) || found.has_errors();
  return !is_reported_;
}

std::optional<gaussgen::support::Rational> NumberReader::exact(const spec::Node& node, Span owner) {
  const model::Ast ast = model::read_expression(node, owner, reading_);
  return is_sound(ast) ? model::exact_value(ast) : std::nullopt;
}

std::optional<long> NumberReader::whole(const spec::Node& node, Span owner, long least, long most, long usual) {
  const auto value = exact(node, owner);
  if (value && gaussgen::support::is_integer(*value) && *value >= least && *value <= most)
    return static_cast<long>(gaussgen::support::to_double(*value));
  refuse(node.span, fmt::format("expected a whole number from {} to {}", least, most),
         fmt::format("such as {}", usual));
  return std::nullopt;
}

std::optional<double> NumberReader::positive(const spec::Node& map, const std::string& key) {
  const spec::Node* const node = spec::find(map, key);
  if (node == nullptr) return std::nullopt;
  const auto value = exact(*node, node->span);
  const double number = value ? gaussgen::support::to_double(*value) : 0;
  if (number > 0 && std::isfinite(number)) return number;
  refuse(node->span, fmt::format("'{}' is a number above 0", key), example_of(key));
  return std::nullopt;
}

std::optional<double> NumberReader::real(const spec::Node& node, Span owner) {
  const model::Ast ast = model::read_expression(node, owner, reading_);
  if (!is_sound(ast)) return std::nullopt;
  const auto value = model::value_of(ast, {{"pi", std::acos(-1.0)}});
  if (value && std::isfinite(*value)) return value;
  refuse(node.span, "expected a number, which may be made of numbers and pi", "such as 0.5, 1/3 or 2*pi");
  return std::nullopt;
}

}  // namespace gausssim
