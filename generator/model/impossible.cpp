#include "model/impossible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/principal_moments.hpp"
#include "model/turning.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using support::Diagnostic;
using support::Severity;
using support::Span;

namespace {

/// A moment may be negative by what rounding in double does to a zero.
constexpr double k_rounding = 1e-9;
/// Moments may break the triangle inequality by what people cut off when they write three digits.
constexpr double k_written_digits = 1e-3;

class BodyCheck {
 public:
  BodyCheck(const Model& model, const Body& body, const Values& values, std::vector<Diagnostic>& found)
      : model_(model), body_(body), values_(values), found_(found) {}

  void run() {
    const std::size_t before = found_.size();
    refuse_negative(body_.mass, "the mass");
    if (body_.inertia) {
      const std::size_t moments = body_.inertia->shape == Inertia::Shape::isotropic ? 1 : 3;
      for (std::size_t i = 0; i < moments; ++i) refuse_negative(body_.inertia->entries[i], "a moment of inertia");
    }
    if (found_.size() == before && body_.inertia) check_moments();
    if (found_.size() == before) check_presence();
  }

 private:
  void refuse(Span span, std::string message, std::string hint) {
    found_.push_back({Severity::error, code::k_negative_inertia, span, std::move(message), std::move(hint)});
  }

  void refuse_negative(const Ast& ast, const char* what) {
    const auto value = value_of(ast, values_);
    if (!value || !std::isfinite(*value) || !(*value < 0)) return;
    refuse(ast.span, fmt::format("{} of '{}' is negative: {}", what, body_.name.text, *value),
           "check the signs of the parameters in it");
  }

  /// Nothing when part of it is unknown.
  std::optional<Matrix3> matrix() const {
    std::array<double, 6> entries{};
    const std::size_t written = body_.inertia->shape == Inertia::Shape::isotropic  ? 1
                                : body_.inertia->shape == Inertia::Shape::diagonal ? 3
                                                                                   : 6;
    for (std::size_t i = 0; i < written; ++i) {
      const auto value = value_of(body_.inertia->entries[i], values_);
      if (!value || !std::isfinite(*value)) return std::nullopt;
      entries[i] = *value;
    }
    if (written == 1) entries[1] = entries[2] = entries[0];
    const auto& [xx, yy, zz, xy, xz, yz] = entries;
    return Matrix3{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
  }

  void check_moments() {
    const auto inertia = matrix();
    if (!inertia) return;
    const auto J = principal_moments(*inertia);
    const bool is_full = body_.inertia->shape == Inertia::Shape::full;
    const Span span{body_.inertia->entries[0].span.begin, body_.inertia->entries[2].span.end};
    const std::string moments = fmt::format("{:.6g}, {:.6g} and {:.6g}", J[0], J[1], J[2]);
    if (J[0] < -k_rounding * std::max(J[2], -J[0])) {
      refuse(
          span, fmt::format("the inertia of '{}' has a negative principal moment: {}", body_.name.text, moments),
          "products of inertia are too large for the moments; the entry in row x, column y is the integral of -x*y dm");
    } else if (J[2] - J[1] - J[0] > k_written_digits * J[2] && !has_one_moment_in_use()) {
      // The equations hold all the same, so that a textbook example with such numbers can be computed.
      found_.push_back(
          {Severity::warning, code::k_unreal_inertia, span,
           fmt::format("no body has the {}moments of inertia of '{}', {}: the largest exceeds the sum of the others",
                       is_full ? "principal " : "", body_.name.text, moments),
           "for a flat body the largest is their sum; a body that turns about one axis only may have the same moment "
           "three times"});
    }
  }

  void check_presence() {
    const auto mass = value_of(body_.mass, values_);
    if (!mass || *mass != 0) return;
    if (body_.inertia) {
      const auto inertia = matrix();
      if (!inertia || principal_moments(*inertia)[2] != 0) return;
    }
    found_.push_back({Severity::warning, code::k_no_mass, body_.mass.span,
                      fmt::format("'{}' has no {}: it resists no motion and weighs nothing", body_.name.text,
                                  body_.inertia ? "mass and no inertia" : "mass"),
                      "what it alone would move has no acceleration"});
  }

  /// Then the other two moments have no part in any motion, and some body has the one that has: a planar model says [0, 0, J].
  bool has_one_moment_in_use() const {
    return body_.inertia->shape == Inertia::Shape::diagonal && turns_about_one_own_axis(model_, body_.frame);
  }

  const Model& model_;
  const Body& body_;
  const Values& values_;
  std::vector<Diagnostic>& found_;
};

/// Newton's law of impacts, taken literally, would make energy beyond 1.
void check_restitution(const Contact& contact, const Values& values, std::vector<Diagnostic>& found) {
  if (!contact.restitution) return;
  const auto value = value_of(*contact.restitution, values);
  if (!value || !std::isfinite(*value) || (0 <= *value && *value <= 1)) return;
  found.push_back({Severity::error, code::k_impossible_restitution, contact.restitution->span,
                   fmt::format("the restitution of '{}' is {:g}", contact.name.text, *value),
                   "it is the part of the speed that an impact leaves, from 0 to 1"});
}

/// Of a force that opposes: one below 0 would drive, and a strength is compared by its square.
void check_size(const std::string& what, const Ast& size, const Values& values, std::vector<Diagnostic>& found) {
  const auto value = value_of(size, values);
  if (!value || !(*value < 0)) return;
  found.push_back({Severity::error, code::k_impossible_restitution, size.span, fmt::format("{} is below 0", what),
                   "it is the size of a force, whatever its direction: 0 or more"});
}

/// Friction that sticks with less than it slides with would slide, and be held, at once.
void check_static_limit(const DryFriction& friction, const Values& values, std::vector<Diagnostic>& found) {
  if (!friction.static_limit) return;
  const auto sticks = value_of(*friction.static_limit, values), slides = value_of(friction.law.limit, values);
  if (!sticks || !slides || !(*sticks < *slides) || *sticks < 0) return;
  found.push_back(
      {Severity::error, code::k_impossible_restitution, friction.static_limit->span,
       fmt::format("the static limit of '{}' is below its limit", friction.name.text),
       "friction that sticks holds at least what it takes while it slides; leave it out where both are the same"});
}

/// While contacts press.
Values with_reactions(const Model& model, Values values) {
  for (const Contact& contact : model.contacts) values[contact.name.text + ".reaction"] = 1;
  return values;
}

void check_sizes(const Model& model, const Values& given, std::vector<Diagnostic>& found) {
  const Values values = with_reactions(model, given);
  for (const DryFriction& friction : model.frictions) {
    check_size(fmt::format("the limit of '{}'", friction.name.text), friction.law.limit, values, found);
    if (friction.static_limit)
      check_size(fmt::format("the static limit of '{}'", friction.name.text), *friction.static_limit, values, found);
    check_static_limit(friction, values, found);
  }
  for (const Constraint& row : model.constraints) {
    if (row.breaks_at) check_size(fmt::format("the strength of '{}'", row.name.text), *row.breaks_at, values, found);
  }
}

}  // namespace

std::vector<Diagnostic> impossible_bodies(const Model& model, const Values& values) {
  std::vector<Diagnostic> found;
  for (const Contact& contact : model.contacts) check_restitution(contact, values, found);
  check_sizes(model, values, found);
  for (const Body& body : model.bodies) BodyCheck(model, body, values, found).run();
  return found;
}

std::vector<Diagnostic> impossible_bodies(const Model& model) {
  return impossible_bodies(model, parameter_values(model));
}

}  // namespace gaussgen::model
