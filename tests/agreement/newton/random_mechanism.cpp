#include "newton/random_mechanism.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace agreement::newton {

namespace {

class Mechanism {
 public:
  explicit Mechanism(unsigned seed, bool is_extreme = false) : random_(seed), is_extreme_(is_extreme) {
    if (!is_extreme_) return;
    if (chance(0.3)) length_ = std::pow(10.0, uniform(-6, 6));
    if (chance(0.3)) mass_ = std::pow(10.0, uniform(-6, 6));
    has_mass_ratios_ = chance(0.4);
    has_stiff_springs_ = chance(0.2);
  }

  std::string text() {
    // Few of many bodies: their expressions take a second each.
    const int bodies = 2 + static_cast<int>(std::min({random_() % 7, random_() % 7, random_() % 7}));
    for (int i = 1; i <= bodies; ++i) add_joint("b" + std::to_string(i), i);
    for (const std::string& frame : links_) {
      // Parts without mass between others: what acts on them goes through their joints.
      const bool is_parent = joints_.find("parent: " + frame + ",") != std::string::npos;
      if (!is_parent || !chance(0.15)) add_bodies(frame);
    }
    for (int i = 1; i <= 4; ++i)
      points_ += entry("p" + std::to_string(i), "on: " + pick(links_) + ", at: " + place_in(0.4));
    add_speeds();
    add_forces();
    if (is_extreme_) {
      add_constraints();
    } else if (chance(0.6)) {
      add_constraint("");
    }
    const std::string k = has_stiff_springs_ ? "3.5e+9" : "3.5";
    return "gauss: 1\nname: m\nparameters: {k: " + k + ", c: 0.7, L: " + number(0.9 * length_) +
           "}\ninputs: {f: 1.3}\n" + section("coordinates", coordinates_) + section("speeds", speeds_) +
           "frames:\n  ground: {position: [0.3, -0.2, 0.5]}\n" + frames_ + section("joints", joints_) +
           section("points", points_) + section("bodies", bodies_) + section("particles", particles_) +
           section("constraints", constraints_) + section("forces", forces_);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double p) { return uniform(0, 1) < p; }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[random_() % from.size()];
  }

  std::string number(double x) const {
    char text[32];
    std::snprintf(text, sizeof text, is_extreme_ ? "%.6e" : "%.4f", x);
    return text;
  }
  std::string vector(double size) {
    return "[" + number(uniform(-size, size)) + ", " + number(uniform(-size, size)) + ", " +
           number(uniform(-size, size)) + "]";
  }
  std::string place_in(double size) { return vector(size * length_); }
  std::string axis() { return chance(0.5) ? pick<std::string>({"x", "y", "z"}) : vector(1); }

  static std::string entry(const std::string& name, const std::string& fields) {
    return "  " + name + ": {" + fields + "}\n";
  }
  static std::string section(const std::string& name, const std::string& entries) {
    return entries.empty() ? "" : name + ":\n" + entries;
  }

  /// Over everything that a force may depend on.
  std::string expression() {
    const std::string a = chance(0.5) && !names_.empty() ? pick(names_) : "t";
    const std::string b = !names_.empty() && chance(0.7) ? "dot(" + pick(names_) + ")" : "f";
    return pick<std::string>({number(uniform(-3, 3)), "2*sin(" + a + ") - 0.3*" + b, "f*cos(t) + " + a + "*" + b + "/5",
                              "c*" + b + " + exp(-t/4)"});
  }
  std::string expressions() { return "[" + expression() + ", " + expression() + ", " + expression() + "]"; }

  std::string law_in_time() { return number(uniform(-1, 1)) + " + 0.3*sin(" + number(uniform(0.5, 2)) + "*t)"; }

  /// A free coordinate for a joint, declared or not, or one that is held.
  std::string coordinate(const std::string& name, bool may_be_held) {
    if (may_be_held && chance(0.15)) {
      coordinates_ += entry(name, "held_at: " + law_in_time());
      return name;
    }
    if (chance(0.4)) {
      coordinates_ += entry(name, "initial: " + number(uniform(-0.5, 0.5)));
      declared_.push_back(name);
    }
    names_.push_back(name);
    return name;
  }

  void add_joint(const std::string& child, int i) {
    const std::string name = "j" + std::to_string(i);
    std::string parent;
    if (links_.empty() || chance(0.2)) {
      parent = chance(0.3) ? add_mover(i) : "ground";
    } else {
      parent = chance(0.5) ? links_.back() : pick(links_);
    }
    static const std::vector<std::string> k_types{"revolute",  "revolute", "prismatic", "cylindrical",
                                                  "universal", "planar",   "spherical", "fixed"};
    const std::string type = chance(0.06) ? "free" : pick(k_types);
    std::string fields = "type: " + type + ", parent: " + parent + ", child: " + child;
    if (chance(0.8)) fields += ", at: " + place_in(0.6);
    joints_ += entry(name, fields + freedoms(name, type));
    links_.push_back(child);
    if (type == "revolute" || type == "prismatic" || type == "cylindrical" || type == "fixed")
      slender_.push_back(child);
  }

  std::string freedoms(const std::string& name, const std::string& type) {
    if (type == "fixed") return ", orientation: {axis: " + axis() + ", angle: " + number(uniform(-2, 2)) + "}";
    std::string fields;
    const std::size_t count = type == "revolute" || type == "prismatic"      ? 1
                              : type == "cylindrical" || type == "universal" ? 2
                                                                             : 3;
    if (type == "planar") {
      fields = ", axis: " + pick<std::string>({"x", "y", "z"});
    } else if (count < 3) {
      fields = type == "universal" ? ", axes: [" + axis() + ", " + axis() + "]" : ", axis: " + axis();
    }
    if (type == "spherical" || type == "free") {
      for (const char c : {'x', 'y', 'z'}) turns_.push_back(name + "_w" + c);
      if (type == "spherical") return fields;
    }
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
      list += (i == 0 ? "" : ", ") + coordinate("q_" + name + "_" + std::to_string(i), type != "free");
    }
    return fields + ", coordinates: [" + list + "]";
  }

  /// A frame that time moves: a swinging table.
  std::string add_mover(int i) {
    const std::string name = "mover" + std::to_string(i);
    frames_ += entry(name, "parent: ground, position: [0.2*sin(t), 0, " + law_in_time() +
                               "], orientation: {euler: zxy, angles: [0.4*t, " + law_in_time() + ", 0]}");
    return name;
  }

  /// Up to 1e12 apart within a mechanism.
  double any_mass() { return has_mass_ratios_ ? mass_ * std::pow(10.0, uniform(-6, 6)) : mass_; }

  /// Inertia of four masses somewhere, so that it is one that a body can have.
  std::string inertia(double mass) {
    Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d r(uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-0.4, 0.4));
      I += mass * length_ * length_ * uniform(0.5, 1.5) *
           (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    if (chance(0.15)) return number(I(0, 0) + 0.01 * mass * length_ * length_);
    std::string rows;
    for (Eigen::Index i = 0; i < 3; ++i) {
      rows += (i == 0 ? "[" : ", [") + number(I(std::min<Eigen::Index>(i, 0), std::max<Eigen::Index>(i, 0)));
      for (Eigen::Index j = 1; j < 3; ++j) rows += ", " + number(I(std::min(i, j), std::max(i, j)));
      rows += "]";
    }
    return "[" + rows + "]";
  }

  /// A particle alone, beside which loads press on the joints of its light part, where it has inertia against all that moves it.
  void add_bodies(const std::string& frame) {
    if (has_one_turn_at_most(frame) && chance(0.25)) return add_load(frame);
    const double mass = any_mass();
    if (chance(0.15)) return add_ball(frame, mass);
    bodies_ += entry(frame, "mass: " + number(mass * uniform(0.5, 3)) + ", centre: " + place_in(0.3) +
                                ", inertia: " + inertia(mass));
    if (chance(0.2)) add_load(frame);
  }

  /// The same in all directions: its link has axes that need not turn with it.
  void add_ball(const std::string& frame, double mass) {
    bodies_ += entry(frame, "mass: " + number(mass * uniform(0.5, 3)) +
                                ", inertia: " + number(mass * length_ * length_ * uniform(0.01, 0.5)));
  }

  void add_load(const std::string& frame) {
    particles_ += entry("load_" + frame, "mass: " + number(any_mass() * uniform(0.2, 1)) + ", frame: " + frame +
                                             ", centre: " + place_in(0.5));
  }

  bool has_one_turn_at_most(const std::string& frame) const {
    return std::find(slender_.begin(), slender_.end(), frame) != slender_.end();
  }

  // Two speeds for the rates of two declared coordinates, or none.
  void add_speeds() {
    if (declared_.size() < 2 || !chance(0.3)) return;
    const std::string a = declared_[0];
    const std::string b = declared_[1];
    speeds_ += entry("v1", "is: 2*dot(" + a + ") + sin(" + a + ")*dot(" + b + ") + 0.2*cos(t)");
    speeds_ += entry("v2", "is: dot(" + b + ") - 0.4*cos(" + b + ")*dot(" + a + ")");
    turns_.push_back("v1");
  }

  std::string place() { return pick<std::string>({"p1", "p2", "p3", "p4", "ground"}); }
  std::string other(const std::string& place) {
    std::string result = place;
    while (result == place) result = this->place();
    return result;
  }

  void add_forces() {
    forces_ += entry("gravity", "uniform: [0.3*sin(t), 0, -9.81]");
    const int count = static_cast<int>(random_() % 6);
    for (int i = 1; i <= count; ++i) forces_ += entry("force" + std::to_string(i), force());
  }

  std::string force() {
    const std::string p = place();
    const std::string from = chance(0.5) ? ", from: " + pick(links_) : "";
    const std::string in = chance(0.5) ? ", in: " + pick(links_) : "";
    switch (random_() % 7) {
      case 0: return "force: " + expressions() + ", on: " + pick(links_) + ", at: " + place_in(0.5) + in + from;
      case 1: return "torque: " + expressions() + ", on: " + pick(links_) + in + from;
      case 2:
        return "spring: [" + p + ", " + other(p) + "], stiffness: k + 0.2*sin(t), length: L + 0.1*cos(t), damping: c";
      case 3: return "spring: [" + p + ", " + other(p) + "], stiffness: k, damping: c/2";
      case 4:
        if (!names_.empty()) return "spring: " + pick(names_) + ", stiffness: k + 0.1*t, rest: 0.3*sin(t), damping: c";
        break;
      case 5:
        if (!names_.empty()) return "potential: k*sin(" + pick(names_) + " + t)*" + pick(names_) + "/2";
        break;
      default: break;
    }
    std::vector<std::string> along = names_;
    along.insert(along.end(), turns_.begin(), turns_.end());
    if (along.empty()) return "force: " + expressions() + ", on: " + pick(links_);
    return "generalized: {" + pick(along) + ": " + expression() + "}";
  }

  /// One to three, and such as say nothing of their own: given twice, the other way round, as a multiple, or nearly so.
  void add_constraints() {
    const int count = static_cast<int>(random_() % 4);
    for (int i = 0; i < count; ++i) {
      const auto [name, law] = add_constraint(std::to_string(i));
      if (!name.empty() && chance(0.3)) constraints_ += entry(name + "_again", law);
    }
    if (names_.size() > 1 && chance(0.25)) add_nearly_parallel();
  }

  void add_nearly_parallel() {
    const std::string a = "dot(" + names_[0] + ")", b = "dot(" + names_[1] + ")*cos(t)";
    constraints_ += entry("pair", "velocity: " + a + " + 2*" + b + " - dot(p1.x)/7 - 0.1*t");
    const double off = std::pow(10.0, uniform(-12, -1));
    constraints_ += entry("twin", "velocity: 3*" + a + " + 6*" + b + " + " + number(off) + "*dot(" + names_[1] +
                                      ") - 3*dot(p1.x)/7 - 0.3*t");
  }

  /// Returns its name and its law in words, maybe in other ones than it was given in.
  std::pair<std::string, std::string> add_constraint(const std::string& number) {
    const std::string a = pick(links_);
    const std::string b = chance(0.5) ? "ground" : pick(links_);
    const std::string p = place();
    const std::string on = a == b ? "" : ", on: " + b;
    switch (random_() % 7) {
      case 0: {
        const std::string q = other(p);
        return given("loop" + number, "coincide: [" + p + ", " + q + "]", "coincide: [" + q + ", " + p + "]");
      }
      case 1: {
        const std::string q = other(p);
        return given("rod" + number, "distance: [" + p + ", " + q + "], is: L + 0.1*sin(t)",
                     "distance: [" + q + ", " + p + "], is: L + 0.1*sin(t)");
      }
      case 2:
        if (p != "ground" && chance(0.3)) {
          const std::string of = p + "." + pick<std::string>({"x", "y", "z"});
          return given("lead" + number, "equation: " + of + " - 0.2*sin(2*t) - 0.1*t^2",
                       "equation: 0.4*sin(2*t) + 0.2*t^2 - 2*" + of);
        }
        return given("track" + number, "equation: p1.z - 0.3*p1.x*p2.y - 0.2*sin(t)",
                     "equation: 0.6*p1.x*p2.y + 0.4*sin(t) - 2*p1.z");
      case 3: return given("contact" + number, "rolls: " + a + on + ", at: [p1.x, p1.y + 0.1, 0]");
      case 4:
        return given("blade" + number, "no_slip: " + a + on + ", at: p2, direction: " + axis() +
                                           ", in: " + (chance(0.5) ? a : pick(links_)));
      case 5: {
        const std::string law = "dot(p1.x)*cos(t) - dot(p2.y)*p1.z + 0.3";
        return given("chase" + number, "velocity: " + law, "velocity: (" + law + ")*(2 + sin(t))");
      }
      default:
        if (names_.size() < 2) return {};
        return given("gear" + number,
                     "velocity: dot(" + names_[0] + ")^2 - dot(" + names_[1] + ")*(2 + sin(t)) + dot(p3.z)/3");
    }
  }

  std::pair<std::string, std::string> given(const std::string& name, const std::string& law,
                                            const std::string& in_other_words = "") {
    constraints_ += entry(name, law);
    return {name, in_other_words.empty() ? law : in_other_words};
  }

  std::mt19937 random_;
  bool is_extreme_ = false;
  double length_ = 1, mass_ = 1;  ///< of all
  bool has_mass_ratios_ = false, has_stiff_springs_ = false;
  std::vector<std::string> links_;     ///< children of joints
  std::vector<std::string> slender_;   ///< of them, those with joints that let them turn about one axis or none
  std::vector<std::string> names_;     ///< free coordinates
  std::vector<std::string> declared_;  ///< of them, by the model itself
  std::vector<std::string> turns_;     ///< angular velocities and speeds
  std::string coordinates_, speeds_, frames_, joints_, points_, bodies_, particles_, constraints_, forces_;
};

}  // namespace

std::string random_mechanism(unsigned seed) { return Mechanism(seed).text(); }

std::string extreme_mechanism(unsigned seed) { return Mechanism(seed, true).text(); }

}  // namespace agreement::newton
