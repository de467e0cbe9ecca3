// The checked model as text: what the file says, in its words, with what it leaves out filled in.

#include <fmt/format.h>

#include "description.hpp"
#include "dumps.hpp"
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

const char* name_of(model::Frame frame) { return frame == model::Frame::space ? "space" : "body"; }

class ModelText {
 public:
  ModelText(const Model& model, const support::Source& source) : model_(model), source_(source) {}

  std::string run() {
    text_ = "model " + model_.name.text + remarks("", model_.about);
    section("parameters", model_.parameters);
    section("inputs", model_.inputs);
    section("coordinates", model_.coordinates);
    section("orientations", model_.orientations);
    section("bodies", model_.bodies);
    section("constraints", model_.constraints);
    section("forces", model_.forces);
    add_elimination();
    text_ += "outputs\n  " + (model_.outputs.empty() ? "all" : joined_names(model_.outputs)) + "\n";
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

  void add(const model::Coordinate& coordinate) {
    text_ += fmt::format("  {}: {}{}", coordinate.name.text,
                         coordinate.held_at ? "held at " + written(*coordinate.held_at) : start(coordinate),
                         remarks(coordinate.unit, coordinate.about));
  }

  std::string start(const model::Coordinate& coordinate) const {
    const std::string guess = coordinate.rate_guess ? ", guess " + written(*coordinate.rate_guess) : "";
    return fmt::format("initial {}, initial rate {}{}", written(coordinate.initial), written(coordinate.initial_rate),
                       guess);
  }

  void add(const model::Orientation& orientation) {
    const auto& e = orientation.quaternion;
    const auto& w = orientation.angular_velocity;
    text_ +=
        fmt::format("  {}: unit quaternion, body to space{}", orientation.name.text, remarks("", orientation.about));
    text_ += fmt::format("    quaternion [{}], initial {}\n", joined_names({e.begin(), e.end()}),
                         written(orientation.initial));
    text_ += fmt::format("    angular velocity [{}] in the {} frame, initial {}  [rad/s]\n",
                         joined_names({w.begin(), w.end()}), name_of(orientation.frame),
                         written(orientation.initial_angular_velocity));
  }

  void add(const model::Body& body) {
    text_ +=
        fmt::format("  {}: {}{}", body.name.text, body.inertia ? "rigid body" : "particle", remarks("", body.about));
    text_ += fmt::format("    mass {}\n    position {}\n", written(body.mass), written(body.position));
    if (body.inertia) text_ += fmt::format("    inertia {}\n", written(*body.inertia));
    if (const auto* euler = std::get_if<model::EulerAngles>(&body.orientation)) {
      text_ += fmt::format("    orientation euler {} {}\n", euler->sequence, written(euler->angles));
    }
    if (const auto* quaternion = std::get_if<model::QuaternionOrientation>(&body.orientation)) {
      text_ += fmt::format("    orientation {}\n", model_.orientations[quaternion->index].name.text);
    }
  }

  void add(const model::VelocityConstraint& constraint) {
    text_ += fmt::format("  {}: {} = 0{}", constraint.name.text, written(constraint.velocity),
                         remarks("", constraint.about));
    if (constraint.point) text_ += fmt::format("    point {}\n", written(*constraint.point));
  }

  void add(const model::Force& force) {
    const std::string law = std::visit([this](const auto& of_force) { return written(of_force); }, force.law);
    text_ += fmt::format("  {}: {}{}", force.name.text, law, remarks("", force.about));
  }

  std::string written(const model::UniformField& force) const { return "uniform " + written(force.field); }
  std::string written(const model::Potential& force) const { return "potential " + written(force.energy); }
  std::string written(const model::GeneralizedForce& force) const {
    std::vector<std::string> words;
    for (const auto& [name, value] : force.components) words.push_back(name.text + ": " + written(value));
    return "generalized {" + support::joined(words) + "}";
  }

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

  template <class Entry, std::size_t N>
  std::string written(const std::array<Entry, N>& entries) const {
    std::vector<std::string> words;
    for (const Entry& entry : entries) words.push_back(written(entry));
    return "[" + support::joined(words) + "]";
  }

  std::string written(const std::optional<Ast>& rate) const { return rate ? written(*rate) : k_left_open; }

  /// In the words of the file; what the file leaves out is a number.
  std::string written(const Ast& ast) const {
    const std::string_view words = source_.text(ast.span);
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

  const Model& model_;
  const support::Source& source_;
  std::string text_;
};

}  // namespace

std::string dump_model(const Model& model, const support::Source& source) { return ModelText(model, source).run(); }

}  // namespace gaussgen
