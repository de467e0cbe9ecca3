#include "sim/run/number_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "cli/usage_error.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace model = gaussgen::model;

/// With all its digits: what is smaller than the smallest of these has fewer.
bool holds(double value) {
  const double size = std::abs(value);
  return size == 0 || !std::isfinite(size) ||
         (size >= std::numeric_limits<float>::min() && size <= std::numeric_limits<float>::max());
}

class RangeCheck {
 public:
  explicit RangeCheck(const model::Values& parameters) : parameters_(parameters) {}

  std::vector<std::string> of(const model::Model& model) {
    for (const model::Parameter& one : model.parameters) look(one.name.text, one.value);
    for (const model::Input& one : model.inputs) look(one.name.text, one.value);
    for (const model::Coordinate& one : model.coordinates) {
      look(one.name.text, one.initial);
      look("the rate of " + one.name.text, one.initial_rate);
    }
    for (const model::Orientation& one : model.orientations) {
      for (std::size_t i = 0; i < one.initial.size(); ++i) look(one.quaternion[i].text, one.initial[i]);
      for (std::size_t i = 0; i < 3; ++i) look(one.angular_velocity[i].text, one.initial_angular_velocity[i]);
    }
    return beyond_;
  }

 private:
  void look(const std::string& name, const std::optional<model::Ast>& ast) {
    const auto value = ast ? model::value_of(*ast, parameters_) : std::nullopt;
    if (value && !holds(*value)) beyond_.push_back(fmt::format("{} = {:.6g}", name, *value));
  }

  const model::Values& parameters_;
  std::vector<std::string> beyond_;
};

}  // namespace

void check_range_of_numbers(const Scene& scene, const model::Model& model, const model::Values& parameters,
                            gaussgen::support::Diagnostics& diagnostics) {
  if (!scene.number || scene.number->text != "float") return;
  const std::vector<std::string> beyond = RangeCheck(parameters).of(model);
  if (beyond.empty()) return;
  const std::string message = fmt::format("float does not hold {}", gaussgen::support::joined(beyond));
  const std::string hint = fmt::format("it has numbers from {:.2g} to {:.2g}; choose double",
                                       std::numeric_limits<float>::min(), std::numeric_limits<float>::max());
  if (is_of_option(scene.number->span)) throw gaussgen::cli::UsageError("--number: " + message + "; " + hint);
  diagnostics.error(gaussgen::support::code::k_out_of_range, scene.number->span, message, hint);
}

}  // namespace gausssim
