#pragma once
// The closed forms of tests/reference/*.json: read, never retyped.

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace reference {

using Json = nlohmann::json;

inline Json read(const std::string& name) {
  std::ifstream file(std::string(GAUSS_SOURCE_DIR "/tests/reference/") + name + ".json");
  return Json::parse(file);
}

/// Numbers with more digits than a double are strings; some have a remark after the number.
inline double number(const Json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

}  // namespace reference
