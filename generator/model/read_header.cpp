// gauss, name, about, outputs, and the keys of the file.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "model/constant.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/number.hpp"
#include "model/sections.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

constexpr support::Span k_top{0, 0};

support::Span key_of(const spec::Node& map, const std::string& key) {
  const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                  [&](const spec::Entry& entry) { return entry.key.text == key; });
  return found == map.entries.end() ? k_top : found->key.span;
}

void read_name(const spec::Node& root, Reading& reading) {
  const spec::Node* name = required(root, "name", k_top, "a model file", reading);
  if (name == nullptr || !expect_scalar(*name, key_of(root, "name"), "'name'", reading)) return;
  reading.model.name = name_of(name->scalar);
  check_model_name(reading.model.name, reading);
}

void read_output(const spec::Node& item, support::Span owner, Reading& reading) {
  if (!expect_scalar(item, owner, "an output", reading)) return;
  const Name name = name_of(item.scalar);
  if (std::find(format::outputs().begin(), format::outputs().end(), name.text) == format::outputs().end()) {
    const std::string near = support::did_you_mean(name.text, format::outputs());
    reading.diagnostics.error(code::k_unknown_word, name.span, fmt::format("there is no output '{}'", name.text),
                              near.empty() ? "known outputs: " + support::joined(format::outputs()) : near);
    return;
  }
  const auto& before = reading.model.outputs;
  if (std::any_of(before.begin(), before.end(), [&](const Name& other) { return other.text == name.text; })) {
    reading.diagnostics.error(code::k_duplicate_key, name.span, fmt::format("'{}' is in this list already", name.text),
                              "remove one of the two");
    return;
  }
  reading.model.outputs.push_back(name);
}

/// To YAML, 1 and 1.0 are one number, so a schema cannot tell them apart. In quotes it is the text that counts.
bool is_version_1(const spec::Node& version) {
  const std::string& text = version.scalar.text;
  if (!version.plain || text.empty() || !support::is_digit(text.front())) return text == "1";
  const NumberScan scan = scan_number(text);
  return scan.problem.empty() && scan.size == text.size() && scan.value == support::Rational(1);
}

const support::Rational k_least_tolerance = support::Rational(1) / 1'000'000'000;
const support::Rational k_largest_tolerance = support::Rational(1) / 10;

/// Nothing, after a report, where it is no number, nor made of numbers.
std::optional<support::Rational> number_in(const spec::Node& node, support::Span owner, Reading& reading) {
  const Ast ast = read_expression(node, owner, reading);
  if (is_broken(ast)) return std::nullopt;
  const std::optional<support::Rational> value = exact_value(ast);
  if (!value) {
    reading.diagnostics.error(code::k_malformed_number, node.span,
                              fmt::format("'{}' is no number, nor made of numbers by + - * / ^", node.scalar.text),
                              "write a number, such as 1e-6 or 1/1000000");
  }
  return value;
}

}  // namespace

void read_version(const spec::Node& root, support::Span owner, Reading& reading) {
  const spec::Node* version = required(root, "gauss", owner, "a model file", reading);
  if (version == nullptr || !expect_scalar(*version, key_of(root, "gauss"), "'gauss'", reading)) return;
  if (is_version_1(*version)) return;
  reading.diagnostics.error(code::k_format_version, version->span,
                            fmt::format("this program does not read format version '{}'", version->scalar.text),
                            "write 'gauss: 1'");
}

void read_header(const spec::Node& root, Reading& reading) {
  check_keys(root, "a model file", format::keys_of(format::model_file()), reading);
  read_version(root, k_top, reading);
  read_name(root, reading);
  reading.model.about = text_field(root, "about", reading);
}

void read_rank_tolerance(const spec::Node& root, Reading& reading) {
  const spec::Node* node = spec::find(root, "rank_tolerance");
  if (node == nullptr) return;
  const std::optional<support::Rational> value = number_in(*node, key_of(root, "rank_tolerance"), reading);
  if (!value) return;
  if (*value < k_least_tolerance || *value > k_largest_tolerance) {
    reading.diagnostics.error(code::k_out_of_range, node->span,
                              "a tolerance of ranks is from 1e-9 to 0.1: the sine of an angle between constraints",
                              "leave it out for what the digits of the scalar type allow, 1e-9 of double");
    return;
  }
  reading.model.rank_tolerance = value;
}

void read_outputs(const spec::Node& root, Reading& reading) {
  const spec::Node* outputs = spec::find(root, "outputs");
  if (outputs == nullptr || outputs->kind == spec::NodeKind::empty) return;
  if (!expect_list(*outputs, outputs->span, "'outputs'", reading)) return;
  for (const spec::Node& item : outputs->items) read_output(item, outputs->span, reading);
}

void read_sensitivities(const spec::Node& root, Reading& reading) {
  const spec::Node* list = spec::find(root, "sensitivities");
  if (list == nullptr || list->kind == spec::NodeKind::empty) return;
  if (!expect_list(*list, list->span, "'sensitivities'", reading)) return;
  for (const spec::Node& item : list->items) {
    if (expect_scalar(item, list->span, "a parameter", reading))
      reading.model.sensitivities.push_back(name_of(item.scalar));
  }
}

}  // namespace gaussgen::model
