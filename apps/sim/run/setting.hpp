#pragma once
// What a run does where nobody says anything.

#include <string>

#include "sim/run/simulate.hpp"

namespace gausssim {

constexpr double k_default_tolerance = 1e-9;
constexpr double k_default_steps = 10'000;  ///< of one length, in a run
constexpr const char* k_method_of_any_model = "prince87";
constexpr const char* k_relative =
    "bulirsch_stoer";  ///< beside that. (Not Fehlberg's pair of order 8: its estimate of errors takes forces at both ends of a step alone, so it does not see one that jumps between.)
constexpr const char* k_method_of_edges = "dopri5";  ///< beside that: of forces that jump

/// Of runs that others are compared with [s].
struct LongestSteps {
  double fine;
  double other;  ///< of another run, since a step of one may end where something acts
};

/// No longer than the scene has them. Shorter where a force jumps, since what acts for a short time has edges: as many steps as compiled rates are called for in some hundredths of a second.
/// `lengthened`: times as long, where the scene allows it.
LongestSteps longest_steps(const PreparedModel& prepared, double lengthened = 1);

/// Series where the model has them.
std::string default_method(const PreparedModel& prepared, const Engine& engine, const std::string& number);

Projection default_projection(const std::string& method);

/// The number type that the scene names, else double.
const std::string& number_name(const Scene& scene);

/// As the scene says; what it does not say is the default.
Setting setting_of(const PreparedModel& prepared, const Engine& engine);

/// Of a scene that says nothing. Series that are too large to be a default are none.
Setting default_setting(const PreparedModel& prepared, const Engine& engine);

/// Of the same accuracy with errors of other terms: another order, or another pair. The same where there is none. Where forces jump, pairs whose estimate of the error sees that: extrapolation and Fehlberg's pair of order 8 may step over it without a word, and others
/// agree with a tighter run of their own for the wrong reason.
Setting by_other_terms(const Setting& setting, const PreparedModel& prepared);

/// Whether a method is made for a number type, as scenes call it.
bool computes_in(const MethodInfo& method, const std::string& number);

/// The smallest tolerance that means anything in a number type.
double least_tolerance(const std::string& number);

/// From 1 to the next larger number.
double rounding_unit(const std::string& number);

/// Whether times near `t` are so far apart that steps which are short beside the time between rows are no more than a few of these.
bool are_times_coarse(const std::string& number, double t, const Span& span);

}  // namespace gausssim
