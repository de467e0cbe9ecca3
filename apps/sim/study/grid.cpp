#include "sim/study/grid.hpp"

#include <cmath>

#include "sim/methods/methods.hpp"

namespace gausssim {

namespace {

/// Steps of one length that are as many in the motion as this, from few to many.
constexpr double k_fewest_steps = 1e2, k_most_steps = 1e7;

std::vector<double> between(double from, double to, int per_decade) {
  std::vector<double> values;
  const double decades = std::log10(from / to);
  const int count = static_cast<int>(std::lround(decades * per_decade));
  for (int k = 0; k <= count; ++k) values.push_back(from * std::pow(10.0, -static_cast<double>(k) / per_decade));
  return values;
}

void add(std::vector<Candidate>& all, std::size_t formulation, const Setting& setting) {
  Candidate candidate;
  candidate.formulation = formulation;
  candidate.setting = setting;
  all.push_back(candidate);
}

}  // namespace

std::vector<Candidate> grid_of(const PreparedModel& model, std::size_t formulation, const GridOptions& options) {
  std::vector<Candidate> all;
  for (const MethodInfo& method : methods()) {
    Setting setting;
    if (!method.missing.empty()) continue;
    setting.method = method.name;
    setting.projection = method.projects ? Projection::full : Projection::off;
    if (method.takes_step) {
      const double duration = model.span.duration;
      for (const double step : between(duration / k_fewest_steps, duration / k_most_steps, 2)) {
        setting.step = step;
        add(all, formulation, setting);
      }
      continue;
    }
    for (const double tolerance : between(options.loosest, options.tightest, options.per_decade)) {
      setting.tolerance = tolerance;
      add(all, formulation, setting);
    }
  }
  return all;
}

}  // namespace gausssim
