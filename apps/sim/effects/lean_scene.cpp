#include "sim/effects/lean_scene.hpp"

#include <fmt/format.h>

#include <sstream>

namespace gausssim {

namespace {

std::string line_of(const std::vector<std::string>& effects) {
  return fmt::format("effects: [{}]\n", fmt::join(effects, ", "));
}

bool begins(const std::string& line, const std::string& key) { return line.rfind(key + ":", 0) == 0; }

/// Of a value that goes on from the line of its key.
bool goes_on(const std::string& line) {
  return !line.empty() && (line.front() == ' ' || line.front() == '\t' || line.front() == '-' || line.front() == ']');
}

}  // namespace

std::string scene_with_effects(const std::string& scene, const std::vector<std::string>& effects) {
  std::istringstream lines(scene);
  std::string result, line;
  bool is_within = false, has_model = false, has_effects = false;
  std::size_t behind_model = 0;
  while (std::getline(lines, line)) {
    if (is_within && goes_on(line)) continue;
    is_within = begins(line, "effects");
    if (is_within) {
      result += line_of(effects);
      has_effects = true;
      continue;
    }
    result += line + "\n";
    if (begins(line, "model")) {
      has_model = true;
      behind_model = result.size();
    }
  }
  if (!has_effects && has_model) result.insert(behind_model, line_of(effects));
  return has_effects || has_model ? result : "";
}

std::string scene_of_model(const std::string& name, const std::string& model, const std::vector<std::string>& effects) {
  return fmt::format("gauss: 1\nscene: {}\nmodel: {}\n{}", name, model, line_of(effects));
}

}  // namespace gausssim
