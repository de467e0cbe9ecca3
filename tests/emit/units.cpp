#include "units.hpp"

#include <cln/integer.h>
#include <cln/integer_io.h>

#include "unit_builder.hpp"

namespace gausstest {

using namespace gaussgen;
using emit::Artefact;
using emit::Target;

namespace {

Expr sine(Expr x) { return ir::call(Function::sin, x); }
Expr cosine(Expr x) { return ir::call(Function::cos, x); }
Rational ratio(int top, int bottom) { return Rational(top) / bottom; }

}  // namespace

Sample pendulum() {
  Sample sample;
  sample.unit.model_name = "pendulum";
  sample.unit.about = "Planar pendulum with a motor in its joint";
  sample.unit.name_space = "gauss::pendulum";
  UnitBuilder build(sample);
  const Expr m = build.parameter("m", ratio(3, 2), "kg", "mass of the bob");
  const Expr l = build.parameter("l", ratio(7, 10), "m", "length of the rod");
  const Expr g = build.parameter("g", ratio(981, 100), "m/s^2", "acceleration of gravity");
  const Expr torque = build.input("torque", 0, "N m", "of the motor in the joint");
  const auto [theta, theta_dot] = build.coordinate("theta", "rad", "angle from the vertical");

  const Expr inertia = m * pow(l, 2);
  const Expr moment = torque - m * g * l * sine(theta);
  const Expr theta_ddot = moment / inertia;
  const Expr tension = m * l * pow(theta_dot, 2) + m * g * cosine(theta);
  const Expr kinetic = ratio(1, 2) * inertia * pow(theta_dot, 2);
  const Expr potential = -(m * g * l * cosine(theta));

  Artefact& rhs = build.artefact("rhs", "Accelerations of the unconstrained coordinates.");
  rhs.target = Target::derivative;
  rhs.derivative = {theta_dot.id(), theta_ddot.id()};
  build.section(rhs, "Generalized force Q_theta, model line 12", {{moment, "Q_theta"}});
  rhs.status.not_finite = build.not_finite({theta_ddot});

  Artefact& both = build.artefact("rhs_and_reactions", "Both over one set of shared terms.");
  both.derivative = rhs.derivative;
  both.result_type = "Reactions";
  both.groups = {{"rod", "Rod", "the rod", {build.field("tension", "[N] pulls the bob to the joint", {tension})}}};
  both.status = rhs.status;

  Artefact& reactions = build.artefact("reactions", "What the rod has to bear.");
  reactions.result_type = "Reactions";
  const Expr zero = build.number(0);
  reactions.groups = {
      {"rod",
       "Rod",
       "the rod",
       {build.field("tension", "[N] pulls the bob to the joint", {tension}),
        build.field("force", "[N] on the bob, in space", {-(tension * sine(theta)), zero, tension * cosine(theta)}, {3})}}};

  Artefact& energy = build.artefact("energy", "Energy of the bob.");
  energy.result_type = "Energy";
  energy.groups = {{"",
                    "",
                    "",
                    {build.field("kinetic", "[J]", {kinetic}), build.field("potential", "[J] zero at the joint", {potential}),
                     build.field("total", "[J]", {kinetic + potential})}}};

  Artefact& initial = build.artefact("initial_state", "The state at t = 0.");
  initial.takes_time = initial.takes_state = initial.takes_inputs = false;
  initial.target = Target::state;
  initial.state = {build.number(ratio(3, 10)).id(), pow(g / l, ratio(1, 2)).id()};

  Artefact& residual = build.artefact("residual", "Equation of motion for a given acceleration.");
  residual.takes_accelerations = true;
  residual.result_type = "Residual";
  residual.groups = {{"", "", "", {build.field("moment", "[N m]", {inertia * build.acceleration(0) - moment})}}};
  return sample;
}

Sample springs() {
  Sample sample;
  sample.unit.model_name = "springs";
  sample.unit.about = "Two masses on a line, the second spring hardens with the cube of its extension";
  sample.unit.name_space = "gauss::springs";
  UnitBuilder build(sample);
  const Expr m1 = build.parameter("m1", 2, "kg", "");
  const Expr m2 = build.parameter("m2", ratio(1, 3), "kg", "");
  const Expr k = build.parameter("k", 40, "N/m", "stiffness of both springs");
  const Expr a = build.parameter("a", ratio(1, 2), "m", "extension at which the cubic part equals the linear one");
  const Expr k3 = build.formula("k3", k / pow(a, 2), "N/m^3");
  const Expr total = build.formula("total_mass", m1 + m2, "kg");
  const auto [x, x_dot] = build.coordinate("x", "m", "");
  const auto [y, y_dot] = build.coordinate("y", "m", "");

  const Expr stretch = (y - x).named("stretch");
  const Expr force = (k * stretch + k3 * pow(stretch, 3)).named("force");
  const Expr x_ddot = (force - k * x) / m1;
  const Expr y_ddot = -force / m2;
  Artefact& rhs = build.artefact("rhs", "Accelerations of both masses.");
  rhs.target = Target::derivative;
  rhs.derivative = {x_dot.id(), y_dot.id(), x_ddot.id(), y_ddot.id()};
  build.section(rhs, "The cubic spring", {{stretch, "stretch"}, {force, "force"}});
  const Expr bound = 16 * build.epsilon() * total;
  rhs.status.singular_mass_matrix = sample.graph.call(Function::less, {m2.id(), bound.id()});
  rhs.status.not_finite = build.not_finite({x_ddot, y_ddot});

  Artefact& energy = build.artefact("energy", "");
  energy.result_type = "Energy";
  const Expr kinetic = ratio(1, 2) * (m1 * pow(x_dot, 2) + m2 * pow(y_dot, 2));
  const Expr potential = ratio(1, 2) * k * pow(x, 2) + ratio(1, 2) * k * pow(stretch, 2) + ratio(1, 4) * k3 * pow(stretch, 4);
  energy.groups = {{"", "", "", {build.field("kinetic", "[J]", {kinetic}), build.field("potential", "[J]", {potential})}}};

  Artefact& mean = build.artefact("centre", "Centre of mass and the mass matrix.");
  mean.result_type = "Centre";
  const Expr centre = (m1 * x + m2 * y) / total;
  mean.groups = {{"", "", "", {build.field("position", "[m]", {centre}),
                               build.field("M", "[kg]", {m1, build.number(0), build.number(0), m2}, {2, 2})}}};

  Artefact& project = build.artefact("project", "Moves the state to x + y = 0 and its rate.");
  project.target = Target::state;
  const Expr half = ratio(1, 2) * (x - y);
  const Expr half_dot = ratio(1, 2) * (x_dot - y_dot);
  project.state = {half.id(), (-half).id(), half_dot.id(), (-half_dot).id()};
  return sample;
}

Sample nasty() {
  Sample sample;
  sample.unit.model_name = "linux";
  sample.unit.about = "ends with */ #error \\";
  sample.unit.name_space = "gauss::linux";
  UnitBuilder build(sample);
  const std::string line_break = "first\n#error second\\\nint x = \"\xE2\x80\xAE; ?\?/";
  const Expr I = build.parameter("I", 2, "kg m^2 */", line_break);
  const Expr s = build.parameter("s", 3, "", "*/ #error \\");
  const Expr S = build.parameter("S", 5, "", "the name of the scalar type");
  const Expr rhs_ = build.parameter("rhs", 7, "", "the name of a function");
  const Expr t1 = build.parameter("t1", 11, "", "the name of a temporary");
  const Expr values = build.parameter("values", 13, "", "\xFF\xFE not UTF-8");
  const Expr eof = build.parameter("EOF", 17, "", "");
  const Expr n_q = build.parameter("n_q", 19, "", "");
  const Expr gamma = build.parameter("gamma", 23, "", "");
  const Expr y0 = build.parameter("y0", 29, "", "");
  const Expr state = build.input("state", 31, "", "");
  const Expr out = build.input("prepared", 37, "", "");
  const auto [y, y_dot] = build.coordinate("y", "m", "µ, ünïcödé stays");
  const auto [fresh, fresh_dot] = build.coordinate("new", "", "");
  const auto [major, major_dot] = build.coordinate("major", "", "");
  const auto [sine_y, sine_y_dot] = build.coordinate("sin_y", "", "the natural name of sin(y)");

  const Expr product = I * s * S * rhs_ * t1;
  const Expr shared = fresh * major + values * state;
  Artefact& rhs = build.artefact("rhs", "*/ #error \\\nsecond line \\");
  rhs.target = Target::derivative;
  const Expr y_ddot = product * y + sine(y) * sine(shared) + pow(sine(y), 2);
  const Expr fresh_ddot = eof * n_q + gamma * shared * shared + pow(shared, 3) * y0 + cosine(y) * out;
  rhs.derivative = {y_dot.id(),      fresh_dot.id(), major_dot.id(), sine_y_dot.id(),
                    y_ddot.id(), fresh_ddot.id(), (sine_y * build.time()).id(), (major * fresh).id()};
  build.section(rhs, "*/ a comment with\na second line \\", {{shared, "t2"}, {pow(shared, 2), "values"}});

  Artefact& outputs = build.artefact("outputs", "");
  outputs.result_type = "Outputs";
  outputs.groups = {{"new", "New", "*/ \\", {build.field("S", "\\", {shared}), build.field("New", "", {y})}},
                    {"Delete", "Delete", "", {build.field("outputs", "", {shared}), build.field("int", "", {y, y}, {2})}}};
  sample.unit.constraints = {{"\"quoted\" \\", "tab\there, ?\?/ trigraph, \xFF byte"}};
  sample.unit.held = {{"held", "m\n#error", "*/", "R - r \\"}};
  return sample;
}

Sample namesakes() {
  Sample sample;
  sample.unit.model_name = "namesakes";
  sample.unit.name_space = "gauss::namesakes";
  UnitBuilder build(sample);
  const Expr m = build.parameter("m", 2, "kg", "");
  const Expr J = build.parameter("J", 3, "kg*m^2", "");
  const Expr r = build.parameter("r", ratio(1, 2), "m", "");
  const auto [x, x_dot] = build.coordinate("x", "m", "");

  // Of two functions, each of which calls another thing K.
  const Expr partial = (pow(r, 2) / J).named("K");
  const Expr whole = pow(m, -1) + pow(r, 2) / J;
  Artefact& initial = build.artefact("initial_state", "");
  initial.takes_time = initial.takes_state = initial.takes_inputs = false;
  initial.target = Target::state;
  build.section(initial, "", {{partial, "K"}});
  initial.state = {(m + partial).id(), (r + partial).id()};
  initial.status.not_finite = build.not_finite({m + partial, r + partial});

  Artefact& project = build.artefact("project", "");
  project.target = Target::state;
  build.section(project, "", {{whole, "K"}});
  project.state = {(x * whole).id(), (x_dot / whole).id()};
  project.status.not_finite = build.not_finite({x * whole, x_dot / whole});

  // One function that wants one name twice: the second gets the name that its own formula suggests.
  Artefact& energy = build.artefact("energy", "");
  energy.result_type = "Energy";
  const Expr first = x + pow(x_dot, 3);
  const Expr second = x * x_dot;
  build.section(energy, "", {{first, "pivot"}, {second, "pivot"}});
  energy.groups = {
      {"",
       "",
       "",
       {build.field("kinetic", "", {first * second}), build.field("potential", "", {first + sine(second)})}}};
  return sample;
}

Sample zoo() {
  Sample sample;
  sample.unit.model_name = "zoo";
  sample.unit.name_space = "models::zoo";
  UnitBuilder build(sample);
  const Expr p = build.parameter("p", ratio(1, 10), "", "");
  const Expr pi(sample.graph, sample.graph.use(sample.graph.declare(SymbolClass::pi, "pi")));
  const auto [x, x_dot] = build.coordinate("x", "", "");
  const auto f = [&](Function function) { return ir::call(function, ratio(1, 2) * x); };

  Artefact& functions = build.artefact("functions", "All functions at x/2.");
  functions.result_type = "Functions";
  const Expr atan2(sample.graph, sample.graph.call(Function::atan2, {x.id(), x_dot.id()}));
  functions.groups = {{"", "", "", {
      build.field("value", "", {f(Function::sin), f(Function::cos), f(Function::tan), f(Function::asin), f(Function::acos),
                                f(Function::atan), f(Function::exp), f(Function::log), f(Function::sinh), f(Function::cosh),
                                f(Function::tanh), atan2}, {12})}}};

  Artefact& powers = build.artefact("powers", "");
  powers.result_type = "Powers";
  const std::vector<Rational> exponents = {2, 3, 4, 5, 7, -1, -2, -3, ratio(1, 2), ratio(3, 2), ratio(5, 2), ratio(-1, 2),
                                           ratio(-3, 2), ratio(1, 3), ratio(-2, 3)};
  std::vector<Expr> values;
  for (const Rational& exponent : exponents) values.push_back(pow(x, exponent));
  const Expr y = x_dot;
  powers.groups = {{"", "", "", {build.field("of_x", "", values, {15}),
                                 build.field("fraction", "", {x / (y * pow(1 * p + y, 2))}),
                                 build.field("reciprocal", "", {ratio(2, 5) * pow(y, -3)})}}};

  Artefact& sums = build.artefact("sums", "");
  sums.result_type = "Sums";
  const Expr one = build.number(1);
  sums.groups = {{"", "", "", {build.field("value", "", {y - x, -x - y, ratio(1, 3) * x - ratio(1, 3) * y, one - x, -one - 2 * x,
                                                       ratio(2, 5) * x, -(x * y), x - (y - one) * (x - p), pi * x + x * sine(pi * p)}, {9})}}};

  Artefact& numbers = build.artefact("numbers", "Constants that double cannot hold.");
  numbers.result_type = "Numbers";
  const Rational huge = cln::expt_pos(cln::cl_I(10), 30) + 1;
  const Rational tiny = 1 / huge;
  const cln::cl_I digits = "3141592653589793238462643383279502884197169399375105820974944";  // π
  const Rational long_decimal = Rational(digits) / cln::expt_pos(cln::cl_I(10), 60);
  numbers.groups = {{"", "", "", {build.field("value", "", {build.number(ratio(1, 10)), build.number(huge), build.number(tiny),
                                                           build.number(long_decimal), build.number(ratio(-3, 8)),
                                                           build.number(cln::expt_pos(cln::cl_I(10), 12))}, {6})}}};

  Artefact& conditions = build.artefact("conditions", "");
  conditions.result_type = "Conditions";
  ir::Graph& graph = sample.graph;
  const ir::NodeId x_is_less = graph.call(Function::less, {x.id(), y.id()});
  const ir::NodeId p_is_less = graph.call(Function::less, {p.id(), x.id()});
  const Expr smaller(graph, graph.call(Function::select, {x_is_less, x.id(), y.id()}));
  const Expr chosen(graph, graph.call(Function::select, {graph.call(Function::any, {x_is_less, p_is_less, graph.constant(0)}),
                                                         (x * y).id(), graph.constant(-1)}));
  conditions.groups = {{"", "", "", {build.field("smaller", "", {smaller}), build.field("chosen", "", {chosen})}}};
  conditions.status = {x_is_less, p_is_less, build.not_finite({x, y}), graph.constant(0)};
  return sample;
}

const std::vector<std::string>& sample_names() {
  static const std::vector<std::string> names = {"pendulum", "springs", "nasty", "namesakes", "zoo"};
  return names;
}

Sample sample(const std::string& name) {
  if (name == "pendulum") return pendulum();
  if (name == "springs") return springs();
  if (name == "namesakes") return namesakes();
  if (name == "nasty") return nasty();
  return zoo();
}

}  // namespace gausstest
