#include "newton/checks.hpp"

#include "newton/setting.hpp"

namespace agreement::newton {

using Eigen::Vector3d;

namespace {

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

double ratio(double value, double size) { return size == 0 && value == 0 ? 0 : std::fabs(value) / size; }
double ratio(const Sum& sum) { return ratio(sum.value, sum.size); }

/// Forces and moments that shall add up to nothing.
class Balance {
 public:
  void add(const Vector3d& force, const Vector3d& arm, const Vector3d& moment, double sign) {
    force_ += sign * force;
    moment_ += sign * (moment + arm.cross(force));
    force_size_ += force.norm();
    moment_size_ += moment.norm() + arm.norm() * force.norm();
  }

  /// Terms that have cancelled before they came here.
  void enlarge(double force, double moment) {
    force_size_ += force;
    moment_size_ += moment;
  }

  double deviation() const { return std::max(ratio(force_.norm(), force_size_), ratio(moment_.norm(), moment_size_)); }

 private:
  Vector3d force_ = Vector3d::Zero();
  Vector3d moment_ = Vector3d::Zero();
  double force_size_ = 0;
  double moment_size_ = 0;
};

void add_inertia(std::size_t i, const Vector3d& about, Setting& setting, Balance& balance) {
  const gaussgen::model::Body& body = setting.model.bodies[i];
  const Vector at = setting.centre(body);
  const Vector3d arm = at.value - about;
  const Vector3d spin = body.inertia ? rate_of_spin(body, setting.motion) : Vector3d::Zero();
  balance.add(setting.motion(body.mass).value * at.second, arm, spin, 1);
  balance.enlarge(setting.terms[i].force, setting.terms[i].moment + arm.norm() * setting.terms[i].force);
}

double of_body(std::size_t i, Setting& setting) {
  const gaussgen::model::Body& body = setting.model.bodies[i];
  const Vector3d centre = setting.centre(body).value;
  Balance balance;
  add_inertia(i, centre, setting, balance);
  for (const Load& load : setting.loads) {
    if (!setting.acts_on(load, i)) continue;
    const Vector3d arm = body.inertia ? Vector3d(load.point - centre) : Vector3d::Zero();
    balance.add(load.force, arm, body.inertia ? load.moment : Vector3d::Zero(), -1);
  }
  balance.add(setting.specimen.on_bodies[i].force, Vector3d::Zero(), setting.specimen.on_bodies[i].moment, -1);
  return balance.deviation();
}

/// What a joint feels is a sum over all that it carries, of which little may be left.
void enlarge_by_carried(std::size_t joint, const Vector3d& about, Setting& setting, Balance& balance) {
  const gaussgen::model::Model& model = setting.model;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    std::size_t at = model.bodies[i].frame;
    while (at != gaussgen::model::k_space && at != model.joints[joint].frame) at = model.frames[at].parent;
    if (at == gaussgen::model::k_space) continue;
    const double arm = (setting.centre(model.bodies[i]).value - about).norm();
    balance.enlarge(setting.terms[i].force, setting.terms[i].moment + arm * setting.terms[i].force);
  }
}

// About the origin of the child: its own joint, those of its children the other way round, and all that acts at places on it.
double of_link(std::size_t joint, Setting& setting) {
  const gaussgen::model::Model& model = setting.model;
  const Vector3d about = setting.motion.origin(model.joints[joint].frame).value;
  Balance balance;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (setting.link_of(model.bodies[i].frame) == joint) add_inertia(i, about, setting, balance);
  }
  const auto take_away = [&](const Load& load, double factor) {
    if (setting.link_of(load.frame) != joint) return;
    balance.add(factor * load.force, load.point - about, factor * load.moment, -1);
  };
  for (const Load& load : setting.loads) take_away(load, 1);
  for (std::size_t mu = 0; mu < setting.actions.size(); ++mu) {
    for (const Load& action : setting.actions[mu]) take_away(action, setting.specimen.lambda[mu]);
  }
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const gaussgen::model::Frame& child = model.frames[model.joints[k].frame];
    const Wrench& felt = setting.specimen.in_joints[k];
    const Vector3d arm = setting.motion.origin(model.joints[k].frame).value - about;
    const bool is_of_child = k != joint && setting.link_of(child.parent) == joint;
    if (k == joint) balance.add(felt.force, arm, felt.moment, -1);
    if (is_of_child) balance.add(felt.force, arm, felt.moment, 1);
    if (k == joint || is_of_child) enlarge_by_carried(k, about, setting, balance);
  }
  return balance.deviation();
}

/// sqrt(g_AA), so that all rows meet in one unit; 1 where nothing moves.
std::vector<double> units(Setting& setting) {
  std::vector<double> result;
  for (Motion& displaced : setting.displaced) {
    double square = 0;
    for (const auto& body : setting.model.bodies) {
      square +=
          setting.motion(body.mass).value * displaced.point(body.frame, displaced(body.centre)).rate.squaredNorm();
      if (!body.inertia) continue;
      const Vector3d turn = setting.motion.axes(body.frame).value.transpose() * displaced.omega(body.frame).value;
      square += turn.dot(inertia(body, setting.motion) * turn);
    }
    result.push_back(square > 0 ? std::sqrt(square) : 1);
  }
  return result;
}

/// Rows of which each is known to the rounding of the largest, as a linear system is solved.
class Rows {
 public:
  void add(const Sum& row, double unit) {
    worst_ = std::max(worst_, std::isnan(row.value) ? HUGE_VAL : std::fabs(row.value) / unit);
    largest_ = std::max(largest_, row.size / unit);
  }
  double deviation() const { return ratio(worst_, largest_); }

 private:
  double worst_ = 0;
  double largest_ = 0;
};

double largest_violation(Setting& setting, const std::vector<double>& units) {
  Rows rows;
  for (Eigen::Index mu = 0; mu < setting.beta.rows(); ++mu) {
    Sum sum;
    double square = 0;
    sum.add(setting.drift[mu]);
    // Accelerations of the places on which it acts, in parts that may cancel.
    for (const Load& action : setting.actions[static_cast<std::size_t>(mu)]) {
      const Vector origin = setting.motion.origin(action.frame);
      const Vector omega = setting.motion.omega(action.frame);
      const double arm = (action.point - origin.value).norm();
      const double turning = arm * (omega.rate.norm() + omega.value.squaredNorm());
      sum.size += action.force.norm() * (origin.second.norm() + turning);
    }
    for (std::size_t i = 0; i < setting.course.free_count(); ++i) {
      const double beta = setting.beta(mu, index(i));
      sum.add(beta * setting.specimen.a[i]);
      square += beta * beta / (units[i] * units[i]);
    }
    rows.add(sum, square > 0 ? std::sqrt(square) : 1);
  }
  return rows.deviation();
}

/// Inertia less all that acts, along A; what is left is the constraint along A, held or not.
Sum unexplained(std::size_t i, Setting& setting) {
  Motion& displaced = setting.displaced[i];
  Sum sum{0, setting.size_of_work(displaced)};
  for (const auto& body : setting.model.bodies) sum.add(work_of_inertia(body, setting.motion, displaced));
  sum.add(work_of_loads(setting.loads, displaced), -1);
  const WorkAlong along = work_along_coordinates(setting.model, setting.motion, displaced);
  sum.add(along.of_potentials, -1);
  sum.add(along.others, -1);
  return sum;
}

void add_reactions(std::size_t i, Setting& setting, Sum& sum) {
  for (std::size_t mu = 0; mu < setting.specimen.lambda.size(); ++mu) {
    const double lambda = setting.specimen.lambda[mu];
    sum.add(-lambda * setting.beta(index(mu), index(i)));
    // Forces on places that move together do large works against each other.
    sum.size += std::fabs(lambda) * work_of_loads(setting.actions[mu], setting.displaced[i]).size;
  }
  if (i >= setting.course.free_count()) sum.add(-setting.specimen.R[i - setting.course.free_count()]);
}

/// Of on_<body> along A, beyond the forces that name no body.
Sum work_on_bodies(std::size_t i, Setting& setting) {
  Motion& displaced = setting.displaced[i];
  Sum sum{0, setting.size_of_work(displaced)};
  for (std::size_t k = 0; k < setting.model.bodies.size(); ++k) {
    const auto& body = setting.model.bodies[k];
    const Wrench& felt = setting.specimen.on_bodies[k];
    const Load load{body.frame, setting.centre(body).value, felt.force, felt.moment, false, nullptr};
    sum.add(work(load, displaced));
  }
  for (const Load& load : setting.loads) {
    bool is_all_felt = false;
    for (std::size_t k = 0; k < setting.model.bodies.size(); ++k) {
      if (!setting.acts_on(load, k)) continue;
      is_all_felt = setting.model.bodies[k].inertia.has_value();
      // A particle feels no moment.
      const Load felt{load.frame, setting.centre(setting.model.bodies[k]).value, load.force, Vector3d::Zero(), false,
                      nullptr};
      if (!is_all_felt) sum.add(work(felt, displaced));
    }
    if (!is_all_felt) sum.add(work(load, displaced), -1);
  }
  const WorkAlong along = work_along_coordinates(setting.model, setting.motion, displaced);
  sum.add(along.of_potentials, -1);
  sum.add(along.others, -1);
  return sum;
}

/// Every displacement that the constraints allow does no work: the worst of a basis of them.
double of_admissible(Setting& setting, const std::vector<double>& units) {
  const std::size_t n = setting.course.free_count();
  if (n == 0) return 0;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(1, setting.beta.rows()), index(n));
  if (setting.beta.rows() > 0) b = setting.beta.leftCols(index(n));
  std::vector<Sum> works;
  for (std::size_t i = 0; i < n; ++i) {
    works.push_back(work_on_bodies(i, setting));
    Sum reactions;
    add_reactions(i, setting, reactions);
    works.back().size += reactions.size;
    b.col(index(i)) /= units[i];
  }
  for (Eigen::Index mu = 0; mu < setting.beta.rows(); ++mu) b.row(mu).normalize();
  const Eigen::MatrixXd basis = Eigen::JacobiSVD<Eigen::MatrixXd>(b, Eigen::ComputeFullV).matrixV();
  Rows rows;
  for (Eigen::Index k = setting.beta.rows(); k < basis.cols(); ++k) {
    Sum sum;
    for (std::size_t i = 0; i < n; ++i) sum.add(works[i], basis(index(i), k) / units[i]);
    rows.add(sum, 1);
  }
  return rows.deviation();
}

/// Joints do the work of the drives in them, and of the constraints that name no places.
Sum of_joints(std::size_t i, Setting& setting) {
  Motion& displaced = setting.displaced[i];
  Sum sum{0, setting.size_of_work(displaced)};
  for (std::size_t k = 0; k < setting.model.joints.size(); ++k) {
    const std::size_t frame = setting.model.joints[k].frame;
    const Wrench& felt = setting.specimen.in_joints[k];
    Load load{frame, setting.motion.origin(frame).value, felt.force, felt.moment, false, nullptr};
    sum.add(work(load, displaced));
    load.frame = setting.model.frames[frame].parent;
    if (load.frame != gaussgen::model::k_space) sum.add(work(load, displaced), -1);
  }
  const WorkAlong along = work_along_coordinates(setting.model, setting.motion, displaced);
  sum.add(along.of_potentials, -1);
  sum.add(along.others, -1);
  add_reactions(i, setting, sum);
  for (std::size_t mu = 0; mu < setting.actions.size(); ++mu) {
    sum.add(work_of_loads(setting.actions[mu], displaced), setting.specimen.lambda[mu]);
  }
  return sum;
}

/// What changes kinetic and potential energy: forces without a potential, constraints that move, and time itself.
Sum power(Setting& setting, const Energy& stored) {
  Sum sum = stored.explicit_power;
  for (const Load& load : setting.loads) {
    if (!load.has_potential) sum.add(work(load, setting.motion));
  }
  const std::vector<double> rates = setting.course.rates();
  for (std::size_t i = 0; i < rates.size(); ++i) {
    sum.add(work_along_coordinates(setting.model, setting.motion, setting.displaced[i]).others, rates[i]);
    Sum reactions;
    add_reactions(i, setting, reactions);
    sum.add(reactions, -rates[i]);
  }
  for (const auto& body : setting.model.bodies) sum.add(work_of_inertia(body, setting.motion, setting.time));
  sum.add(work_of_loads(setting.loads, setting.time), -1);
  return sum;
}

void add_energies(Setting& setting, Deviations& result) {
  const Energy stored = energy(setting.model, setting.motion, setting.time);
  const Specimen& specimen = setting.specimen;
  agreement::take(result.energy, ratio(stored.kinetic.value - specimen.kinetic, stored.kinetic.size));
  agreement::take(result.energy, ratio(stored.potential.value - specimen.potential, stored.potential.size));
  Sum balance = power(setting, stored);
  // Both energies exchange far more than their sum changes.
  balance.size += setting.size_of_work(setting.motion);
  balance.add(-specimen.energy_rate);
  agreement::take(result.power, ratio(balance));
}

}  // namespace

void Deviations::each(const std::function<void(double Deviations::*)>& visit) const {
  for (const auto member : {&Deviations::on_bodies, &Deviations::links, &Deviations::work, &Deviations::reactions,
                            &Deviations::joints, &Deviations::constraints, &Deviations::energy, &Deviations::power}) {
    visit(member);
  }
}

void Deviations::take(const Deviations& other) {
  each([&](double Deviations::*member) { agreement::take(this->*member, other.*member); });
  has_joint_work = has_joint_work || other.has_joint_work;
}

Deviations Deviations::operator/(double bar) const {
  Deviations result = *this;
  each([&](double Deviations::*member) { result.*member /= bar; });
  return result;
}

double Deviations::worst() const {
  double result = 0;
  each([&](double Deviations::*member) { agreement::take(result, this->*member); });
  return result;
}

Deviations deviations(Specimen& specimen) {
  Setting setting(specimen);
  Deviations result;
  for (std::size_t i = 0; i < setting.model.bodies.size(); ++i) agreement::take(result.on_bodies, of_body(i, setting));
  for (std::size_t j = 0; j < setting.model.joints.size(); ++j) agreement::take(result.links, of_link(j, setting));
  result.has_joint_work = setting.is_of_joints();
  const std::vector<double> unit = units(setting);
  Rows work;
  Rows joints;
  for (std::size_t i = 0; i < setting.course.full_count(); ++i) {
    Sum sum = unexplained(i, setting);
    add_reactions(i, setting, sum);
    work.add(sum, unit[i]);
    if (result.has_joint_work) joints.add(of_joints(i, setting), unit[i]);
  }
  result.work = work.deviation();
  result.joints = joints.deviation();
  result.reactions = of_admissible(setting, unit);
  result.constraints = largest_violation(setting, unit);
  add_energies(setting, result);
  return result;
}

}  // namespace agreement::newton
