#include "newton/random_mechanism.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

namespace agreement::newton {

namespace {

class Mechanism {
 public:
  explicit Mechanism(unsigned seed) : random_(seed) {}

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
      points_ += entry("p" + std::to_string(i), "on: " + pick(links_) + ", at: " + vector(0.4));
    add_speeds();
    add_forces();
    if (chance(0.6)) add_constraint();
    return "gauss: 1\nname: m\nparameters: {k: 3.5, c: 0.7, L: 0.9}\ninputs: {f: 1.3}\n" +
           section("coordinates", coordinates_) + section("speeds", speeds_) +
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

  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", x);
    return text;
  }
  std::string vector(double size) {
    return "[" + number(uniform(-size, size)) + ", " + number(uniform(-size, size)) + ", " +
           number(uniform(-size, size)) + "]";
  }
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
    if (chance(0.8)) fields += ", at: " + vector(0.6);
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

  /// Inertia of four masses somewhere, so that it is one that a body can have.
  std::string inertia() {
    Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d r(uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-0.4, 0.4));
      I += uniform(0.5, 1.5) * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    if (chance(0.15)) return number(I(0, 0) + 0.01);
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
    bodies_ +=
        entry(frame, "mass: " + number(uniform(0.5, 3)) + ", centre: " + vector(0.3) + ", inertia: " + inertia());
    if (chance(0.2)) add_load(frame);
  }

  void add_load(const std::string& frame) {
    particles_ +=
        entry("load_" + frame, "mass: " + number(uniform(0.2, 1)) + ", frame: " + frame + ", centre: " + vector(0.5));
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
      case 0: return "force: " + expressions() + ", on: " + pick(links_) + ", at: " + vector(0.5) + in + from;
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

  void add_constraint() {
    const std::string a = pick(links_);
    const std::string b = chance(0.5) ? "ground" : pick(links_);
    const std::string p = place();
    const std::string on = a == b ? "" : ", on: " + b;
    switch (random_() % 7) {
      case 0: constraints_ += entry("loop", "coincide: [" + p + ", " + other(p) + "]"); break;
      case 1: constraints_ += entry("rod", "distance: [" + p + ", " + other(p) + "], is: L + 0.1*sin(t)"); break;
      case 2: constraints_ += entry("track", "equation: p1.z - 0.3*p1.x*p2.y - 0.2*sin(t)"); break;
      case 3: constraints_ += entry("contact", "rolls: " + a + on + ", at: [p1.x, p1.y + 0.1, 0]"); break;
      case 4:
        constraints_ +=
            entry("blade", "no_slip: " + a + on + ", at: p2, direction: " + axis() + ", in: " + pick(links_));
        break;
      case 5: constraints_ += entry("chase", "velocity: dot(p1.x)*cos(t) - dot(p2.y)*p1.z + 0.3"); break;
      default:
        if (names_.size() > 1)
          constraints_ +=
              entry("gear", "velocity: dot(" + names_[0] + ")^2 - dot(" + names_[1] + ")*(2 + sin(t)) + dot(p3.z)/3");
    }
  }

  std::mt19937 random_;
  std::vector<std::string> links_;     ///< children of joints
  std::vector<std::string> slender_;   ///< of them, those with joints that let them turn about one axis or none
  std::vector<std::string> names_;     ///< free coordinates
  std::vector<std::string> declared_;  ///< of them, by the model itself
  std::vector<std::string> turns_;     ///< angular velocities and speeds
  std::string coordinates_, speeds_, frames_, joints_, points_, bodies_, particles_, constraints_, forces_;
};

}  // namespace

std::string random_mechanism(unsigned seed) { return Mechanism(seed).text(); }

}  // namespace agreement::newton
