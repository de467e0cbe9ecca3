#include "strategy/quadratic_form.hpp"

namespace gaussgen::strategy {

using ir::Expr;

QuadraticForm::QuadraticForm(ir::Graph& graph, std::size_t count, Component first_dual, NameOf name_of)
    : zero_(graph, graph.constant(0)),
      first_dual_(first_dual),
      P_(count),
      p_(count, zero_),
      name_of_(std::move(name_of)) {}

Expr QuadraticForm::entry(Component i, Component j) const {
  const auto found = P_[i].find(j);
  return found == P_[i].end() ? zero_ : found->second;
}

void QuadraticForm::add(Component i, Component j, Expr value) {
  if (!value.is_zero()) replace(i, j, entry(i, j) + value);
}

void QuadraticForm::replace(Component i, Component j, Expr value) {
  for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, i}}) {
    if (value.is_zero()) {
      P_[a].erase(b);
    } else {
      P_[a].insert_or_assign(b, value);
    }
  }
}

QuadraticForm::Row QuadraticForm::extract(Component i) {
  Row row = std::move(P_[i]);
  P_[i].clear();
  for (const auto& [j, value] : row) {
    if (j != i) P_[j].erase(i);
  }
  return row;
}

Eliminated QuadraticForm::minimise(Component i, Steps& steps) {
  name({i}, steps);
  return minimise(i, pow(entry(i, i), -1), steps);
}

std::vector<Component> QuadraticForm::put_in(Component i, const Row& row, const Vector& factors, Eliminated& result) {
  std::vector<Component> others;
  std::size_t at = 0;
  for (auto it = row.begin(); it != row.end(); ++it) {
    const Expr factor = factors[at++];
    result.factors.push_back({it->first, factor});
    others.push_back(it->first);
    for (auto other = it; other != row.end(); ++other) add(it->first, other->first, -(factor * other->second));
    p_[it->first] -= factor * p_[i];
  }
  p_[i] = zero_;
  return others;
}

Eliminated QuadraticForm::minimise(Component i, Expr inverse, Steps& steps) {
  Eliminated result{i, entry(i, i), -(p_[i] * inverse), {}, {}};
  Row row = extract(i);
  row.erase(i);
  Vector factors;
  for (const auto& [j, value] : row) factors.push_back(value * inverse);
  for (const Component other : put_in(i, row, factors, result)) {
    for (const Component j : row_of(other)) {
      if (other < first_dual_ || j < first_dual_) name(other, j, steps);
    }
    p_[other] = steps.name(p_[other], name_of_(other, other, true));
  }
  return result;
}

Eliminated QuadraticForm::resolve(Component i, Expr inverse, const std::string& name) {
  Eliminated result{i, entry(i, i), (p_[i] * inverse).kept_whole(name), {}, {}};
  Row row = extract(i);
  row.erase(i);
  Vector factors;
  for (const auto& [j, value] : row)
    factors.push_back(-(value * inverse).kept_whole(name + "_" + name_of_(j, j, true)));
  put_in(i, row, factors, result);
  return result;
}

Imposed QuadraticForm::impose(Component i, Component dual, Steps& steps) {
  name({i}, steps);
  const Expr pivot = entry(i, dual);
  const Expr inverse = pow(pivot, -1);
  Imposed result{{i, pivot, -(p_[dual] * inverse), {}, {}}, dual, {}, p_[i]};
  Row constraint = extract(dual);
  constraint.erase(i);
  p_[dual] = zero_;
  for (const auto& [j, value] : P_[i]) result.row.push_back({j, value});
  std::vector<LinearTerm> terms;
  for (const auto& [j, value] : constraint) {
    result.component.factors.push_back({j, value * inverse});
    terms.push_back({j, -(value * inverse)});
  }
  displace(i, result.component.offset);
  const std::vector<Component> others = neighbours(i);
  substitute(i, terms);
  name(others, steps);
  return result;
}

std::vector<Component> QuadraticForm::neighbours(Component i) const {
  std::vector<Component> result;
  for (const auto& [j, value] : P_[i]) {
    if (j != i) result.push_back(j);
  }
  return result;
}

void QuadraticForm::displace(Component i, Expr by) {
  if (by.is_zero()) return;
  for (const auto& [j, value] : P_[i]) p_[j] += value * by;
}

void QuadraticForm::couple(Component i, const LinearTerm& term) {
  const auto& [u, s] = term;
  const Row row = P_[i];
  for (const auto& [j, value] : row) {
    if (j == i) {
      add(u, u, s * s * value);
      add(u, i, s * value);
    } else {
      add(u, j, j == u ? s * value + s * value : s * value);
    }
  }
  p_[u] += s * p_[i];
}

void QuadraticForm::substitute(Component i, const std::vector<LinearTerm>& terms) {
  // ½ P_ii w_i² + w_i (Σ P_ij w_j + p_i)
  Row row = extract(i);
  const Expr p = p_[i];
  p_[i] = zero_;
  const auto diagonal = row.find(i);
  const Expr own = diagonal == row.end() ? zero_ : diagonal->second;
  row.erase(i);
  for (std::size_t a = 0; a < terms.size(); ++a) {
    const auto& [k, c] = terms[a];
    for (std::size_t b = a; b < terms.size(); ++b) add(k, terms[b].component, own * c * terms[b].coefficient);
    for (const auto& [j, value] : row) {
      const Expr product = c * value;
      add(k, j, k == j ? product + product : product);
    }
    p_[k] += c * p;
  }
}

// x = c X + s Y, y = c Y - s X. Of the block of x and y, f = (xx - yy) s + 2 xy c makes all three entries.
void QuadraticForm::turn(Component i, Component j, Component k, Component l, Expr sine, Expr cosine) {
  const Expr xx = entry(i, i), xy = entry(i, j), yy = entry(j, j);
  const Expr f = ((xx - yy) * sine + (xy + xy) * cosine).named("turned");
  Row first = extract(i), second = extract(j);
  for (const Component gone : {i, j}) {
    first.erase(gone);
    second.erase(gone);
  }
  add(k, k, xx - sine * f);
  add(l, l, yy + sine * f);
  add(k, l, cosine * f - xy);
  for (const auto& [other, x] : first) {
    add(k, other, cosine * x);
    add(l, other, sine * x);
  }
  for (const auto& [other, y] : second) {
    add(k, other, -(sine * y));
    add(l, other, cosine * y);
  }
  p_[k] += cosine * p_[i] - sine * p_[j];
  p_[l] += sine * p_[i] + cosine * p_[j];
  p_[i] = p_[j] = zero_;
}

std::vector<Component> QuadraticForm::row_of(Component i) const {
  std::vector<Component> result;
  for (const auto& [j, value] : P_[i]) result.push_back(j);
  return result;
}

void QuadraticForm::name(Component i, Component j, Steps& steps) {
  replace(i, j, steps.name(entry(i, j), name_of_(std::min(i, j), std::max(i, j), false)));
}

void QuadraticForm::name(const std::vector<Component>& rows, Steps& steps) {
  for (const Component i : rows) {
    for (const Component j : row_of(i)) name(i, j, steps);
    p_[i] = steps.name(p_[i], name_of_(i, i, true));
  }
}

}  // namespace gaussgen::strategy
