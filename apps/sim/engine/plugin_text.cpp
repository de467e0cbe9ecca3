#include "sim/engine/plugin_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "emit/cpp_printer.hpp"
#include "sim/engine/samples_text.hpp"
#include "sim/model/layout.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

/// What comes from the values in the model's file: the start, and what parameters are if nobody says so.
void remove_values(cpp::File& tree) {
  std::vector<cpp::Item> kept;
  for (cpp::Item& item : tree.items) {
    const auto* const function = std::get_if<cpp::Function>(&item);
    if (function != nullptr && is_of_start(function->name)) continue;
    if (auto* const type = std::get_if<cpp::Struct>(&item); type != nullptr) {
      if (type->name == "Parameters" || type->name == "Inputs") {
        for (cpp::Member& member : type->members) member.value.reset();
      }
    }
    kept.push_back(std::move(item));
  }
  tree.items = std::move(kept);
}

void remove_words(cpp::Struct& type) {
  type.comment.clear();
  for (cpp::Member& member : type.members) member.comment.clear();
  for (cpp::Struct& nested : type.nested) remove_words(nested);
}

void remove_words(cpp::Function& function) {
  function.comment.clear();
  const auto is_comment = [](const cpp::Statement& one) { return std::holds_alternative<cpp::Comment>(one); };
  auto& body = function.body;
  body.erase(std::remove_if(body.begin(), body.end(), is_comment), body.end());
}

/// `const State<S>&` as a type of the plugin, without const and &.
std::string plain_type(const std::string& type, const std::string& name_space, const std::string& scalar) {
  std::string text = type;
  if (text.rfind("const ", 0) == 0) text.erase(0, 6);
  if (!text.empty() && text.back() == '&') text.pop_back();
  if (text == "S") return scalar;
  const std::size_t open = text.find('<');
  return "::" + name_space + "::" + text.substr(0, open) + "<" + scalar + ">";
}

std::string entry(const cpp::Function& function, const std::string& name_space, const std::string& scalar) {
  const bool returns_struct = function.name == "prepare";
  std::string arguments;
  std::size_t i = 0;
  for (const cpp::Argument& argument : function.arguments) {
    const bool is_const = argument.type.rfind("const ", 0) == 0;
    arguments += fmt::format("{}*static_cast<{}{}*>(a[{}])", i == 0 ? "" : ", ", is_const ? "const " : "",
                             plain_type(argument.type, name_space, scalar), i);
    ++i;
  }
  const std::string call = fmt::format("::{}::{}({})", name_space, function.name, arguments);
  const std::string head = fmt::format("extern \"C\" GAUSS_SIM_VISIBLE int {}(const void*, void* const* a) {{\n",
                                       entry_symbol(function.name, scalar));
  if (!returns_struct) return head + "  return static_cast<int>(" + call + ");\n}\n";
  return head + fmt::format("  *static_cast<{}*>(a[{}]) = {};\n  return 0;\n}}\n",
                            plain_type(function.type, name_space, scalar), i, call);
}

/// A run by power series, where the header has them. `sampled`: what it finds at several samples at once; empty: nothing.
std::string series_entries(const std::string& name_space, const std::string& scalar, const std::string& sampled) {
  std::string text;
  std::vector<std::string> names = {"series_begin", "series_advance", "series_tell", "series_end"};
  if (!sampled.empty()) names.push_back(sampled);
  const char* const samples = sampled.empty() ? "" : ", gauss_sim_glue::Samples<GaussSimSampled>";
  for (std::size_t what = 0; what < names.size(); ++what) {
    text += fmt::format(
        "extern \"C\" GAUSS_SIM_VISIBLE int {}(const void*, void* const* a) {{\n"
        "  return gauss_sim_glue::call<GaussSimModel, {}, ::{}::TaylorSeries<{}>{}>({}, a);\n}}\n",
        entry_symbol(names[what], scalar), scalar, name_space, scalar, samples, what);
  }
  return text;
}

std::string length_of(const cpp::Struct& type, const std::string& member) {
  for (const cpp::Member& one : type.members)
    if (one.name == member && one.shape.size() == 1) return one.shape.front();
  return "";
}

/// The struct with the metric; empty where the header has none, or no rows to be pulled, or equations of positions beside constraints of velocities alone: nothing says there
/// which rows are which.
std::string metric_for_gains(const cpp::File& tree) {
  const cpp::Struct* const residuals = find_struct(tree, "Residuals");
  if (residuals == nullptr) return "";
  const std::string rows = length_of(*residuals, "velocity"), positions = length_of(*residuals, "position");
  if (rows.empty() || (!positions.empty() && positions != rows)) return "";
  for (const char* const type : {"LinearSystem", "MassMatrix"})
    if (find_struct(tree, type) != nullptr) return type;
  return "";
}

/// Rates with gains.
std::string gains_entries(const std::string& name_space, const std::string& scalar, const std::string& metric,
                          int usual_rank) {
  const std::string type =
      fmt::format("gauss_sim_glue::PulledBack<GaussSimModel, {0}, ::{1}::Residuals<{0}>, ::{1}::{2}<{0}>>", scalar,
                  name_space, metric);
  const auto entry = [&](const char* name, const std::string& self, const std::string& call) {
    return fmt::format(
        "extern \"C\" GAUSS_SIM_VISIBLE int {}(const void*{}, void* const* a) {{\n  return {}::{};\n}}\n",
        entry_symbol(name, scalar), self, type, call);
  };
  return entry("gains_begin", "", fmt::format("begin({}, a)", usual_rank)) +
         entry("gains_rates", " self", "rates(self, a)") + entry("gains_end", "", "end(a)");
}

/// What only methods in double call, or nobody in a hurry.
bool is_for_double(const std::string& function) {
  return function == "jacobian" || function == "project_positions" || function == "project_speeds";
}

}  // namespace

bool is_of_start(const std::string& function) { return function.rfind("initial_state", 0) == 0; }

void remove_words(cpp::File& tree) {
  const auto is_comment = [](const cpp::Item& item) { return std::holds_alternative<cpp::Comment>(item); };
  for (auto* const items : {&tree.before, &tree.items, &tree.after}) {
    items->erase(std::remove_if(items->begin(), items->end(), is_comment), items->end());
    for (cpp::Item& item : *items) {
      if (auto* const type = std::get_if<cpp::Struct>(&item)) remove_words(*type);
      if (auto* const function = std::get_if<cpp::Function>(&item)) remove_words(*function);
      if (auto* const constant = std::get_if<cpp::Constant>(&item)) constant->comment.clear();
      if (auto* const table = std::get_if<cpp::Table>(&item)) table->comment.clear();
    }
  }
}

bool uses_quad(const PluginRequest& request) {
  return std::find(request.scalars.begin(), request.scalars.end(), "__float128") != request.scalars.end();
}

std::string symbol_part(std::string scalar) {
  std::replace(scalar.begin(), scalar.end(), ' ', '_');
  return scalar;
}

std::string entry_symbol(const std::string& function, const std::string& scalar) {
  return "gauss_sim_" + function + "_" + symbol_part(scalar);
}

std::string plugin_header(cpp::File tree) {
  remove_words(tree);
  remove_values(tree);
  return cpp::print(tree) + "\n#define GAUSS_SIM_VISIBLE __attribute__((visibility(\"default\")))\n\n";
}

std::string plugin_text(const cpp::File& tree, const PluginRequest& request) {
  std::string text = plugin_header(tree);
  if (uses_quad(request)) text += quad_runtime();
  const bool has_series = find_function(tree, "taylor") != nullptr;
  const std::string metric = request.usual_rank ? metric_for_gains(tree) : "";
  if (has_series) text += series_runtime();
  if (!metric.empty()) text += gains_runtime();
  if (has_series || !metric.empty()) text += "\nGAUSS_MODEL(GaussSimModel, ::" + tree.name_space + ");\n";
  const std::string sampled = has_series && request.sampled ? sampled_text(tree, *request.sampled) : "";
  if (!sampled.empty()) text += std::string(samples_runtime()) + sampled;
  std::vector<std::string> names;
  for (const std::string& name : request.functions) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (const std::string& scalar : request.scalars) {
    const bool takes_several = !sampled.empty() && scalar == "double";
    if (has_series)
      text += series_entries(tree.name_space, scalar, takes_several ? samples_name(*request.sampled) : "");
    if (!metric.empty()) text += gains_entries(tree.name_space, scalar, metric, *request.usual_rank);
    for (const std::string& name : names) {
      if (scalar != "double" && is_for_double(name)) continue;
      if (const cpp::Function* const function = find_function(tree, name))
        text += entry(*function, tree.name_space, scalar);
    }
  }
  return text;
}

}  // namespace gausssim
