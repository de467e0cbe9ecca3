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
constexpr double k_rounding_of_powers = 1e-6;  ///< of tolerances that are powers

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

class GridMaker {
 public:
  GridMaker(const std::vector<Form>& forms, const GridOptions& options) : forms_(forms), options_(options) {}

  std::vector<Candidate> all() {
    for (const std::string& method : options_.only) add(0, *find_method(method), "double", default_projection(method));
    if (!options_.only.empty()) return std::move(all_);
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
    return std::move(all_);
  }

 private:
  /// Of what has no share yet.
  void give_until(double share) {
    for (; given_ < all_.size(); ++given_) all_[given_].share_of_time = share;
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
    if (!method.takes_step) candidate.setting.longest_step = forms_[form].model.scene.longest_step.value_or(0);
    if (method.takes_step) {
      const double duration = forms_[form].model.span.duration;
      for (const double step : between(duration / k_fewest_steps, duration / k_most_steps, 2)) {
        candidate.setting.step = step;
        all_.push_back(candidate);
      }
      return;
    }
    for (const double tolerance : between(options_.loosest, tightest(method.name, number), options_.per_decade)) {
      if (tolerance < least_tolerance(number) * (1 - k_rounding_of_powers)) return;
      candidate.setting.tolerance = tolerance;
      all_.push_back(candidate);
      all_.back().is_default = is_default(all_.back());
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
  std::vector<Candidate> all_;
  std::size_t given_ = 0;
};

}  // namespace

std::vector<Candidate> grid_of(const std::vector<Form>& forms, const GridOptions& options) {
  return GridMaker(forms, options).all();
}

}  // namespace gausssim
