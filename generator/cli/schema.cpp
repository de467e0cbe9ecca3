// The format of models as a JSON Schema, draft-07.

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "model/format.hpp"

namespace gaussgen::cli {

namespace {

namespace format = model::format;
using Json = nlohmann::ordered_json;

// Letters, digits, indices such as $i and $(i - 1), and single underscores between them; no word that YAML takes for
// another value.
constexpr const char* k_name_pattern =
    R"(^(?!(true|True|TRUE|false|False|FALSE|null|Null|NULL)$)[A-Za-z](_?([A-Za-z0-9]|\$[A-Za-z]|\$\([^$]*\)))*$)";
constexpr int k_longest_name = 64;

constexpr const char* k_not_blank = R"(\S)";
// $i, $j and $k count copies.
constexpr const char* k_count_name_pattern = "^(?![ijk]$)[A-Za-z][A-Za-z0-9]*$";
// Characters of formulas of whole numbers; such a formula ends with a number, a name or a bracket.
constexpr const char* k_count_pattern = "^[-+*/%() $A-Za-z0-9]*[A-Za-z0-9)] *$";

Json schema_of(const format::Map& map);
Json schema_of(const format::Value& value);

Json new_name() { return {{"type", "string"}, {"pattern", k_name_pattern}, {"maxLength", k_longest_name}}; }

Json list_of(const format::Value& value) {
  Json schema{{"type", "array"}, {"items", schema_of(*value.item)}};
  if (value.count > 0) {
    schema["minItems"] = value.count;
    schema["maxItems"] = value.count;
  }
  if (value.most > 0) {
    schema["minItems"] = 1;
    schema["maxItems"] = value.most;
  }
  if (value.item->shape == format::Shape::word && value.item->others.empty()) schema["uniqueItems"] = true;
  return schema;
}

/// Of one shape, as YAML 1.2 reads it: an expression may be a number.
Json schema_of_shape(const format::Value& value) {
  switch (value.shape) {
    case format::Shape::version: return {{"enum", {1, "1"}}};
    case format::Shape::text: return {{"type", {"string", "number", "boolean"}}};
    case format::Shape::expression: return {{"type", {"string", "number"}}, {"pattern", k_not_blank}};
    case format::Shape::count:
      return {{"type", {"string", "integer"}},
              {"pattern", k_count_pattern},
              {"minimum", 0},
              {"maximum", format::k_most_copies}};
    case format::Shape::word: return {{"enum", value.words}};
    case format::Shape::new_name: return new_name();
    case format::Shape::name: return {{"type", "string"}};
    case format::Shape::list: return list_of(value);
    case format::Shape::map: return schema_of(*value.map);
    case format::Shape::entries:
      return {{"type", "object"}, {"propertyNames", new_name()}, {"additionalProperties", schema_of(*value.item)}};
    case format::Shape::counts:
      return {{"type", "object"},
              {"propertyNames", {{"pattern", k_count_name_pattern}}},
              {"additionalProperties", schema_of(*value.item)}};
  }
  return Json::object();
}

Json schema_of(const format::Value& value) {
  Json shapes = Json::array({schema_of_shape(value)});
  for (const format::Value& other : value.others) shapes.push_back(schema_of(other));
  if (value.may_be_empty) shapes.push_back({{"type", "null"}});
  return shapes.size() == 1 ? shapes[0] : Json{{"anyOf", shapes}};
}

Json condition_of(const format::Rule& rule) {
  Json value = Json::object();
  if (!rule.word.empty()) value = {{"const", rule.word}};
  if (rule.when == format::When::is_list) value = {{"type", "array"}};
  if (rule.when == format::When::is_single) value = {{"type", "string"}};
  return {{"required", {rule.key}}, {"properties", {{rule.key, value}}}};
}

Json schema_of(const format::Rule& rule) {
  std::vector<std::string> keys{rule.key};
  keys.insert(keys.end(), rule.beside.begin(), rule.beside.end());
  Json then{{"propertyNames", {{"enum", keys}}}};
  if (!rule.required.empty()) then["required"] = rule.required;
  for (const std::string& key : rule.one_of) then["anyOf"].push_back({{"required", {key}}});
  for (const format::Key& key : rule.narrowed) then["properties"][key.name] = schema_of(key.value);
  return {{"if", condition_of(rule)}, {"then", then}};
}

Json schema_of(const format::Map& map) {
  Json schema{{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array();
  for (const format::Key& key : map.keys) {
    Json property = schema_of(key.value);
    property["description"] = key.about;
    schema["properties"][key.name] = property;
    if (key.need == format::Need::required) required.push_back(key.name);
  }
  if (!required.empty()) schema["required"] = required;
  for (const format::Rule& rule : map.rules) schema["allOf"].push_back(schema_of(rule));
  for (const std::string& law : map.laws) schema["oneOf"].push_back({{"required", {law}}});
  return schema;
}

/// Editors read descriptions beside a reference only where it is one of several conditions.
Json reference_to(const std::string& definition, const std::string& about) {
  return {{"allOf", {{{"$ref", "#/definitions/" + definition}}}}, {"description", about}};
}

/// In a model with effects, an entry may have the rest of its keys from them.
Json schema_of_model() {
  Json schema = schema_of(format::model_file());
  Json effect = schema_of(format::effect());
  Json strict = Json::object();
  Json partial = Json::object();
  for (const std::string& section : format::section_names()) {
    const std::string about = schema["properties"][section]["description"];
    schema["definitions"][section] = effect["properties"][section];
    strict[section] = schema["properties"][section];
    partial[section] = reference_to(section, about);
    schema["properties"][section] = {{"description", about}};
    effect["properties"][section] = reference_to(section, about);
  }
  schema["definitions"]["effect"] = effect;
  Json& effects = schema["properties"][format::k_effects];
  effects["anyOf"][0]["additionalProperties"] = {{"anyOf", {{{"$ref", "#/definitions/effect"}}, {{"type", "null"}}}}};
  schema["if"] = {{"required", {format::k_effects}}};
  schema["then"] = {{"properties", partial}};
  schema["else"] = {{"properties", strict}};
  return schema;
}

}  // namespace

int schema() {
  Json document{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "model of gauss"},
                {"description", "Written by gauss-gen schema."}};
  document.update(schema_of_model());
  write_standard_output(document.dump(2) + "\n");
  return k_ok;
}

}  // namespace gaussgen::cli
