// Parameters may be defined by later ones; the model holds them in an order in which they can be computed.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <vector>

#include "model/checks.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

using Needs = std::vector<std::set<std::size_t>>;

void collect(const Ast& ast, const Model& model, std::set<std::size_t>& needs) {
  const auto symbol = ast.kind == AstKind::symbol ? model.symbols.find(ast.name) : model.symbols.end();
  if (symbol != model.symbols.end() && symbol->second.kind == SymbolKind::parameter) needs.insert(symbol->second.index);
  for (const Ast& child : ast.children) collect(child, model, needs);
}

Needs needs_of(const Model& model) {
  Needs needs(model.parameters.size());
  for (std::size_t i = 0; i < needs.size(); ++i) collect(model.parameters[i].value, model, needs[i]);
  return needs;
}

/// Of those that can be computed next, the one declared first. Shorter than `needs` when there are cycles.
std::vector<std::size_t> computable_order(const Needs& needs) {
  std::vector<std::size_t> missing(needs.size());
  std::vector<std::vector<std::size_t>> users(needs.size());
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
  for (std::size_t i = 0; i < needs.size(); ++i) {
    missing[i] = needs[i].size();
    for (const std::size_t need : needs[i]) users[need].push_back(i);
    if (missing[i] == 0) ready.push(i);
  }
  std::vector<std::size_t> order;
  while (!ready.empty()) {
    const std::size_t next = ready.top();
    ready.pop();
    order.push_back(next);
    for (const std::size_t user : users[next]) {
      if (--missing[user] == 0) ready.push(user);
    }
  }
  return order;
}

/// The first name; but a value that another file has set is what closes the cycle.
support::Span place_of(const std::vector<std::size_t>& cycle, const Reading& reading) {
  const auto file_of = [&](support::Span span) { return span.begin - reading.source.offset_in_file(span.begin); };
  const auto& parameters = reading.model.parameters;
  for (const std::size_t i : cycle) {
    if (file_of(parameters[i].value.span) != file_of(parameters[i].name.span)) return parameters[i].value.span;
  }
  return parameters[cycle.front()].name.span;
}

void report_cycle(const std::vector<std::size_t>& cycle, Reading& reading) {
  const auto& parameters = reading.model.parameters;
  std::string path;
  for (const std::size_t i : cycle) path += parameters[i].name.text + " -> ";
  path += parameters[cycle.front()].name.text;
  const std::string message =
      cycle.size() == 1 ? "the parameter is defined by itself" : "these parameters are defined by each other: " + path;
  reading.diagnostics.error(code::k_cyclic_parameters, place_of(cycle, reading), message, "give one of them a value");
}

/// Every parameter in `stuck` needs another of `stuck`: following the needs leads into a cycle.
void report_cycles(const Needs& needs, const std::set<std::size_t>& stuck, Reading& reading) {
  std::set<std::size_t> visited;
  for (const std::size_t start : stuck) {
    std::vector<std::size_t> path;
    std::size_t at = start;
    while (visited.insert(at).second) {
      path.push_back(at);
      at = *std::find_if(needs[at].begin(), needs[at].end(), [&](std::size_t need) { return stuck.count(need) > 0; });
    }
    const auto entry = std::find(path.begin(), path.end(), at);
    if (entry != path.end()) report_cycle({entry, path.end()}, reading);
  }
}

}  // namespace

void order_parameters(Reading& reading) {
  Model& model = reading.model;
  const Needs needs = needs_of(model);
  const std::vector<std::size_t> order = computable_order(needs);
  if (order.size() < needs.size()) {
    std::set<std::size_t> stuck;
    for (std::size_t i = 0; i < needs.size(); ++i) stuck.insert(i);
    for (const std::size_t i : order) stuck.erase(i);
    return report_cycles(needs, stuck, reading);
  }
  std::vector<Parameter> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(std::move(model.parameters[i]));
    sorted.back().is_formula = !needs[i].empty();
  }
  model.parameters = std::move(sorted);
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const auto symbol = model.symbols.find(model.parameters[i].name.text);  // none for a name that was refused
    if (symbol != model.symbols.end() && symbol->second.kind == SymbolKind::parameter) symbol->second.index = i;
  }
}

}  // namespace gaussgen::model
