#include "gauss/oracle/bare_system.hpp"

namespace gaussgen::oracle {

namespace {

const Real k_step("1e-12");

Vec at(const BareSystem& s, const Vec& acceleration, const Real& tau) {
  Vec y = s.y;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += s.rate[i] * tau + acceleration[i] * tau * tau / 2;
  return y;
}

/// -Q_A δy^A of forces that are given as a potential or by components.
Real other_work(const BareSystem& s, const Vec& acceleration) {
  Real work = 0;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    Real Q = s.generalized.empty() ? Real(0) : s.generalized[i];
    if (s.potential) {
      Vec ahead = s.y;
      Vec behind = s.y;
      ahead[i] += k_step;
      behind[i] -= k_step;
      Q -= (s.potential(ahead, s.t) - s.potential(behind, s.t)) / (2 * k_step);
    }
    work += Q * acceleration[i];
  }
  return work;
}

/// (a - 2 b + c) / h²
Vec3 second_quotient(const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 result;
  for (std::size_t j = 0; j < 3; ++j) result[j] = (a[j] - 2 * b[j] + c[j]) / (k_step * k_step);
  return result;
}

std::vector<Vec3> first_quotients(const std::vector<Vec3>& ahead, const std::vector<Vec3>& behind) {
  std::vector<Vec3> result = ahead;
  for (std::size_t p = 0; p < ahead.size(); ++p) {
    for (std::size_t j = 0; j < 3; ++j) result[p][j] = (ahead[p][j] - behind[p][j]) / (2 * k_step);
  }
  return result;
}

Real compulsion(const BareSystem& s, const Vec& acceleration) {
  const auto a = accelerations(s, acceleration);
  Real Z = -other_work(s, acceleration);
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (std::size_t j = 0; j < 3; ++j) Z += s.mass[p] * pow(a[p][j] - s.field[j], 2) / 2;
  }
  return Z;
}

Vec constraint_rate(const BareSystem& s, const Vec& acceleration) {
  if (!s.constraints) return {};
  const auto phi = [&](const Real& tau) {
    Vec rate = s.rate;
    for (std::size_t i = 0; i < rate.size(); ++i) rate[i] += acceleration[i] * tau;
    return s.constraints(at(s, acceleration, tau), rate, s.t + tau);
  };
  const Vec ahead = phi(k_step);
  const Vec behind = phi(-k_step);
  Vec result;
  for (std::size_t m = 0; m < ahead.size(); ++m) result.push_back((ahead[m] - behind[m]) / (2 * k_step));
  return result;
}

Vec unit(std::size_t size, std::size_t i) {
  Vec v(size, 0);
  v[i] = 1;
  return v;
}

}  // namespace

std::vector<Vec3> velocities(const BareSystem& s) {
  const Vec uniform(s.y.size(), 0);
  return first_quotients(s.positions(at(s, uniform, k_step), s.t + k_step),
                         s.positions(at(s, uniform, -k_step), s.t - k_step));
}

std::vector<Vec3> accelerations(const BareSystem& s, const Vec& acceleration) {
  const auto now = s.positions(s.y, s.t);
  const auto ahead = s.positions(at(s, acceleration, k_step), s.t + k_step);
  const auto behind = s.positions(at(s, acceleration, -k_step), s.t - k_step);
  std::vector<Vec3> result;
  for (std::size_t p = 0; p < now.size(); ++p) result.push_back(second_quotient(ahead[p], now[p], behind[p]));
  return result;
}

std::vector<Vec3> displacements(const BareSystem& s, std::size_t A) {
  Vec ahead = s.y;
  Vec behind = s.y;
  ahead[A] += k_step;
  behind[A] -= k_step;
  return first_quotients(s.positions(ahead, s.t), s.positions(behind, s.t));
}

Real kinetic_energy(const BareSystem& s) {
  const auto v = velocities(s);
  Real twice = 0;
  for (std::size_t p = 0; p < v.size(); ++p)
    twice += s.mass[p] * (v[p][0] * v[p][0] + v[p][1] * v[p][1] + v[p][2] * v[p][2]);
  return twice / 2;
}

Real potential_energy(const BareSystem& s) {
  const auto r = s.positions(s.y, s.t);
  Real V = s.potential ? s.potential(s.y, s.t) : Real(0);
  for (std::size_t p = 0; p < r.size(); ++p) {
    V -= s.mass[p] * (r[p][0] * s.field[0] + r[p][1] * s.field[1] + r[p][2] * s.field[2]);
  }
  return V;
}

Probe probe(const BareSystem& s) {
  const std::size_t N = s.y.size();
  const Vec zero(N, 0);
  Probe p{Mat(N, Vec(N)), Vec(N), compulsion(s, zero), {}, constraint_rate(s, zero)};
  p.beta.assign(p.drift.size(), Vec(N));
  Vec single(N);
  for (std::size_t i = 0; i < N; ++i) {
    single[i] = compulsion(s, unit(N, i)) - p.rest;
    Vec twice = unit(N, i);
    twice[i] = 2;
    p.G[i][i] = compulsion(s, twice) - p.rest - 2 * single[i];
    p.linear[i] = single[i] - p.G[i][i] / 2;
    const Vec moved = constraint_rate(s, unit(N, i));
    for (std::size_t m = 0; m < p.drift.size(); ++m) p.beta[m][i] = moved[m] - p.drift[m];
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec both = unit(N, i);
      both[j] = 1;
      p.G[i][j] = p.G[j][i] = compulsion(s, both) - p.rest - single[i] - single[j];
    }
  }
  return p;
}

Motion minimise(const BareSystem& s, const Probe& p) {
  const std::size_t N = s.y.size();
  const std::size_t n = s.free_count;
  const std::size_t l = p.drift.size();
  Mat matrix(n + l, Vec(n + l, 0));
  Vec right(n + l, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) matrix[i][j] = p.G[i][j];
    right[i] = -p.linear[i];
    for (std::size_t j = n; j < N; ++j) right[i] -= p.G[i][j] * s.held_acceleration[j - n];
    for (std::size_t m = 0; m < l; ++m) matrix[n + m][i] = p.beta[m][i];
    for (std::size_t m = 0; m < l; ++m) matrix[i][n + m] = -p.beta[m][i];
  }
  for (std::size_t m = 0; m < l; ++m) {
    right[n + m] = -p.drift[m];
    for (std::size_t j = n; j < N; ++j) right[n + m] -= p.beta[m][j] * s.held_acceleration[j - n];
  }
  const Vec solution = solve(matrix, right);
  Motion motion{Vec(solution.begin(), solution.begin() + static_cast<long>(n)),
                Vec(solution.begin() + static_cast<long>(n), solution.end()),
                {}};
  Vec all = motion.accelerations;
  all.insert(all.end(), s.held_acceleration.begin(), s.held_acceleration.end());
  for (std::size_t i = n; i < N; ++i) {
    Real R = p.linear[i];
    for (std::size_t j = 0; j < N; ++j) R += p.G[i][j] * all[j];
    for (std::size_t m = 0; m < l; ++m) R -= motion.lambda[m] * p.beta[m][i];
    motion.R_x.push_back(R);
  }
  return motion;
}

}  // namespace gaussgen::oracle
