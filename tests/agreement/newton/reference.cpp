#include "newton/reference.hpp"

#include <algorithm>

namespace agreement::newton {

using gaussgen::model::k_space;
using gaussgen::model::Model;

namespace {

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// Sines of angles that are none: below what any double means by far.
const Real k_nothing("1e-30");

/// Accelerations along the chain of frames, in parts that may cancel: seen from the ground, sizes of what each frame adds.
Real chain(const Model& model, Motion& motion, std::size_t frame) {
  Real sum = 0;
  while (frame != k_space) {
    const std::size_t parent = model.frames[frame].parent;
    const Vector3 before = parent == k_space ? Vector3(Vector3::Zero()) : motion.origin(parent).second;
    sum += (motion.origin(frame).second - before).norm();
    frame = parent;
  }
  return sum;
}

/// For what is asked of sizes only.
Eigen::VectorXd singular_values(const MatrixX& m) {
  const Eigen::MatrixXd rounded = m.unaryExpr([](const Real& x) { return static_cast<double>(x); }).eval();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(rounded).singularValues();
}

/// Of a spring with a length, whose ends are differences of larger coordinates: by what its direction takes from their rounding.
Real size_of_direction(const gaussgen::model::Spring& law, Motion& motion, Motion& along) {
  if (!law.length) return 0;
  const Vector gap = motion.origin(law.second) - motion.origin(law.first);
  const Real ends = motion.origin(law.second).value.norm() + motion.origin(law.first).value.norm();
  const Real force = functions::fabs(Real(motion(law.stiffness).value * motion(*law.length).value));
  const Real way = (along.origin(law.second).rate - along.origin(law.first).rate).norm();
  return force * ends / gap.value.norm() * way;
}

}  // namespace

struct Reference::System {
  System(const Model& model, const Values& constants, const State& state);

  MatrixX g, b;
  VectorX f, drift;
  VectorX f_size, drift_size;  ///< sizes of what they are sums of
  VectorX row_size;            ///< likewise of b, in units

 private:
  void add_forces(const Model& model, Course& course);
  void add_rows(const Model& model, Course& course);

  std::vector<Motion> displaced_;
  std::vector<Motion> pushed_;
};

Reference::System::System(const Model& model, const Values& constants, const State& state) {
  Course course(model, constants, state);
  for (std::size_t i = 0; i < course.free_count(); ++i) {
    displaced_.push_back(course.displacement(i));
    pushed_.push_back(course.unit_acceleration(i));
  }
  add_forces(model, course);
  add_rows(model, course);
}

// The work of m a and dH/dt along what joints allow is Jᵀ M w; that at a = 0 is Jᵀ M c.
void Reference::System::add_forces(const Model& model, Course& course) {
  const Eigen::Index n = index(course.free_count());
  g = MatrixX::Zero(n, n);
  f = f_size = VectorX::Zero(n);
  Motion base = course.motion(std::vector<Real>(course.free_count(), Real(0)));
  const std::vector<Load> all = loads(model, base);
  for (Eigen::Index i = 0; i < n; ++i) {
    Motion& along = displaced_[static_cast<std::size_t>(i)];
    Sum sum;
    for (const Load& load : all) sum.add(work(load, along));
    const WorkAlong others = work_along_coordinates(model, base, along);
    sum.add(others.of_potentials);
    sum.add(others.others);
    for (const auto& force : model.forces) {
      if (const auto* spring = std::get_if<gaussgen::model::Spring>(&force.law))
        sum.size += size_of_direction(*spring, base, along);
    }
    for (const auto& body : model.bodies) {
      const Sum at_rest = work_of_inertia(body, base, along);
      sum.add(at_rest, Real(-1));
      sum.size += base(body.mass).value * chain(model, base, body.frame) *
                  along.point(body.frame, along(body.centre)).rate.norm();
      for (Eigen::Index j = 0; j < n; ++j) {
        g(i, j) += work_of_inertia(body, pushed_[static_cast<std::size_t>(j)], along).value - at_rest.value;
      }
    }
    f[i] = sum.value;
    f_size[i] = sum.size;
  }
  g = MatrixX((g + g.transpose()) / Real(2));
}

void Reference::System::add_rows(const Model& model, Course& course) {
  const Eigen::Index n = index(course.free_count()), l = index(model.constraints.size());
  b = MatrixX::Zero(l, n);
  drift = drift_size = row_size = VectorX::Zero(l);
  Motion base = course.motion(std::vector<Real>(course.free_count(), Real(0)));
  for (Eigen::Index mu = 0; mu < l; ++mu) {
    const auto& constraint = model.constraints[static_cast<std::size_t>(mu)];
    drift[mu] = phi(constraint, base).rate;
    drift_size[mu] = functions::fabs(drift[mu]);
    VectorX terms = VectorX::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      b(mu, i) = phi(constraint, pushed_[static_cast<std::size_t>(i)]).rate - drift[mu];
      terms[i] = functions::fabs(b(mu, i));
    }
    for (const Load& action : actions(model, constraint, base)) {
      const Vector omega = base.omega(action.frame);
      const Real arm = (action.point - base.origin(action.frame).value).norm();
      drift_size[mu] += action.force.norm() *
                        (chain(model, base, action.frame) + arm * (omega.rate.norm() + omega.value.squaredNorm()));
      for (Eigen::Index i = 0; i < n; ++i) {
        terms[i] += work(action, displaced_[static_cast<std::size_t>(i)]).size;
      }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      const Real unit = g(i, i) > 0 ? Real(1 / functions::sqrt(g(i, i))) : Real(0);
      row_size[mu] += functions::pow(terms[i] * unit, Real(2));
    }
    row_size[mu] = functions::sqrt(row_size[mu]);
  }
}

Reference::Reference(const Model& model, const Values& constants, const State& state) {
  System system(model, constants, state);
  scale(system);
  solve(system);
}

void Reference::scale(System& system) {
  const Eigen::Index n = system.f.size(), l = system.drift.size();
  units = VectorX::Ones(n);
  const Real heaviest = n > 0 ? system.g.diagonal().maxCoeff() : Real(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (system.g(i, i) > k_nothing * k_nothing * heaviest) {
      units[i] = functions::sqrt(system.g(i, i));
    } else if (l > 0 && system.b.col(i).cwiseAbs().maxCoeff() > 0) {
      units[i] = system.b.col(i).cwiseAbs().maxCoeff();
    }
  }
  const VectorX inverse = units.cwiseInverse();
  system.g = MatrixX(inverse.asDiagonal() * system.g * inverse.asDiagonal());
  system.b = MatrixX(system.b * inverse.asDiagonal());
  system.f = VectorX(inverse.asDiagonal() * system.f);
  for (Eigen::Index i = 0; i < n; ++i) size = std::max(size, Real(system.f_size[i] * inverse[i]));
  for (Eigen::Index mu = 0; mu < l; ++mu) {
    const Real length = system.b.row(mu).norm();
    if (length == 0) continue;
    system.b.row(mu) /= length;
    system.drift[mu] /= length;
    system.drift_size[mu] /= length;
    system.row_size[mu] /= length;
    size = std::max(size, system.drift_size[mu]);
  }
}

void Reference::solve(System& system) {
  const Eigen::Index n = system.f.size(), l = system.drift.size();
  std::vector<Eigen::Index> own;
  sines = Eigen::VectorXd::Zero(l);
  if (l > 0) {
    Eigen::ColPivHouseholderQR<MatrixX> qr;
    qr.setThreshold(k_nothing);
    qr.compute(system.b.transpose());
    rank = qr.rank();
    for (Eigen::Index k = 0; k < rank; ++k) own.push_back(qr.colsPermutation().indices()[k]);
    sines.head(std::min(n, l)) = singular_values(system.b);
  }
  MatrixX kkt = MatrixX::Zero(n + rank, n + rank);
  VectorX right = VectorX::Zero(n + rank);
  kkt.topLeftCorner(n, n) = system.g;
  right.head(n) = system.f;
  for (Eigen::Index k = 0; k < rank; ++k) {
    const Eigen::Index mu = own[static_cast<std::size_t>(k)];
    kkt.row(n + k).head(n) = system.b.row(mu);
    kkt.col(n + k).head(n) = system.b.row(mu).transpose();
    right[n + k] = -system.drift[mu];
  }
  if (n == 0) return;
  // Multipliers have the squares of sines as pivots.
  Eigen::FullPivLU<MatrixX> lu;
  lu.setThreshold(k_nothing * k_nothing);
  lu.compute(kkt);
  is_determined = lu.rank() == n + rank;
  if (!is_determined) return;
  const Eigen::VectorXd values = singular_values(kkt);
  condition = values[0] / values[values.size() - 1];
  const VectorX found = lu.solve(right);
  const VectorX a = found.head(n);
  for (Eigen::Index mu = 0; mu < l; ++mu) {
    const Real left = functions::fabs(Real(system.b.row(mu).dot(a)) + system.drift[mu]);
    open = std::max(open, left);
    const Real terms = system.drift_size[mu] + a.norm();
    if (terms > 0) contradiction = std::max(contradiction, Real(left / terms));
    // Entries of a row that are differences leave their rounding, too.
    size = std::max(size, Real(system.row_size[mu] * a.cwiseAbs().maxCoeff()));
  }
  if (n > 0) size = std::max(size, a.cwiseAbs().maxCoeff());
  accelerations = units.cwiseInverse().asDiagonal() * a;
  reactions = units.asDiagonal() * VectorX(system.g * a - system.f);
}

}  // namespace agreement::newton
