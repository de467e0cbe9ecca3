#include "sim/cli/list_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim/methods/methods.hpp"
#include "sim/run/setting.hpp"
#include "sim/scene/choices.hpp"

namespace gausssim {

namespace {

std::string order_of(const MethodInfo& method) {
  return method.least_order == method.order ? fmt::format("{}", method.order)
                                            : fmt::format("{} to {}", method.least_order, method.order);
}

/// What it asks for, and what it does without.
std::string needs_of(const MethodInfo& method) {
  std::vector<std::string> all;
  if (method.is_separable) all.emplace_back("accelerations by coordinates alone");
  if (!method.takes.empty()) all.emplace_back("jacobian, else differences");
  if (!method.projects) all.emplace_back("no projection");
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : "; ") + one;
  return text;
}

std::vector<std::string> numbers_of(const MethodInfo& method) {
  std::vector<std::string> all;
  for (const std::string& number : number_names()) {
    if (computes_in(method, number)) all.push_back(number);
  }
  return all;
}

using Row = std::vector<std::string>;

std::vector<Row> rows() {
  std::vector<Row> all{{"method", "order", "by", "for", "numbers", "library", "what it is", "needs"}};
  for (const MethodInfo& method : methods()) {
    all.push_back({method.name, order_of(method), method.takes_step ? "step" : "tolerance",
                   method.is_stiff ? "stiff" : "", fmt::format("{}", fmt::join(numbers_of(method), ", ")),
                   method.library, method.about, method.missing.empty() ? needs_of(method) : method.missing});
  }
  return all;
}

std::string as_text() {
  const std::vector<Row> all = rows();
  std::vector<std::size_t> widths(all.front().size(), 0);
  for (const Row& row : all) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : all) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:{}}  ", row[i], widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string as_json() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MethodInfo& method : methods()) {
    all.push_back({{"name", method.name},
                   {"library", method.library},
                   {"least_order", method.least_order},
                   {"order", method.order},
                   {"takes_step", method.takes_step},
                   {"stiff", method.is_stiff},
                   {"projects", method.projects},
                   {"numbers", numbers_of(method)},
                   {"accelerations_by_coordinates_alone", method.is_separable},
                   {"takes", method.takes},
                   {"about", method.about},
                   {"is_built_in", method.missing.empty()}});
    if (!method.missing.empty()) all.back()["missing"] = method.missing;
  }
  return all.dump(2) + "\n";
}

}  // namespace

std::string listed_methods(bool is_json) { return is_json ? as_json() : as_text(); }

}  // namespace gausssim
