#include "report.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace sphere {

namespace {

bool has_colour() {
  const char* terminal = std::getenv("TERM");
  const bool is_dumb = terminal == nullptr || std::string(terminal) == "dumb";
  return isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr && !is_dumb;
}

std::string styled(const char* code, const std::string& text) {
  return has_colour() ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
}

std::string bold(const std::string& text) { return styled("1", text); }
std::string dim(const std::string& text) { return styled("2", text); }
std::string good(const std::string& text) { return styled("32", text); }
std::string bad(const std::string& text) { return styled("1;31", text); }

void heading(const std::string& text) { std::printf("\n%s\n\n", bold(text).c_str()); }

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

// A zero that was reached exactly deserves to be seen as one.
std::string error_text(double error) { return error > 0 ? format("%.1e", error) : "0"; }

std::string row(const Sample& sample, const std::string& first, const std::string& last) {
  const Motion& m = sample.motion;
  return format("%6s %9.4f %9.4f  %10.4f %9.4f %9.4f  %9.4f %9.4f %9.4f  %s", first.c_str(), m.z, m.z_dot, m.omega[0],
                m.omega[1], m.omega[2], m.reaction[0], m.reaction[1], m.reaction[2], last.c_str());
}

double largest_drift(const Drift& drift) { return std::max(drift.quaternion, drift.velocity); }

void check(const char* what, double value, double bar) {
  const bool is_met = value <= bar;
  std::printf("  %-58s %9s   at most %.0e   %s\n", what, error_text(value).c_str(), bar,
              (is_met ? good("met") : bad("MISSED")).c_str());
}

}  // namespace

void print_introduction(const Data& data, const Plan& plan) {
  std::printf("%s\n\n", bold("A heavy ball rolls inside a vertical cylinder").c_str());
  std::printf(
      "A ball of %g kg and %g m radius rolls without slipping on the inside wall of a fixed upright\n"
      "cylinder of %g m radius. It starts at height 0, runs around the axis at %g rad/s, climbs at %g m/s\n"
      "and spins at %g rad/s about the line to the contact point. Gravity is %g m/s^2, downwards.\n\n",
      data.m, data.r, data.R, data.chi_dot, data.z_dot, data.omega_r, data.g);
  std::printf(
      "gauss-gen has turned two descriptions of this ball into C++, equations of motion and contact forces:\n"
      "  models/sphere_in_cylinder.yaml             attitude by Euler angles\n"
      "  models/sphere_in_cylinder_quaternion.yaml  attitude by a unit quaternion\n"
      "Both were compiled into this program and are now integrated over %g s: Prince-Dormand 8(7), error of a\n"
      "step at most %g of each component's scale, and after each step the state is put back onto\n"
      "the constraints. The solution is known in closed form (Routh), so every figure can be checked.\n",
      plan.duration, plan.tolerance);
}

void print_motion(const Result& euler, const Result& quaternion, const std::vector<Sample>& exact) {
  heading("Motion, and the force of the wall on the ball (quaternion model)");
  std::printf(
      "  time    height     climb     angular velocity [rad/s]        contact force [N]           error\n"
      "   [s]       [m]     [m/s]      radial   tangent     axial     normal   tangent     axial  (*)\n");
  const std::vector<double> scales = scales_of(exact);
  const auto each = std::max<std::size_t>(1, (exact.size() - 1) / 10);
  for (std::size_t k = 0; k < quaternion.run.samples.size(); k += each) {
    const Sample& sample = quaternion.run.samples[k];
    std::printf("%s\n", row(sample, format("%.1f", sample.t), error_text(error_at(sample, exact[k], scales))).c_str());
  }
  std::printf("%s\n\n", dim(row(exact.back(), "exact", "-")).c_str());
  std::printf(
      "(*) largest difference from the closed form, of all outputs, relative to the largest value of each.\n"
      "Radial and normal: along the line to the contact, outwards. Tangent: around the axis. Axial: up.\n");
  for (const Result* result : {&euler, &quaternion}) {
    if (!result->run.trouble.empty())
      std::printf("%s %s\n", bad("A run ended early:").c_str(), result->run.trouble.c_str());
  }
}

void print_errors(const Result& euler, const Result& quaternion, const Bars& bars) {
  heading(format("Largest errors against the closed form, at %zu instants", quaternion.run.samples.size()));
  std::printf("  %-34s %12s %14s\n", "relative to the largest value", "quaternion", "Euler angles");
  for (std::size_t i = 0; i < outputs().size(); ++i) {
    std::printf("  %-34s %12s %14s\n", outputs()[i].name, error_text(quaternion.errors.outputs[i]).c_str(),
                error_text(euler.errors.outputs[i]).c_str());
  }
  std::printf("  %-34s %12s %14s\n", "attitude (angle in rad)", error_text(quaternion.errors.attitude).c_str(),
              error_text(euler.errors.attitude).c_str());
  std::printf("%s\n", dim(format("  %-34s %12.0e %14.0e", "bar", bars.quaternion, bars.euler)).c_str());
  std::printf(
      "\nThe tangential force is zero; its error is relative to the largest contact force. The attitude is\n"
      "compared with the closed-form angular velocity, integrated in long double by Taylor series.\n");
}

void print_effort(const Result& euler, const Result& quaternion) {
  heading("Constraints and cost");
  const auto line = [&](const char* what, const auto& text_of) {
    std::printf("  %-52s %12s %14s\n", what, text_of(quaternion.run).c_str(), text_of(euler.run).c_str());
  };
  std::printf("  %-52s %12s %14s\n", "", "quaternion", "Euler angles");
  line("slip of the constraints before projection [m/s]",
       [](const Run& r) { return error_text(r.before_projection.velocity); });
  line("  after projection [m/s]", [](const Run& r) { return error_text(r.after_projection.velocity); });
  line("norm of the quaternion before projection, less 1", [](const Run& r) {
    return r.before_projection.quaternion > 0 ? error_text(r.before_projection.quaternion) : "-";
  });
  line("  after projection", [](const Run& r) {
    return r.before_projection.quaternion > 0 ? error_text(r.after_projection.quaternion) : "-";
  });
  line("steps accepted", [](const Run& r) { return std::to_string(r.steps); });
  line("steps repeated, as not accurate enough", [](const Run& r) { return std::to_string(r.rejected); });
  line("calls of the right-hand side", [](const Run& r) { return std::to_string(r.calls); });
  line("one right-hand side [ns], median of 101 batches", [](const Run& r) { return format("%.0f", r.nanoseconds); });
  line("  its additions, multiplications",
       [](const Run& r) { return format("%d, %d", r.operations.additions, r.operations.multiplications); });
  line("  its divisions, sines and cosines",
       [](const Run& r) { return format("%d, %d", r.operations.divisions, r.operations.functions); });
  std::printf(
      "\nThe time is that of this machine at this moment; other programs on it make it longer. The operations\n"
      "were counted by running the generated code on a number type that counts.\n");
}

void print_lowest_point(const Result& quaternion, const ClosedForm& exact) {
  heading("The ball does not fall");
  const double weight = exact.data().m * exact.data().g;
  const auto axial = [&](double z) { return exact.data().m * (exact.acceleration_at(z) + exact.data().g); };
  const double highest = exact.mean_height() + exact.amplitude();
  std::printf(
      "Its height swings about %.4f m at %.4f rad/s. The lowest point of the simulation is\n"
      "%.4f m (closed form: %.4f m); from there it climbs back to %.4f m, over and over. Friction\n"
      "along the wall carries it: %.1f N at the top, %.1f N at the bottom, against a weight of %.1f N. The\n"
      "deeper the ball, the faster it spins about the line to the contact; going around the cylinder\n"
      "turns that spin into a roll upwards.\n",
      exact.mean_height(), exact.frequency(), quaternion.run.lowest_height, exact.lowest_height(), highest,
      axial(highest), axial(exact.lowest_height()), weight);
}

void print_slips(const Slips& slips) {
  heading("Three slips in the paper, and how each shows");
  std::printf(
      "1. (3.6) as printed has c = +b^-1 b; it must be a minus. Accelerations by elimination differ from\n"
      "   those with multipliers (3.4) by\n"
      "     %-9s with the printed sign\n     %-9s with the minus\n",
      format("%.1f", slips.elimination.printed).c_str(), error_text(slips.elimination.corrected).c_str());
  const RollingSlip::Variant& printed = slips.rolling.printed;
  const RollingSlip::Variant& corrected = slips.rolling.corrected;
  std::printf(
      "2. The second rolling constraint as printed has a minus before its last term; it must be a plus.\n"
      "   models/as_printed/rolling_along.yaml            as printed       corrected\n"
      "     contact point slips, at the first instant  %10.2f m/s  %10s m/s\n"
      "     and at most, in the first %.1f s            %10.2f m/s  %10s m/s\n"
      "     z'' + Omega^2 z, constant for a harmonic\n"
      "     height, changes in that time by            %10.2f m/s^2%10s m/s^2\n"
      "     simulation comes to                        %10.2f s    %10.2f s\n",
      printed.contact_speed_at_start, error_text(corrected.contact_speed_at_start).c_str(), RollingSlip::k_window,
      printed.contact_speed, error_text(corrected.contact_speed).c_str(), printed.change,
      error_text(corrected.change).c_str(), printed.end, corrected.end);
  if (printed.end < RollingSlip::k_duration) {
    std::printf("   The printed motion runs into the singularity of the Euler angles there.\n");
  }
  std::printf(
      "3. The normal force as printed is R_1 = -m R chi'^2; the centre is R - r from the axis, not R.\n"
      "     %6.3f N   as printed\n     %6.3f N   -m (R - r) chi'^2\n     %6.3f N   the generated code\n",
      slips.reaction.printed, slips.reaction.corrected, slips.reaction.emitted);
}

bool print_verdict(const Result& euler, const Result& quaternion, const Slips& slips, const Bars& bars) {
  heading("Verdict");
  const double drift =
      std::max(largest_drift(euler.run.after_projection), largest_drift(quaternion.run.after_projection));
  check("quaternion: largest relative error", quaternion.errors.largest, bars.quaternion);
  check("Euler angles: largest relative error", euler.errors.largest, bars.euler);
  check("constraint drift after projection", drift, bars.drift);
  const bool ran = euler.run.trouble.empty() && quaternion.run.trouble.empty();
  const bool slips_show = slips.elimination.printed > 1 && slips.elimination.corrected < 1e-12 &&
                          slips.rolling.printed.contact_speed_at_start > 0.1 && slips.rolling.printed.change > 1 &&
                          slips.rolling.corrected.change < 1e-9 &&
                          std::abs(slips.reaction.emitted - slips.reaction.corrected) < 1e-12;
  std::printf("  %-58s %9s                   %s\n", "each slip fails as printed, and holds corrected", "",
              (slips_show ? good("met") : bad("MISSED")).c_str());
  const bool all = ran && slips_show && quaternion.errors.largest <= bars.quaternion &&
                   euler.errors.largest <= bars.euler && drift <= bars.drift;
  std::printf("\n%s\n", all ? good("Generated code and closed form agree.").c_str()
                            : bad("Generated code and closed form do NOT agree to the bars above.").c_str());
  return all;
}

}  // namespace sphere
