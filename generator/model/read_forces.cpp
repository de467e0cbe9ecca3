// forces: a uniform field, a potential, or generalized components; exactly one law each.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/names.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;

namespace {

const std::vector<std::string> k_keys = {"uniform", "potential", "generalized", "about"};

GeneralizedForce read_components(const Entry& entry, Reading& reading) {
  GeneralizedForce force;
  if (!expect_map(entry.value, entry.key.span, "'generalized'", reading)) return force;
  for (const Entry& component : entry.value.entries) {
    force.components.emplace_back(name_of(component.key),
                                  read_expression(component.value, component.key.span, reading));
  }
  return force;
}

void read_law(const Entry& entry, Force& force, Reading& reading) {
  if (entry.key.text == "uniform")
    force.law = UniformField{read_vector(entry.value, entry.key.span, "'uniform'", reading)};
  if (entry.key.text == "potential") force.law = Potential{read_expression(entry.value, entry.key.span, reading)};
  if (entry.key.text == "generalized") force.law = read_components(entry, reading);
}

void check_one_law(const Entry& entry, Reading& reading) {
  const Entry* first = nullptr;
  for (const Entry& field : entry.value.entries) {
    const std::string& key = field.key.text;
    if (key != "uniform" && key != "potential" && key != "generalized") continue;
    if (first != nullptr) {
      reading.diagnostics.error(code::k_conflicting_keys, field.key.span,
                                fmt::format("force '{}' has '{}' beside '{}'", entry.key.text, key, first->key.text),
                                "write two forces with names of their own");
      return;
    }
    first = &field;
  }
  if (first != nullptr) return;
  reading.diagnostics.error(code::k_missing_key, entry.key.span, fmt::format("force '{}' has no law", entry.key.text),
                            "add one of uniform: [x, y, z], potential: V, generalized: {coordinate: Q}");
}

void read_force(const Entry& entry, Reading& reading) {
  const std::string where = fmt::format("force '{}'", entry.key.text);
  Force force;
  force.name = name_of(entry.key);
  check_name(force.name, reading);
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    const std::size_t findings = reading.diagnostics.all().size();
    check_keys(entry.value, where, k_keys, reading);
    // A law with a slip in its name is reported already.
    if (reading.diagnostics.all().size() == findings) check_one_law(entry, reading);
    for (const Entry& field : entry.value.entries) read_law(field, force, reading);
    force.about = text_field(entry.value, "about", reading);
  }
  reading.model.forces.push_back(std::move(force));
}

}  // namespace

void read_forces(const spec::Node& root, Reading& reading) {
  read_section(root, "forces", reading, [&](const Entry& entry) { read_force(entry, reading); });
}

}  // namespace gaussgen::model
