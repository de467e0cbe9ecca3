#include "sim/run/setting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gauss/integrate/taylor.hpp"
#include "sim/model/layout.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/jumps.hpp"

namespace gausssim {

namespace {

/// Tighter runs by the same method are no other ones then: they share what rounding makes of its steps. Stiff models take too many steps by others.
bool is_at_rounding(const Setting& setting) {
  return setting.tolerance > 0 && setting.tolerance <= least_tolerance(setting.number) &&
         !find_method(setting.method)->is_stiff;
}

}  // namespace

LongestSteps longest_steps(const PreparedModel& prepared, double lengthened) {
  constexpr double k_fine = 1009,
                   k_other = 499;  ///< parts of a motion: about as many as most have samples, and no multiples of these
  constexpr double k_most = 20, k_operations = 2e6;  ///< of rates, in calls of a step
  const double operations = std::max(prepared.operations, 1);
  const double times =
      is_jump(prepared.edge) ? std::clamp(std::floor(k_operations / operations / k_fine), 1.0, k_most) : 1;
  const auto longest = [&](double parts) {
    const double step = lengthened * prepared.span.duration / (times * parts);
    return std::min(step, prepared.scene.longest_step.value_or(step));
  };
  return {longest(k_fine), longest(k_other)};
}

std::string default_method(const PreparedModel& prepared, const Engine& engine, const std::string& number) {
  if (prepared.regimes) return k_method_of_any_model;
  const bool has_series = static_cast<bool>(engine.find("series_begin", scalar_of(number)));
  // A root of a square has series, on one side.
  if (find_function(prepared.model.tree, "taylor") != nullptr && has_series && prepared.edge.empty()) return "taylor";
  if (number != "float128") return k_method_of_any_model;
  return prepared.edge.empty() ? k_relative : k_method_of_edges;
}

Projection default_projection(const std::string& method) {
  return find_method(method)->projects ? Projection::full : Projection::off;
}

const std::string& number_name(const Scene& scene) {
  static const std::string k_usual = "double";
  return scene.number ? scene.number->text : k_usual;
}

Setting setting_of(const PreparedModel& prepared, const Engine& engine) {
  const Scene& scene = prepared.scene;
  Setting setting;
  setting.number = number_name(scene);
  setting.method = chooses_method(scene) ? default_method(prepared, engine, setting.number) : scene.method->text;
  setting.projection = scene.projection ? projection_of(scene.projection->text) : default_projection(setting.method);
  // Series take full projection, or none.
  const bool is_whole = setting.projection == Projection::full || setting.projection == Projection::off;
  if (chooses_method(scene) && setting.method == "taylor" && !is_whole) setting.method = k_method_of_any_model;
  setting.gain = scene.gain.value_or(setting.gain);
  if (find_method(setting.method)->takes_step) {
    setting.step = scene.step.value_or(prepared.span.duration / k_default_steps);
  } else {
    setting.tolerance = scene.tolerance.value_or(k_default_tolerance);
    setting.longest_step = scene.longest_step.value_or(0);
  }
  return setting;
}

Setting default_setting(const PreparedModel& prepared, const Engine& engine) {
  Setting setting;
  setting.method = prepared.series_operations > k_most_series_operations
                       ? k_method_of_any_model
                       : default_method(prepared, engine, setting.number);
  setting.projection = default_projection(setting.method);
  setting.tolerance = k_default_tolerance;
  setting.longest_step = prepared.scene.longest_step.value_or(0);
  return setting;
}

Setting by_other_terms(const Setting& setting, const PreparedModel& prepared) {
  constexpr int k_more = 4;
  Setting other = setting;
  const bool has_edges = !prepared.edge.empty() || prepared.regimes;
  if (has_edges && setting.method != "taylor") {
    const bool is_same = setting.method == k_method_of_edges;
    other.method = is_same && computes_in(*find_method(k_method_of_any_model), setting.number) ? k_method_of_any_model
                                                                                               : k_method_of_edges;
    constexpr double k_of_steps = 1e-10;  ///< instead of a step
    if (other.step > 0) other.tolerance = std::max(k_of_steps, least_tolerance(setting.number));
    other.step = 0;
  } else if (setting.method == "taylor") {
    const int most = find_method(setting.method)->order;
    const int usual = setting.order > 0 ? setting.order : gauss::integrate::taylor_order(setting.tolerance, most);
    other.order = usual + k_more <= most ? usual + k_more : usual - k_more;
  } else if (setting.method == k_method_of_any_model && computes_in(*find_method(k_relative), setting.number)) {
    other.method = k_relative;
  } else if (is_at_rounding(setting) && computes_in(*find_method(k_method_of_any_model), setting.number)) {
    other.method = k_method_of_any_model;
  }
  return other;
}

bool computes_in(const MethodInfo& method, const std::string& number) {
  if (number == "float128") return method.has_float128;
  return number == "double" || (number == "float" ? method.has_float : method.has_long_double);
}

double rounding_unit(const std::string& number) {
  if (number == "float") return std::numeric_limits<float>::epsilon();
  if (number == "double") return std::numeric_limits<double>::epsilon();
  return number == "long-double" ? static_cast<double>(std::numeric_limits<long double>::epsilon()) : 1.93e-34;
}

bool are_times_coarse(const std::string& number, double t, const Span& span) {
  constexpr double k_short = 1e-7;
  const double between_rows = span.duration / static_cast<double>(span.samples - 1);
  return rounding_unit(number) * std::abs(t) > k_short * between_rows;
}

double least_tolerance(const std::string& number) {
  if (number == "float") return 1e-7;
  if (number == "double") return 1e-15;
  return number == "long-double" ? 1e-18 : 1e-32;
}

}  // namespace gausssim
