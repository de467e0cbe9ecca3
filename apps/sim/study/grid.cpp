#include "sim/study/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/methods/methods.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

/// Steps of one length that are as many in the motion as this, from few to many.
constexpr double k_fewest_steps = 1e2, k_most_steps = 1e7;
constexpr double k_tightest = 1e-13;           ///< tolerance
constexpr double k_rounding_of_powers = 1e-6;  ///< of tolerances and steps that are powers

std::vector<double> between(double from, double to, int per_decade) {
  std::vector<double> values;
  const double decades = std::log10(from / to);
  const int count = static_cast<int>(std::lround(decades * per_decade));
  for (int k = 0; k <= count; ++k) {
    // As they are written: 1e-06 is not 1.0000000000000004e-06.
    const double value = from * std::pow(10.0, -static_cast<double>(k) / per_decade);
    values.push_back(per_decade == 1 ? std::stod(fmt::format("{:.3g}", value)) : value);
  }
  return values;
}

/// As it is taken: steps of one length divide the time from a sample to the next.
double step_between_samples(double step, const Span& span) {
  const double between = span.duration / static_cast<double>(span.samples - 1);
  return between / std::ceil(between / step * (1 - k_rounding_of_powers));
}

class GridMaker {
 public:
  GridMaker(const std::vector<Form>& forms, const GridOptions& options) : forms_(forms), options_(options) {}

  std::vector<Candidate> all() {
    for (const std::string& method : options_.only) add(0, *find_method(method), "double", default_projection(method));
    if (!options_.only.empty()) {
      give_until(1);
      return std::move(all_);
    }
    const std::vector<std::string> usual = usual_methods();
    for (std::size_t form = 0; form < forms_.size(); ++form)
      for (const std::string& method : usual) add(form, *find_method(method), "double", default_projection(method));
    give_until(0.3);
    for (const bool is_stiff : {false, true}) {
      for (const MethodInfo& method : methods()) {
        if (method.is_stiff == is_stiff && std::count(usual.begin(), usual.end(), method.name) == 0)
          add(0, method, "double", default_projection(method.name));
      }
    }
    give_until(0.7);
    for (const char* const number : {"float", "long-double", "float128"})
      for (const std::string& method : usual) add(0, *find_method(method), number, default_projection(method));
    give_until(0.85);
    for (const auto& [word, how] : k_projections)
      for (const std::string& method : usual)
        if (how != default_projection(method)) add(0, *find_method(method), "double", how);
    give_until(1);
    return std::move(all_);
  }

 private:
  /// What has been added since the last time may run until then: the loosest setting of each first, so that none goes without for what tight ones of others take.
  void give_until(double share) {
    std::size_t most = 0;
    for (const auto& row : rows_) most = std::max(most, row.size());
    for (std::size_t i = 0; i < most; ++i) {
      for (const auto& row : rows_) {
        if (i >= row.size()) continue;
        all_.push_back(row[i]);
        all_.back().share_of_time = share;
      }
    }
    rows_.clear();
  }

  /// The default of this model, and that of any model.
  std::vector<std::string> usual_methods() const {
    std::vector<std::string> usual{default_method(forms_.front().model, *forms_.front().engine, "double")};
    if (usual.front() != k_method_of_any_model) usual.push_back(k_method_of_any_model);
    return usual;
  }

  void add(std::size_t form, const MethodInfo& method, const std::string& number, Projection projection) {
    if (!method.missing.empty() || !computes_in(method, number)) return;
    Candidate candidate;
    candidate.form = form;
    candidate.setting.method = method.name;
    candidate.setting.number = number;
    candidate.setting.projection = projection;
    std::vector<Candidate>& row = rows_.emplace_back();
    if (!method.takes_step) candidate.setting.longest_step = forms_[form].model.scene.longest_step.value_or(0);
    if (method.takes_step) {
      const Span& span = forms_[form].model.span;
      for (const double step : between(span.duration / k_fewest_steps, span.duration / k_most_steps, 2)) {
        const double taken = step_between_samples(step, span);
        if (!row.empty() && taken == row.back().setting.step) continue;
        candidate.setting.step = taken;
        row.push_back(candidate);
      }
      return;
    }
    for (const double tolerance : between(options_.loosest, tightest(method.name, number), options_.per_decade)) {
      if (tolerance < least_tolerance(number) * (1 - k_rounding_of_powers)) return;
      candidate.setting.tolerance = tolerance;
      row.push_back(candidate);
      row.back().is_default = is_default(candidate);
    }
  }

  /// Methods that nobody has to choose go as far as the digits do: else a front would end where something else is cheapest by default.
  double tightest(const std::string& method, const std::string& number) const {
    if (options_.tightest > 0) return options_.tightest;
    const std::vector<std::string> usual = usual_methods();
    const bool goes_on = number != "float128" && std::count(usual.begin(), usual.end(), method) > 0;
    return goes_on ? least_tolerance(number) : k_tightest;
  }

  bool is_default(const Candidate& candidate) const {
    const Setting usual = default_setting(forms_.front().model, *forms_.front().engine);
    const Setting& setting = candidate.setting;
    return candidate.form == 0 && setting.method == usual.method && setting.number == usual.number &&
           setting.tolerance == usual.tolerance && setting.projection == usual.projection;
  }

  const std::vector<Form>& forms_;
  const GridOptions& options_;
  std::vector<std::vector<Candidate>> rows_;  ///< of one method each, from loose to tight
  std::vector<Candidate> all_;
};

}  // namespace

std::vector<Candidate> grid_of(const std::vector<Form>& forms, const GridOptions& options) {
  return GridMaker(forms, options).all();
}

}  // namespace gausssim
