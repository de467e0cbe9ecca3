#include "nonholonomic/initial_state.hpp"

#include <cmath>
#include <exception>

namespace gaussgen::nonholonomic {

using gauss::Chart;
using gauss::ex;
using symbolic::FreeIndex;

namespace {

constexpr auto k_plain = GiNaC::subs_options::no_pattern;

class InitialState {
 public:
  InitialState(const model::Model& model, const Chart& chart) : model_(model), chart_(chart) {}

  GiNaC::exmap build() {
    state_[chart_.time()] = 0;
    for (const model::Parameter& parameter : model_.parameters) set(parameter.name.text, parameter.value);
    for (const model::Input& input : model_.inputs) set(input.name.text, input.value);
    for (const model::Coordinate& coordinate : model_.coordinates) add(coordinate);
    for (const model::Orientation& orientation : model_.orientations) add(orientation);
    take_rates_from_speeds();
    return state_;
  }

 private:
  void add(const model::Coordinate& coordinate) {
    const std::string& name = coordinate.name.text;
    set(name, coordinate.held_at ? *coordinate.held_at : coordinate.start());
    if (coordinate.held_at) {
      set(name + "_dot", chart_(*coordinate.held_at).diff(chart_.time()));
    } else {
      const auto& rate = coordinate.initial_rate ? coordinate.initial_rate : coordinate.rate_guess;
      set_rate(name + "_dot", rate);
    }
  }

  void add(const model::Orientation& orientation) {
    for (std::size_t i = 0; i < 4; ++i) set(orientation.quaternion[i].text, orientation.initial[i]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& stated = orientation.initial_angular_velocity[i];
      set_rate(orientation.angular_velocity[i].text, stated ? stated : orientation.angular_velocity_guess[i]);
    }
  }

  /// u = M q̇ + r, solved for q̇: what `add` took for rates are the speeds of the model's own.
  void take_rates_from_speeds() {
    std::vector<FreeIndex> replaced;
    for (const FreeIndex a : chart_.free()) {
      if (chart_.speed_instead(a)) replaced.push_back(a);
    }
    if (replaced.empty()) return;
    const auto n = static_cast<unsigned>(replaced.size());
    GiNaC::matrix M(n, n), rates(n, 1), rest(n, 1);
    GiNaC::exmap at_zero = state_;
    for (const FreeIndex a : replaced) at_zero[chart_[a].rate] = 0;
    for (unsigned i = 0; i < n; ++i) {
      const ex& is = chart_.speed_instead(replaced[i])->is;
      for (unsigned j = 0; j < n; ++j)
        M(i, j) = evaluate(chart_.at_attitude(is.diff(chart_[replaced[j]].rate)), state_);
      rest(i, 0) = state_[chart_[replaced[i]].rate] - evaluate(chart_.at_attitude(is), at_zero);
      rates(i, 0) = GiNaC::symbol();
    }
    try {
      const GiNaC::matrix solved = M.solve(rates, rest);
      for (unsigned i = 0; i < n; ++i) state_[chart_[replaced[i]].rate] = solved(i, 0);
    } catch (const std::runtime_error&) {
      // The speeds do not determine the rates at the start: any rates serve, since they only choose a partition.
    }
  }

  void set_rate(const std::string& name, const std::optional<model::Ast>& rate) {
    open_rate_ = open_rate_ + ex(GiNaC::numeric(3, 17));
    set(name, rate ? chart_(*rate) : open_rate_);
  }

  void set(const std::string& name, const model::Ast& value) { set(name, chart_(value)); }
  void set(const std::string& name, const ex& value) {
    state_[chart_.symbols().at(name)] = value.subs(state_, k_plain).evalf();
  }

  const model::Model& model_;
  const Chart& chart_;
  GiNaC::exmap state_;
  ex open_rate_ = GiNaC::numeric(5, 7);
};

}  // namespace

GiNaC::exmap initial_state(const model::Model& model, const Chart& chart) { return InitialState(model, chart).build(); }

double evaluate(const ex& f, const GiNaC::exmap& state) {
  try {
    const ex value = f.subs(state, k_plain).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value)) return 0;
    const auto number = GiNaC::ex_to<GiNaC::numeric>(value);
    const double result = number.is_real() ? number.to_double() : 0;
    return std::isfinite(result) ? result : 0;
  } catch (const std::exception&) {
    return 0;  // GiNaC reports a pole by an exception
  }
}

}  // namespace gaussgen::nonholonomic
