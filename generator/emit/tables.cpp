#include "emit/tables.hpp"

#include "emit/text.hpp"

namespace gaussgen::emit {

namespace {

using Rows = std::vector<std::vector<cpp::Expression>>;

void add_row(Rows& rows, const std::string& name, const std::string& unit, const std::string& about) {
  rows.push_back({cpp::atom(string_literal(name)), cpp::atom(string_literal(unit)), cpp::atom(string_literal(about))});
}

void add_row(Rows& rows, const Entry& entry) { add_row(rows, entry.name, entry.unit, entry.about); }

cpp::Table quantity_table(const std::string& name, Rows rows) {
  rows.push_back({cpp::atom("nullptr"), cpp::atom("nullptr"), cpp::atom("nullptr")});
  return {{}, "Quantity", name, std::move(rows), false};
}

cpp::Table member_table(const std::string& comment, const std::string& type, const std::string& name,
                        const std::vector<std::string>& members) {
  const std::string scope = "&" + type + "<S>::";
  Rows rows;
  for (const std::string& member : members) rows.push_back({cpp::atom(scope + member)});
  rows.push_back({cpp::atom("nullptr")});
  return {comment, "S " + type + "<S>::*", name, std::move(rows), true};
}

cpp::Constant size(const std::string& name, std::size_t value, const std::string& comment) {
  return {"int", name, cpp::atom(std::to_string(value)), comment};
}

std::vector<const Entry*> plain_parameters(const Unit& unit) {
  std::vector<const Entry*> plain;
  for (const ParameterEntry& parameter : unit.parameters) {
    if (!parameter.is_formula) plain.push_back(&parameter.entry);
  }
  return plain;
}

}  // namespace

std::vector<cpp::Item> sizes(const Plan& plan) {
  const Unit& unit = plan.unit;
  return {size("n_q", unit.configuration.size(), "coordinates"), size("n_v", unit.speeds.size(), "speeds"),
          size("n_parameters", plain_parameters(unit).size(), ""), size("n_inputs", unit.inputs.size(), ""),
          size("n_constraints", unit.constraints.size(), "")};
}

std::vector<cpp::Item> introspection_tables(const Plan& plan) {
  const Unit& unit = plan.unit;
  Rows parameters, inputs, coordinates, speeds, constraints;
  std::vector<std::string> parameter_members, input_members;
  for (const Entry* entry : plain_parameters(unit)) {
    add_row(parameters, *entry);
    parameter_members.push_back(plan.names.of(*entry));
  }
  for (const InputEntry& input : unit.inputs) {
    add_row(inputs, input.entry);
    input_members.push_back(plan.names.of(input.entry));
  }
  for (const Entry& entry : unit.configuration) add_row(coordinates, entry);
  for (const Entry& entry : unit.speeds) add_row(speeds, entry);
  for (const ConstraintEntry& constraint : unit.constraints) add_row(constraints, constraint.name, "", constraint.about);

  return {cpp::Comment{"For drivers that work with any model: name, unit, meaning; each table ends with an empty entry."},
          cpp::Constant{"const char*", "name_of_model", cpp::atom(string_literal(unit.model_name)), ""},
          quantity_table("coordinate_table", std::move(coordinates)),
          quantity_table("speed_table", std::move(speeds)),
          quantity_table("parameter_table", std::move(parameters)),
          quantity_table("input_table", std::move(inputs)),
          quantity_table("constraint_table", std::move(constraints)),
          cpp::BlankLine{},
          member_table("Members in the order of parameter_table.", "Parameters", "parameter_members", parameter_members),
          cpp::BlankLine{},
          member_table("Members in the order of input_table.", "Inputs", "input_members", input_members)};
}

}  // namespace gaussgen::emit
