#pragma once
// Units built by hand, with formulas that are known in closed form: the emitter knows no mechanics, nor do these tests.

#include <string>
#include <vector>

#include "emit/unit.hpp"

namespace gausstest {

/// A Unit with the graph its nodes live in.
struct Sample {
  gaussgen::ir::Graph graph;
  gaussgen::emit::Unit unit;
};

/// m l^2 theta'' = -m g l sin(theta) + torque, with energy and the tension of the rod.
Sample pendulum();

/// Two masses, two springs, one of them cubic: powers, shared terms, a formula parameter, a projection.
Sample springs();

/// Names and texts that would break a careless emitter.
Sample nasty();

/// Two functions that give the same names to other things, and terms of the one inside of the other.
Sample namesakes();

/// Every function, condition and kind of number.
Sample zoo();

const std::vector<std::string>& sample_names();
Sample sample(const std::string& name);

}  // namespace gausstest
