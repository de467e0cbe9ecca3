// The checked model as text: what the file says, in its words, with what it leaves out filled in.

#include <fmt/format.h>

#include <algorithm>

#include "description.hpp"
#include "dumps.hpp"
#include "model/turning.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

namespace {

using model::Ast;
using model::Model;

/// The constraints determine it.
const char* const k_left_open = "left open";

/// What follows the words of an entry.
std::string remarks(const std::string& unit, const std::string& about) {
  return (unit.empty() ? "" : "  [" + unit + "]") + (about.empty() ? "" : "  # " + on_one_line(about)) + "\n";
}

std::string joined_names(const std::vector<model::Name>& names) {
  std::vector<std::string> words;
  for (const model::Name& name : names) words.push_back(name.text);
  return support::joined(words);
}

class ModelText {
 public:
  ModelText(const Model& model, const support::Source& source) : model_(model), source_(source) {}

  std::string run() {
    text_ = "model " + model_.name.text + remarks("", model_.about);
    section("parameters", model_.parameters);
    section("inputs", model_.inputs);
    section("tables", model_.tables);
    section("coordinates", model_.coordinates);
    section("speeds", model_.speeds);
    section("orientations", model_.orientations);
    add_frames();
    section("joints", model_.joints);
    section("bodies", model_.bodies);
    section("constraints", model_.constraints);
    section("contacts", model_.contacts);
    section("dry friction", model_.frictions);
    section("forces", model_.forces);
    section("quantities", model_.quantities);
    section("exact", model_.exact);
    add_elimination();
    if (!model::has_units(model_)) text_ += "units\n  none are stated, so none are checked\n";
    text_ += "outputs\n  " + (model_.outputs.empty() ? "all" : joined_names(model_.outputs)) + "\n";
    if (model_.rank_tolerance) text_ += "rank_tolerance\n  " + support::to_text(*model_.rank_tolerance) + "\n";
    if (!model_.sensitivities.empty()) text_ += "sensitivities\n  " + joined_names(model_.sensitivities) + "\n";
    return text_;
  }

 private:
  template <class Entries>
  void section(const std::string& title, const Entries& entries) {
    if (entries.empty()) return;
    text_ += title + "\n";
    for (const auto& entry : entries) add(entry);
  }

  void add_elimination() {
    if (model_.constraints.empty()) return;
    const std::string names = model_.dependent.empty() ? "as the generator chooses" : joined_names(model_.dependent);
    text_ += "elimination\n  dependent: " + names + "\n";
  }

  void add(const model::Parameter& parameter) {
    text_ += fmt::format("  {} = {}{}", parameter.name.text, written(parameter.value),
                         remarks(parameter.unit, parameter.about));
  }

  void add(const model::Input& input) {
    text_ += fmt::format("  {} = {}{}", input.name.text, written(input.value), remarks(input.unit, input.about));
  }

  void add(const model::Speed& speed) {
    const auto index = static_cast<std::size_t>(&speed - model_.speeds.data());
    const model::Coordinate& owner = model_.coordinates[model_.coordinate_of_speed(index)];
    text_ += fmt::format("  {} = {}, initial {}{}", speed.name.text, written(speed.is), written(owner.initial_rate),
                         remarks(speed.unit, speed.about));
  }

  void add(const model::NamedQuantity& quantity) {
    const std::string value = quantity.values.size() == 1 ? written(quantity.values.front()) : written(quantity.values);
    text_ += fmt::format("  {} = {}{}", quantity.name.text, value, remarks(quantity.unit, quantity.about));
  }

  void add(const model::ClosedForm& form) { text_ += fmt::format("  {} = {}\n", form.name.text, written(form.value)); }

  void add(const model::Table& table) {
    const std::string kind = table.kind == model::Table::Kind::spline ? "spline" : "linear";
    const std::string outside = table.outside == model::Table::Outside::hold ? "held" : "extended";
    const std::string of_unit = table.of_unit.empty() ? "" : "  [" + table.of_unit + "]";
    text_ += fmt::format("  {}: {}, {} outside{}", table.name.text, kind, outside, remarks("", table.about));
    text_ += fmt::format("    of {}{}\n    values {}{}", written(table.of), of_unit, written(table.values),
                         remarks(table.unit, ""));
  }

  void add(const model::Coordinate& coordinate) {
    text_ += fmt::format("  {}: {}{}", coordinate.name.text,
                         coordinate.held_at ? "held at " + written(*coordinate.held_at) : start(coordinate),
                         remarks(coordinate.unit, coordinate.about));
  }

  std::string start(const model::Coordinate& coordinate) const {
    if (coordinate.speed) return "initial " + written(coordinate.start());
    const std::string guess = coordinate.rate_guess ? ", guess " + written(*coordinate.rate_guess) : "";
    return fmt::format("initial {}, initial rate {}{}", written(coordinate.start()), written(coordinate.initial_rate),
                       guess);
  }

  void add(const model::Orientation& orientation) {
    const auto& e = orientation.quaternion;
    const auto& w = orientation.angular_velocity;
    const auto index = static_cast<std::size_t>(&orientation - model_.orientations.data());
    const std::string outer = model::outer_frame(model_, index);
    text_ += fmt::format("  {}: unit quaternion, body to {}{}", orientation.name.text, outer,
                         remarks("", orientation.about));
    text_ += fmt::format("    quaternion [{}], initial {}\n", joined_names({e.begin(), e.end()}),
                         written(orientation.initial));
    text_ += fmt::format("    angular velocity [{}]{} in the {} frame, initial {}  [rad/s]\n",
                         joined_names({w.begin(), w.end()}), outer == "space" ? "" : " relative to " + outer,
                         orientation.axes == model::Axes::space ? outer : "body",
                         written(orientation.initial_angular_velocity));
  }

  void add(const model::Body& body) {
    text_ +=
        fmt::format("  {}: {}{}", body.name.text, body.inertia ? "rigid body" : "particle", remarks("", body.about));
    text_ += fmt::format("    mass {}\n", written(body.mass));
    if (is_own_frame(body)) {
      text_ += placement(model_.frames[body.frame]);
    } else {
      text_ += fmt::format("    on {}, mass centre at {}\n", model_.frames[body.frame].name.text, written(body.centre));
    }
    if (body.inertia) text_ += fmt::format("    inertia {}\n", written(*body.inertia));
  }

  bool is_own_frame(const model::Body& body) const {
    return model_.frames[body.frame].name.text == body.name.text &&
           model_.frames[body.frame].name.span == body.name.span;
  }

  /// Those of bodies are shown with them.
  void add_frames() {
    std::vector<model::Frame> others;
    for (const model::Frame& frame : model_.frames) {
      const bool is_body = std::any_of(model_.bodies.begin(), model_.bodies.end(), [&](const model::Body& body) {
        return body.name.text == frame.name.text && body.name.span == frame.name.span;
      });
      if (!is_body) others.push_back(frame);
    }
    section("frames", others);
  }

  void add(const model::Frame& frame) {
    text_ += fmt::format("  {}{}", frame.name.text, remarks("", frame.about)) + placement(frame);
  }

  std::string placement(const model::Frame& frame) const {
    const std::string parent = frame.parent == model::k_space ? "" : " on " + model_.frames[frame.parent].name.text;
    return fmt::format("    position {}{}\n", written(frame.position), parent) + attitude(frame);
  }

  std::string attitude(const model::Frame& frame) const {
    if (const auto* quaternion = std::get_if<model::QuaternionOrientation>(&frame.attitude)) {
      return fmt::format("    orientation {}\n", model_.orientations[quaternion->index].name.text);
    }
    const auto* turns = std::get_if<model::Turns>(&frame.attitude);
    if (turns == nullptr) return "";
    if (turns->size() == 3) return euler_angles(*turns);
    std::vector<std::string> words;
    for (const model::Turn& turn : *turns) {
      const char* letter = std::get_if<char>(&turn.axis);
      words.push_back((letter != nullptr ? std::string(1, *letter) : written(std::get<std::array<Ast, 3>>(turn.axis))) +
                      " by " + written(turn.angle));
    }
    return fmt::format("    turned about {}\n", support::joined(words));
  }

  /// Only the format's Euler angles are three turns.
  std::string euler_angles(const model::Turns& turns) const {
    std::string sequence;
    std::vector<std::string> angles;
    for (const model::Turn& turn : turns) {
      sequence += std::get<char>(turn.axis);
      angles.push_back(written(turn.angle));
    }
    return fmt::format("    orientation euler {} [{}]\n", sequence, support::joined(angles));
  }

  void add(const model::Joint& joint) {
    const model::Frame& frame = model_.frames[joint.frame];
    text_ += fmt::format("  {}: {} carries {}{}", joint.name.text, name_of(frame.parent), frame.name.text,
                         remarks("", joint.about));
  }

  void add(const model::Constraint& constraint) {
    text_ += fmt::format("  {}: {}{}", constraint.name.text,
                         std::visit([this](const auto& law) { return written(law); }, constraint.law),
                         remarks("", constraint.about));
    if (constraint.point) text_ += fmt::format("    point {}\n", written(*constraint.point));
  }

  void add(const model::Force& force) {
    const std::string law = std::visit([this](const auto& of_force) { return written(of_force); }, force.law);
    text_ += fmt::format("  {}: {}{}", force.name.text, law, remarks("", force.about));
  }

  std::string written(const model::VelocityLaw& law) const { return written(law.phi) + " = 0"; }
  std::string written(const model::PositionLaw& law) const { return written(law.f) + " = 0, for positions"; }
  std::string written(const model::SlipLaw& law) const {
    const auto* frame = std::get_if<std::size_t>(&law.at);
    return fmt::format("{} does not slip on {} at {} along {} of {}", name_of(law.frame), name_of(law.surface),
                       frame != nullptr ? name_of(*frame) : written(std::get<std::array<Ast, 3>>(law.at)),
                       written(law.direction), name_of(law.axes));
  }
  std::string name_of(std::size_t frame) const {
    return frame == model::k_space ? "space" : model_.frames[frame].name.text;
  }

  std::string written(const model::UniformField& force) const { return "uniform " + written(force.field); }
  std::string written(const model::Potential& force) const { return "potential " + written(force.energy); }
  std::string written(const model::GeneralizedForce& force) const {
    std::vector<std::string> words;
    for (const auto& [name, value] : force.components) words.push_back(name.text + ": " + written(value));
    return "generalized {" + support::joined(words) + "}";
  }

  std::string written(const model::PointForce& force) const {
    return fmt::format("force {} in {} axes, on {} at {}, from {}", written(force.components), name_of(force.axes),
                       name_of(force.frame), written(force.at), name_of(force.from));
  }
  std::string written(const model::Torque& torque) const {
    return fmt::format("torque {} in {} axes, on {}, from {}", written(torque.components), name_of(torque.axes),
                       name_of(torque.frame), name_of(torque.from));
  }
  void add(const model::Contact& contact) {
    text_ += fmt::format(
        "  {}: {} is not negative, {}{}{}", contact.name.text, written(contact.gap), model::name_of(contact.mode),
        contact.restitution ? ", restitution " + written(*contact.restitution) : "", remarks("", contact.about));
  }

  void add(const model::DryFriction& friction) {
    text_ +=
        fmt::format("  {}: {}, {}{}", friction.name.text, written(friction.law),
                    friction.is_idle ? "without a limit" : model::name_of(friction.mode), remarks("", friction.about));
  }

  std::string written(const model::Friction& friction) const {
    std::string slips;
    for (const auto& slip : friction.slips)
      slips += (slips.empty() ? "" : " and ") + std::visit([this](const auto& law) { return slip_of(law); }, slip);
    const std::string smooth = friction.smooth ? ", fading below " + written(*friction.smooth) : "";
    return fmt::format("friction of up to {} against {}{}", written(friction.limit), slips, smooth);
  }
  std::string slip_of(const model::VelocityLaw& law) const { return written(law.phi); }
  std::string slip_of(const model::SlipLaw& law) const {
    const auto* frame = std::get_if<std::size_t>(&law.at);
    return fmt::format("the slip of {} on {} at {} along {} of {}", name_of(law.frame), name_of(law.surface),
                       frame != nullptr ? name_of(*frame) : written(std::get<std::array<Ast, 3>>(law.at)),
                       written(law.direction), name_of(law.axes));
  }
  std::string written(const model::Spring& spring) const {
    return fmt::format("spring between {} and {}, stiffness {}, length {}, damping {}", name_of(spring.first),
                       name_of(spring.second), written(spring.stiffness), or_zero(spring.length),
                       or_zero(spring.damping));
  }
  std::string written(const model::CoordinateSpring& spring) const {
    return fmt::format("spring along {}, stiffness {}, rest {}, damping {}", spring.coordinate.text,
                       written(spring.stiffness), or_zero(spring.rest), or_zero(spring.damping));
  }
  std::string or_zero(const std::optional<Ast>& ast) const { return ast ? written(*ast) : "0"; }

  std::string written(const model::Inertia& inertia) const {
    const auto& [xx, yy, zz, xy, xz, yz] = inertia.entries;
    switch (inertia.shape) {
      case model::Inertia::Shape::isotropic: return written(xx);
      case model::Inertia::Shape::diagonal: return written(std::array{xx, yy, zz});
      case model::Inertia::Shape::full: break;
    }
    return fmt::format("[{}, {}, {}]", written(std::array{xx, xy, xz}), written(std::array{xy, yy, yz}),
                       written(std::array{xz, yz, zz}));
  }

  std::string written(const std::vector<Ast>& entries) const {
    std::vector<std::string> words;
    for (const Ast& entry : entries) words.push_back(written(entry));
    return "[" + support::joined(words) + "]";
  }

  template <class Entry, std::size_t N>
  std::string written(const std::array<Entry, N>& entries) const {
    std::vector<std::string> words;
    for (const Entry& entry : entries) words.push_back(written(entry));
    return "[" + support::joined(words) + "]";
  }

  std::string written(const std::optional<Ast>& rate) const { return rate ? written(*rate) : k_left_open; }

  /// In the words of the file; what the file leaves out is a number.
  std::string written(const Ast& ast) const {
    if (ast.is_derived) return derived(ast);
    const std::string_view words = model::words_of(ast, source_);
    if (words.empty()) return support::to_text(ast.number);
    std::string line;
    // An expression may go over several lines of the file.
    for (const char c : words) {
      const bool is_blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
      if (!is_blank) line += c;
      if (is_blank && line.back() != ' ') line += ' ';
    }
    return line;
  }

  /// What a shorthand stands for.
  std::string derived(const Ast& ast) const {
    using model::AstKind;
    std::vector<std::string> parts;
    for (const Ast& child : ast.children) parts.push_back(written(child));
    const auto chain = [&](const char* sign) {
      std::string text;
      for (const std::string& part : parts) text += (text.empty() ? "" : sign) + part;
      return text;
    };
    switch (ast.kind) {
      case AstKind::number: return support::to_text(ast.number);
      case AstKind::symbol: return ast.name;
      case AstKind::negate: return "-(" + parts[0] + ")";
      case AstKind::sum: return chain(" + ");
      case AstKind::product: return "(" + chain(")*(") + ")";
      case AstKind::reciprocal: return "1/(" + parts[0] + ")";
      case AstKind::power: return "(" + parts[0] + ")^" + parts[1];
      case AstKind::call: return ast.name + "(" + chain(", ") + ")";
      case AstKind::comparison: return parts[0] + " " + ast.name + " " + parts[1];
    }
    return "";
  }

  const Model& model_;
  const support::Source& source_;
  std::string text_;
};

}  // namespace

std::string dump_model(const Model& model, const support::Source& source) { return ModelText(model, source).run(); }

}  // namespace gaussgen
