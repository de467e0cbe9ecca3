#pragma once
// Laws of mechanics at one state of a specimen; every figure is a deviation over the size of its terms.

#include <functional>

#include "newton/loads.hpp"
#include "newton/specimen.hpp"

namespace agreement::newton {

struct Deviations {
  double on_bodies = 0;    ///< m a and dH/dt less what acts, against on_<body>
  double links = 0;        ///< the same for what a joint carries, against joint_reactions
  double work = 0;         ///< d'Alembert along every coordinate: motion, multipliers and reactions of held coordinates
  double reactions = 0;    ///< work of on_<body> along what the constraints allow
  double joints = 0;       ///< work of joint_reactions along every coordinate: that of the drives alone
  double constraints = 0;  ///< dφ/dt
  double energy = 0;       ///< values of both energies
  double power = 0;        ///< d/dt of the generator's energy against the power of all that is not in it
  bool has_joint_work = false;

  /// Keeps the larger figures of both.
  void take(const Deviations& other);
  Deviations operator/(double bar) const;
  double worst() const;
  bool is_within(double bar) const { return worst() <= bar; }

 private:
  void each(const std::function<void(double Deviations::*)>& visit) const;
};

Deviations deviations(Specimen& specimen);

}  // namespace agreement::newton
