#pragma once
// What the demo says, on at most 100 columns.

#include "comparison.hpp"
#include "slips.hpp"

namespace sphere {

/// The figures to reach.
struct Bars {
  double quaternion = 1e-9;  // largest relative error
  double euler = 1e-7;
  double drift = 1e-12;  // after projection
};

struct Result {
  Run run;
  Errors errors;
};

struct Slips {
  EliminationSlip elimination;
  RollingSlip rolling;
  ReactionSlip reaction;
};

void print_introduction(const Data& data, const Plan& plan);
void print_motion(const Result& euler, const Result& quaternion, const std::vector<Sample>& exact);
void print_errors(const Result& euler, const Result& quaternion, const Bars& bars);
void print_effort(const Result& euler, const Result& quaternion);
void print_lowest_point(const Result& quaternion, const ClosedForm& exact);
void print_slips(const Slips& slips);

/// True if every bar is met.
bool print_verdict(const Result& euler, const Result& quaternion, const Slips& slips, const Bars& bars);

}  // namespace sphere
