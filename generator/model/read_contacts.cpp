// contacts: a gap that does not become negative. In a regime it is open, or closed and a constraint.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/regime.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

void read_contact(const spec::Entry& entry, Reading& reading) {
  const std::string where = fmt::format("contact '{}'", entry.key.text);
  Contact contact;
  contact.name = name_of(entry.key);
  contact.gap = broken_expression();
  check_name(contact.name, reading);
  if (expect_map(entry.value, entry.key.span, where, reading)) {
    check_keys(entry.value, where, format::keys_of(format::contact()), reading);
    if (required(entry.value, "gap", entry.key.span, where, reading) != nullptr)
      contact.gap = *expression_field(entry.value, "gap", reading);
    contact.restitution = expression_field(entry.value, "restitution", reading);
    contact.about = text_field(entry.value, "about", reading);
  }
  for (const Constraint& row : reading.model.constraints) {
    if (row.name.text != contact.name.text) continue;
    reading.diagnostics.error(
        support::code::k_name_clash, contact.name.span,
        fmt::format("'{}' is also the constraint in {}", contact.name.text, reading.line_text(row.name.span)),
        "both would label a reaction; rename one of the two");
    break;
  }
  contact.mode = mode_of(contact.name.text, {Mode::open, Mode::closed}, reading);
  if (contact.mode == Mode::closed) {
    Constraint row;
    row.name = contact.name;
    row.about = contact.about;
    row.span = contact.gap.span;
    row.law = PositionLaw{contact.gap};
    reading.model.constraints.push_back(std::move(row));
  }
  reading.model.contacts.push_back(std::move(contact));
}

}  // namespace

void read_contacts(const spec::Node& root, Reading& reading) {
  read_section(root, "contacts", reading, [&](const spec::Entry& entry) { read_contact(entry, reading); });
}

}  // namespace gaussgen::model
