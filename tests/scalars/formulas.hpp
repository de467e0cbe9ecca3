#pragma once
// The sample models once more, written by hand for any scalar type; compared with what was emitted.

#include <cmath>

#include "gauss/math.hpp"
#include "nasty.hpp"
#include "pendulum.hpp"
#include "springs.hpp"
#include "zoo.hpp"

namespace gausstest {

/// |a - b| in units of eps (|a| + |b| + 1).
template <class S>
S distance(const S& a, const S& b) {
  const S difference = a < b ? b - a : a - b;
  const S scale = (a < S(0) ? -a : a) + (b < S(0) ? -b : b) + S(1);
  return difference / (scale * gauss::Math<S>::epsilon());
}

/// Largest distance of a run through all functions.
template <class S>
class Worst {
 public:
  void compare(const S& computed, const S& expected) {
    const S d = distance(computed, expected);
    // "not less" catches what is not a number, too.
    if (!(d < worst_)) worst_ = d;
  }
  double value() const { return static_cast<double>(worst_); }

 private:
  S worst_ = S(0);
};

template <class S>
double pendulum_error(const S& theta, const S& theta_dot, const S& torque) {
  using M = gauss::Math<S>;
  namespace model = gauss::pendulum;
  model::Parameters<S> parameters;
  parameters.l = S(3) / S(4);
  const S m = S(3) / S(2), l = parameters.l, g = S(981) / S(100);
  const model::Prepared<S> prepared = model::prepare(parameters);
  model::State<S> state;
  state.theta() = theta;
  state.values[1] = theta_dot;
  model::Inputs<S> inputs;
  inputs.torque = torque;

  Worst<S> worst;
  const S theta_ddot = (torque - m * g * l * M::sin(theta)) / (m * l * l);
  const S tension = m * l * theta_dot * theta_dot + m * g * M::cos(theta);
  const S kinetic = m * l * l * theta_dot * theta_dot / S(2);
  const S potential = -m * g * l * M::cos(theta);

  model::Derivative<S> derivative;
  (void)model::rhs(S(0), state, inputs, prepared, derivative);
  worst.compare(derivative.theta_dot(), theta_dot);
  worst.compare(derivative.theta_ddot(), theta_ddot);

  model::Reactions<S> reactions;
  model::Derivative<S> again;
  (void)model::rhs_and_reactions(S(0), state, inputs, prepared, again, reactions);
  worst.compare(again.values[1], derivative.values[1]);
  worst.compare(reactions.rod.tension, tension);
  (void)model::reactions(S(0), state, inputs, prepared, reactions);
  worst.compare(reactions.rod.force[0], -tension * M::sin(theta));
  worst.compare(reactions.rod.force[1], S(0));
  worst.compare(reactions.rod.force[2], tension * M::cos(theta));

  model::Energy<S> energy;
  (void)model::energy(S(0), state, inputs, prepared, energy);
  worst.compare(energy.kinetic, kinetic);
  worst.compare(energy.potential, potential);
  worst.compare(energy.total, kinetic + potential);

  model::Residual<S> residual;
  (void)model::residual(S(0), state, inputs, prepared, derivative, residual);
  worst.compare(residual.moment, S(0));

  (void)model::initial_state(prepared, state);
  worst.compare(state.theta(), S(3) / S(10));
  worst.compare(state.theta_dot() * state.theta_dot(), g / l);
  return worst.value();
}

template <class S>
double springs_error(const S& x, const S& y, const S& x_dot, const S& y_dot) {
  namespace model = gauss::springs;
  const S m1 = S(2), m2 = S(1) / S(3), k = S(40), k3 = k * S(4);
  const model::Prepared<S> prepared = model::prepare(model::Parameters<S>{});
  model::State<S> state{{x, y, x_dot, y_dot}};
  const model::Inputs<S> inputs;
  const S u = y - x;
  const S force = k * u + k3 * u * u * u;

  Worst<S> worst;
  model::Derivative<S> derivative;
  (void)model::rhs(S(0), state, inputs, prepared, derivative);
  worst.compare(derivative.x_ddot(), (force - k * x) / m1);
  worst.compare(derivative.y_ddot(), -force / m2);
  model::Energy<S> energy;
  (void)model::energy(S(0), state, inputs, prepared, energy);
  worst.compare(energy.kinetic, (m1 * x_dot * x_dot + m2 * y_dot * y_dot) / S(2));
  worst.compare(energy.potential, k * x * x / S(2) + k * u * u / S(2) + k3 * u * u * u * u / S(4));
  model::Centre<S> centre;
  (void)model::centre(S(0), state, inputs, prepared, centre);
  worst.compare(centre.position, (m1 * x + m2 * y) / (m1 + m2));
  worst.compare(centre.M[0][0], m1);
  worst.compare(centre.M[1][0], S(0));
  worst.compare(centre.M[1][1], m2);
  // In place: the result may be the argument.
  (void)model::project(S(0), state, inputs, prepared, state);
  worst.compare(state.x(), (x - y) / S(2));
  worst.compare(state.y(), (y - x) / S(2));
  worst.compare(state.x_dot(), (x_dot - y_dot) / S(2));
  worst.compare(state.y_dot(), (y_dot - x_dot) / S(2));
  return worst.value();
}

template <class S>
double nasty_error(const S& y, const S& fresh, const S& major, const S& sin_y) {
  using M = gauss::Math<S>;
  namespace model = gauss::linux_;
  const model::Prepared<S> prepared = model::prepare(model::Parameters<S>{});
  model::State<S> state{{y, fresh, major, sin_y, S(1), S(2), S(3), S(4)}};
  const S shared = fresh * major + S(13) * S(31);
  const S sine = M::sin(y);
  Worst<S> worst;
  model::Derivative<S> derivative;
  (void)model::rhs(S(5), state, model::Inputs<S>{}, prepared, derivative);
  worst.compare(derivative.new_dot(), S(2));
  worst.compare(derivative.y_ddot(), S(2 * 3 * 5 * 7 * 11) * y + sine * M::sin(shared) + sine * sine);
  worst.compare(derivative.new_ddot(),
                S(17 * 19) + S(23) * shared * shared + S(29) * shared * shared * shared + S(37) * M::cos(y));
  worst.compare(derivative.major_ddot(), S(5) * sin_y);
  worst.compare(derivative.sin_y_ddot(), fresh * major);
  model::Outputs<S> outputs;
  (void)model::outputs(S(0), state, model::Inputs<S>{}, prepared, outputs);
  worst.compare(outputs.new_.S_, shared);
  worst.compare(outputs.Delete.int_[1], y);
  return worst.value();
}

template <class S>
double functions_error(const S& x, const S& y) {
  using M = gauss::Math<S>;
  namespace model = models::zoo;
  const model::Prepared<S> prepared = model::prepare(model::Parameters<S>{});
  model::State<S> state{{x, y}};
  model::Functions<S> f;
  (void)model::functions(S(0), state, model::Inputs<S>{}, prepared, f);
  // By identities, so that a function taken for another one shows.
  Worst<S> worst;
  const S h = x / S(2);
  const S* v = f.value;
  worst.compare(v[0] * v[0] + v[1] * v[1], S(1));
  worst.compare(v[2] * v[1], v[0]);
  worst.compare(M::sin(v[3]), h);
  worst.compare(M::cos(v[4]), h);
  worst.compare(M::tan(v[5]), h);
  worst.compare(M::exp(v[7]), h);
  worst.compare(v[8] + v[9], v[6]);
  worst.compare(v[10] * v[9], v[8]);
  worst.compare(M::tan(v[11]) * y, x);
  worst.compare(M::sin(h), v[0]);

  model::Powers<S> powers;
  (void)model::powers(S(0), state, model::Inputs<S>{}, prepared, powers);
  const S* p = powers.of_x;
  const S root = M::sqrt(x);
  const S expected[] = {x * x,     x * x * x, x * x * x * x, x * x * x * x * x, x * x * x * x * x * x * x, S(1) / x, S(1) / (x * x),
                        S(1) / (x * x * x), root, x * root, x * x * root, S(1) / root, S(1) / (x * root)};
  for (int i = 0; i < 13; ++i) worst.compare(p[i], expected[i]);
  worst.compare(p[13] * p[13] * p[13], x);
  worst.compare(p[14] * p[13] * p[13], S(1));
  const S plus = S(1) / S(10) + y;
  worst.compare(powers.fraction, x / (y * plus * plus));
  worst.compare(powers.reciprocal, S(2) / (S(5) * y * y * y));
  return worst.value();
}

template <class S>
double sums_error(const S& x, const S& y) {
  using M = gauss::Math<S>;
  namespace model = models::zoo;
  const model::Prepared<S> prepared = model::prepare(model::Parameters<S>{});
  model::State<S> state{{x, y}};
  model::Sums<S> sums;
  (void)model::sums(S(0), state, model::Inputs<S>{}, prepared, sums);
  const S p = S(1) / S(10);
  const S pi = M::acos(S(-1));
  const S expected[] = {y - x, -x - y, (x - y) / S(3), S(1) - x, S(-1) - S(2) * x, S(2) * x / S(5), -(x * y),
                        x - (y - S(1)) * (x - p), pi * x + x * M::sin(pi * p)};
  Worst<S> worst;
  for (int i = 0; i < 9; ++i) worst.compare(sums.value[i], expected[i]);

  model::Numbers<S> numbers;
  (void)model::numbers(S(0), state, model::Inputs<S>{}, prepared, numbers);
  const S ten = S(10);
  worst.compare(numbers.value[0] * ten, S(1));
  S huge = S(1);
  for (int i = 0; i < 30; ++i) huge = huge * ten;
  worst.compare(numbers.value[1], huge + S(1));
  worst.compare(numbers.value[2] * (huge + S(1)), S(1));
  worst.compare(numbers.value[3], pi);
  worst.compare(numbers.value[4] * S(8), S(-3));
  worst.compare(numbers.value[5], S(1000000) * S(1000000));

  model::Conditions<S> chosen;
  (void)model::conditions(S(0), state, model::Inputs<S>{}, prepared, chosen);
  worst.compare(chosen.smaller, x < y ? x : y);
  worst.compare(chosen.chosen, x < y || p < x ? x * y : S(-1));
  return worst.value();
}

/// Over a few states; in units of eps of S.
template <class S>
double largest_error() {
  double worst = 0;
  for (int i = 0; i < 40; ++i) {
    const S a = S(1 + i % 7) / S(8);
    const S b = S(i - 20) / S(16);
    const S c = S(1 + i % 5) / S(3);
    const S d = S(2 + i % 11) / S(7);
    for (const double error : {pendulum_error(b, c, d), springs_error(a, b, c, d), nasty_error(a, b, c, d),
                               functions_error(a, d), sums_error(b, c)}) {
      if (!(error <= worst)) worst = error;
    }
  }
  return worst;
}

}  // namespace gausstest
