#include "kinematics/symbols.hpp"

#include "model/turning.hpp"

namespace gaussgen::kinematics {

namespace {

std::string rate_unit(const std::string& unit) { return unit.empty() ? unit : unit + "/s"; }

class Declaration {
 public:
  Declaration(const model::Model& model, ir::Graph& graph) : model_(model), graph_(graph) {}

  Symbols run() {
    using ir::SymbolClass;
    for (const model::Table& table : model_.tables) {
      symbols_.tables.emplace(table.name.text, graph_.declare(table.function));
    }
    symbols_.pi = graph_.declare(SymbolClass::pi, "pi");
    symbols_.epsilon = graph_.declare(SymbolClass::epsilon, "epsilon");
    for (const model::Parameter& parameter : model_.parameters) {
      symbols_.parameters.push_back(graph_.declare(SymbolClass::parameter, parameter.name.text));
    }
    symbols_.time = graph_.declare(SymbolClass::time, "t");
    for (std::size_t i = 0; i < model_.coordinates.size(); ++i) declare_coordinate(i);
    for (std::size_t i = 0; i < model_.orientations.size(); ++i) declare_orientation(i);
    for (const model::Input& input : model_.inputs) {
      symbols_.inputs.push_back(graph_.declare(SymbolClass::input, input.name.text));
    }
    for (const model::NamedReaction& reaction : model_.reactions) {
      symbols_.reactions.push_back(graph_.declare(SymbolClass::opaque, "reaction_" + reaction.of));
    }
    return std::move(symbols_);
  }

 private:
  void declare_coordinate(std::size_t index) {
    using ir::SymbolClass;
    const model::Coordinate& coordinate = model_.coordinates[index];
    const std::string& name = coordinate.name.text;
    if (coordinate.held_at) {
      symbols_.coordinates.push_back({true, symbols_.held.size()});
      symbols_.held.push_back({graph_.declare(SymbolClass::held, name),
                               graph_.declare(SymbolClass::held_rate, name + "_dot"),
                               graph_.declare(SymbolClass::held_acceleration, name + "_ddot"), index, name});
      return;
    }
    symbols_.coordinates.push_back({false, symbols_.speeds.size()});
    symbols_.configuration.push_back(
        {graph_.declare(SymbolClass::configuration, name), name, coordinate.unit, coordinate.about});
    if (coordinate.speed) {
      const model::Speed& speed = model_.speeds[*coordinate.speed];
      declare_speed(speed.name.text, speed.name.text + "_dot", speed.name.text, speed.unit, speed.about);
      symbols_.speeds[FreeIndex{symbols_.speeds.size() - 1}].replaces_rate = true;
      return;
    }
    declare_speed(name + "_dot", name + "_ddot", name, rate_unit(coordinate.unit), "rate of " + name);
  }

  void declare_speed(const std::string& name, const std::string& acceleration, const std::string& label,
                     const std::string& unit, const std::string& about) {
    using ir::SymbolClass;
    symbols_.speeds.push_back({graph_.declare(SymbolClass::speed, name),
                               graph_.declare(SymbolClass::acceleration, acceleration), name, acceleration, label, unit,
                               about});
  }

  void declare_orientation(std::size_t index) {
    const model::Orientation& orientation = model_.orientations[index];
    const std::string outer = model::outer_frame(model_, index);
    symbols_.first_quaternion_component.push_back(ConfigurationIndex{symbols_.configuration.size()});
    for (const model::Name& name : orientation.quaternion) {
      symbols_.configuration.push_back({graph_.declare(ir::SymbolClass::configuration, name.text, true), name.text, "1",
                                        "unit quaternion " + orientation.name.text + ", body to " + outer});
    }
    symbols_.first_angular_velocity.push_back(FreeIndex{symbols_.speeds.size()});
    const std::string against = outer == "space" ? "" : " relative to " + outer;
    const std::string axes = orientation.axes == model::Axes::space ? outer : "body";
    for (const model::Name& name : orientation.angular_velocity) {
      declare_speed(name.text, name.text + "_dot", name.text, "rad/s",
                    "angular velocity of " + orientation.name.text + against + ", " + axes + " frame");
    }
  }

  const model::Model& model_;
  ir::Graph& graph_;
  Symbols symbols_;
};

}  // namespace

ir::SymbolId Symbols::rate(FullIndex i) const {
  return i.value < free_count() ? speeds[FreeIndex{i.value}].symbol : held[HeldIndex{i.value - free_count()}].rate;
}

const std::string& Symbols::label(FullIndex i) const {
  return i.value < free_count() ? speeds[FreeIndex{i.value}].label : held[HeldIndex{i.value - free_count()}].name;
}

Symbols declare_symbols(const model::Model& model, ir::Graph& graph) { return Declaration(model, graph).run(); }

}  // namespace gaussgen::kinematics
