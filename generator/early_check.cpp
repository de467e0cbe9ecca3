#include "early_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generic_point.hpp"
#include "ir/symbol_sets.hpp"
#include "model/rate.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "value_check.hpp"

namespace gaussgen {

namespace {

using ir::Expr;

class Gradients {
 public:
  explicit Gradients(ModelGraph& motion)
      : motion_(motion),
        rates_(rates_of(motion.symbols)),
        sets_(motion.graph, rates_),
        hold_(held_values(motion)),
        point_(motion) {}

  bool vanishes(const model::Constraint& constraint) { return generic_rank(point_({gradient(phi(constraint))})) == 0; }

 private:
  static std::vector<ir::SymbolId> rates_of(const kinematics::Symbols& symbols) {
    std::vector<ir::SymbolId> rates;
    for (const auto i : symbols.speeds.indices()) rates.push_back(symbols.rate(symbols.full(i)));
    return rates;
  }

  Expr phi(const model::Constraint& constraint) {
    if (const auto* law = std::get_if<model::VelocityLaw>(&constraint.law)) return motion_.expressions(law->phi);
    return motion_.expressions(model::rate_of(std::get<model::PositionLaw>(constraint.law)));
  }

  strategy::Vector gradient(Expr phi) {
    strategy::Vector row;
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      if (!sets_.depends(phi.id(), i)) {
        row.push_back(motion_.expressions.number(0));
        continue;
      }
      ir::Directional along(motion_.graph);
      along.seed(rates_[i], motion_.expressions.number(1));
      along.skip_others(sets_, i);
      row.push_back(hold_(along(phi)));
    }
    return row;
  }

  ModelGraph& motion_;
  std::vector<ir::SymbolId> rates_;  ///< of free coordinates, and speeds
  ir::SymbolSets sets_;
  ir::Substitution hold_;
  GenericPoint point_;
};

/// Springs with a length whose ends are one place in every configuration: the line of the force has no direction.
class SpringEnds {
 public:
  SpringEnds(ModelGraph& motion, support::Diagnostics& diagnostics)
      : motion_(motion), diagnostics_(diagnostics), hold_(held_values(motion)) {}

  void run() {
    std::vector<const model::Force*> springs;
    strategy::Matrix gaps;
    for (const model::Force& force : motion_.model.forces) {
      const auto* spring = std::get_if<model::Spring>(&force.law);
      if (spring == nullptr || !spring->length) continue;
      springs.push_back(&force);
      gaps.push_back(gap_of(*spring));
    }
    if (gaps.empty()) return;
    const evaluate::Matrix values = GenericPoint(motion_)(gaps);
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const bool is_apart = !cln::zerop(values(i, 0)) || !cln::zerop(values(i, 1)) || !cln::zerop(values(i, 2));
      if (!is_apart) report(*springs[i]);
    }
  }

 private:
  strategy::Vector gap_of(const model::Spring& spring) {
    kinematics::Frames& frames = motion_.expressions.frames();
    const ir::Vector3 first = frames.origin(spring.first);
    const ir::Vector3 second = frames.origin(spring.second);
    strategy::Vector gap;
    for (std::size_t i = 0; i < 3; ++i) gap.push_back(hold_(second[i] - first[i]));
    return gap;
  }

  void report(const model::Force& force) {
    diagnostics_.error(support::code::k_undefined_value, force.name.span,
                       fmt::format("the ends of the spring '{}' are always at the same place, and a force along the "
                                   "line between them has no direction",
                                   force.name.text),
                       "let one end be at another place");
  }

  ModelGraph& motion_;
  support::Diagnostics& diagnostics_;
  ir::Substitution hold_;
};

bool is_slip(const model::Constraint& constraint) { return std::holds_alternative<model::SlipLaw>(constraint.law); }

}  // namespace

void check_early(const model::Model& model, const MechanicsOptions& options, support::Diagnostics& diagnostics) {
  ModelGraph motion(model, options.fold, options.most_nodes, options.limits);
  check_values(motion, diagnostics);
  if (!diagnostics.has_errors()) SpringEnds(motion, diagnostics).run();
  if (diagnostics.has_errors()) return;
  // Rows of rolling come with the motion of bodies; then all are looked at together there, so that all errors are said at once.
  if (std::any_of(model.constraints.begin(), model.constraints.end(), is_slip)) return;
  Gradients gradients(motion);
  for (const model::Constraint& constraint : model.constraints) {
    if (gradients.vanishes(constraint)) report_no_gradient(constraint, diagnostics);
  }
}

}  // namespace gaussgen
