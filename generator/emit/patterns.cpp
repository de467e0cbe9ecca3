#include "emit/patterns.hpp"

#include "emit/identifiers.hpp"
#include "emit/text.hpp"

namespace gaussgen::emit {

namespace {

constexpr std::size_t k_comment_width = 104;

/// Of each sparse field, with the struct that it is in; a struct that several functions fill has it once.
struct SparseField {
  const Pattern* pattern;
  std::string result_type;
  std::string group;
  std::string field;
};

std::vector<SparseField> sparse_fields(const Unit& unit) {
  std::vector<SparseField> fields;
  for (const Artefact& artefact : unit.artefacts) {
    if (artefact.is_part) continue;  // the function that calls it fills the same struct
    for (const Group& group : artefact.groups) {
      for (const Field& field : group.fields) {
        if (field.pattern) fields.push_back({&*field.pattern, artefact.result_type, group.name, field.name});
      }
    }
  }
  return fields;
}

cpp::Expression number(std::size_t value) { return cpp::atom(std::to_string(value)); }

cpp::Member size(const char* name, std::size_t value) { return {"static constexpr int", name, {}, number(value), {}}; }

cpp::Member table(const char* name, const std::vector<int>& values) {
  std::vector<cpp::Expression> items;
  for (const int value : values) items.push_back(cpp::atom(std::to_string(value)));
  if (items.empty()) items.push_back(number(0));  // an array has at least one element in C++
  const std::string count = std::to_string(items.size());
  return {"static constexpr int", name, {count}, cpp::list(std::move(items)), {}};
}

cpp::Struct printed(const Pattern& pattern) {
  cpp::Struct type;
  type.comment = wrapped(pattern.about, k_comment_width);
  type.is_template = false;
  type.name = pattern.type_name;
  type.members = {size("rows", static_cast<std::size_t>(pattern.rows)),
                  size("columns", static_cast<std::size_t>(pattern.columns)), size("entries", pattern.column.size()),
                  table("row_begin", pattern.row_begin), table("column", pattern.column)};
  return type;
}

/// for (int index = from; index < to; ++index) statement
cpp::Loop loop(const std::string& index, const std::string& from, const std::string& to, cpp::Statement body) {
  cpp::Loop result{index, from, to, {}};
  result.body.push_back({std::move(body)});
  return result;
}

cpp::Function dense(const SparseField& field, const ResultTypes& types) {
  const std::string& pattern = field.pattern->type_name;
  cpp::Function function;
  function.comment =
      "The whole matrix, one row after the other: " + pattern + "::rows * " + pattern + "::columns values.";
  // On the host: tables of a struct are not there in device code.
  function.prefix = "inline";
  function.type = "void";
  function.name = "dense";
  function.arguments = {{"const " + field.result_type + "<S>&", snake_case(field.result_type), true},
                        {pattern, "pattern", false},
                        {"S*", "matrix", true}};
  function.suffix = "noexcept";
  const auto assign = [](const std::string& place, cpp::Expression value) {
    return cpp::Assignment{cpp::atom(place), std::move(value)};
  };
  const std::string scope = pattern + "::", path = types.path(field.result_type, field.group, field.field);
  function.body.emplace_back(
      loop("i", "0", scope + "rows * " + scope + "columns", assign("matrix[i]", cpp::call("S", {number(0)}))));
  function.body.emplace_back(
      loop("i", "0", scope + "rows",
           loop("k", scope + "row_begin[i]", scope + "row_begin[i + 1]",
                assign("matrix[i * " + scope + "columns + " + scope + "column[k]]", cpp::atom(path + "[k]")))));
  return function;
}

}  // namespace

std::vector<cpp::Struct> pattern_structs(const Unit& unit) {
  std::vector<cpp::Struct> types;
  for (const SparseField& field : sparse_fields(unit)) types.push_back(printed(*field.pattern));
  return types;
}

std::vector<cpp::Function> dense_functions(const Plan& plan) {
  std::vector<cpp::Function> functions;
  for (const SparseField& field : sparse_fields(plan.unit)) functions.push_back(dense(field, plan.result_types));
  return functions;
}

}  // namespace gaussgen::emit
