#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/overrides.hpp"
#include "cli/start.hpp"
#include "early_check.hpp"
#include "equilibrium.hpp"
#include "evaluate/decimal.hpp"
#include "linearisation.hpp"
#include "read_model.hpp"
#include "structure_check.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

using analysis::Complex;
using analysis::Mode;
using analysis::Real;
using Rows = std::vector<std::vector<std::string>>;

constexpr int k_digits_of_table = 6, k_digits_of_json = 17;
constexpr int k_start_digits = 17;
constexpr Real k_two_pi = 6.283185307179586476925286766559L;

int digits_of(const Options& options) {
  if (options.linear_digits != 0) return options.linear_digits;
  return options.format == Format::json ? k_digits_of_json : k_digits_of_table;
}

std::string text_of(Real value, int digits) {
  const evaluate::Arithmetic<cln::cl_F> arithmetic(2 * k_digits_of_json);
  return evaluate::to_decimal(arithmetic.number(evaluate::exact(value)), digits);
}

bool is_zero(const Mode& mode) { return mode.shape.size() == 0; }
bool is_oscillation(const Mode& mode) { return mode.eigenvalue.imag() != 0; }

std::string name_of_motion(const Linearisation& found) {
  return found.is_at_rest ? "equilibrium" : found.is_steady() ? "steady" : "neither";
}

std::vector<std::string> names_of(const Linearisation& found, const std::vector<std::size_t>& which) {
  std::vector<std::string> names;
  for (const std::size_t i : which) names.push_back(found.states[i].name);
  return names;
}

std::vector<std::string> names_of_states(const Linearisation& found) {
  std::vector<std::size_t> all(found.states.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return names_of(found, all);
}

/// "theta_dot" of the coordinate theta: what its row of A says.
std::string rate_of(const LinearState& state) { return "d/dt " + state.name; }

std::string aligned(const Rows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], row[j].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t j = 0; j < row.size(); ++j)
      line += j == 0 ? fmt::format(" {:<{}}", row[j], widths[j]) : fmt::format("  {:>{}}", row[j], widths[j]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string matrix_text(const Linearisation& found, const analysis::Matrix& matrix,
                        const std::vector<std::string>& columns, int digits) {
  Rows rows{{""}};
  rows[0].insert(rows[0].end(), columns.begin(), columns.end());
  for (std::size_t i = 0; i < found.states.size(); ++i) {
    rows.push_back({rate_of(found.states[i])});
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      rows.back().push_back(text_of(matrix(static_cast<Eigen::Index>(i), j), digits));
  }
  return aligned(rows);
}

/// What an eigenvalue means, in numbers; empty where it has none.
struct Figures {
  std::string frequency, damping, time;
};

Figures figures_of(const Mode& mode, int digits) {
  const Complex s = mode.eigenvalue;
  Figures figures;
  if (is_oscillation(mode)) {
    figures.frequency = text_of(std::abs(s.imag()) / k_two_pi, digits);
    figures.damping = text_of(-s.real() / std::abs(s), digits);
  }
  if (s.real() != 0) figures.time = text_of(1 / std::abs(s.real()), digits);
  return figures;
}

std::string motion_text(const Linearisation& found, int digits) {
  std::string text = "\nmotion\n  ";
  if (!found.is_steady()) {
    text += "neither an equilibrium nor steady; these change:\n";
    for (const std::size_t i : found.changing)
      text += fmt::format("  {} = {}\n", rate_of(found.states[i]), text_of(found.states[i].rate, digits));
    return text;
  }
  text += found.is_at_rest ? "equilibrium\n" : "steady\n";
  Rows moving;
  for (const LinearState& state : found.states) {
    if (state.is_coordinate && state.rate != 0) moving.push_back({rate_of(state), "= " + text_of(state.rate, digits)});
  }
  return text + (found.is_at_rest ? "" : aligned(moving));
}

std::string states_text(const Linearisation& found, int digits) {
  Rows rows;
  for (const LinearState& state : found.states) rows.push_back({state.name, text_of(state.value, digits), state.unit});
  std::string text = "\nstates x\n" + aligned(rows);
  if (!found.dependent.empty()) text += "  by constraints: " + support::joined(found.dependent) + "\n";
  return text;
}

bool has_no_effect(const Linearisation& found, const std::vector<std::size_t>& states) {
  return std::all_of(states.begin(), states.end(),
                     [&](std::size_t k) { return found.A.col(static_cast<Eigen::Index>(k)).isZero(0); });
}

std::string eigenvalues_text(const Linearisation& found, int digits) {
  Rows rows{{"", "real [1/s]", "imaginary", "frequency [Hz]", "damping ratio", "time constant [s]"}};
  std::size_t zeros = 0, number = 0;
  for (const Mode& mode : found.modes) {
    if (is_zero(mode)) ++zeros;
    if (is_zero(mode) || mode.eigenvalue.imag() < 0) continue;
    const Figures figures = figures_of(mode, digits);
    const std::string imaginary = is_oscillation(mode) ? "+-" + text_of(mode.eigenvalue.imag(), digits) : "";
    const std::string grows = mode.eigenvalue.real() > 0 ? " grows" : mode.eigenvalue.real() == 0 ? "neutral" : "";
    rows.push_back({std::to_string(++number), text_of(mode.eigenvalue.real(), digits), imaginary, figures.frequency,
                    figures.damping, figures.time + grows});
  }
  std::string text = "\neigenvalues\n" + (rows.size() > 1 ? aligned(rows) : std::string());
  if (zeros == 0) return text;
  text += fmt::format("  {} {} 0 (neutral)", zeros, zeros == 1 ? "is" : "are");
  if (!found.cyclic.empty())
    text += fmt::format(", {} of {} on which nothing else depends{}: {}", found.cyclic.size(),
                        found.cyclic.size() == 1 ? "a coordinate" : "coordinates",
                        has_no_effect(found, found.cyclic) ? "" : " beyond rounding of the largest effects",
                        support::joined(names_of(found, found.cyclic)));
  return text + "\n";
}

std::string modes_text(const Linearisation& found, int digits) {
  Rows rows{{""}};
  for (const std::string& name : names_of_states(found)) rows.push_back({name});
  std::size_t number = 0;
  for (const Mode& mode : found.modes) {
    if (is_zero(mode) || mode.eigenvalue.imag() < 0) continue;
    const bool is_complex = is_oscillation(mode);
    rows[0].push_back(std::to_string(++number));
    if (is_complex) rows[0].emplace_back("phase [rad]");
    for (std::size_t i = 0; i < found.states.size(); ++i) {
      const Complex entry = mode.shape[static_cast<Eigen::Index>(i)];
      rows[i + 1].push_back(text_of(is_complex ? std::abs(entry) : entry.real(), digits));
      if (is_complex) rows[i + 1].push_back(text_of(std::abs(entry) == 0 ? 0 : std::arg(entry), digits));
    }
  }
  return rows[0].size() == 1 ? "" : "\nmodes\n" + aligned(rows);
}

std::string table(const Linearisation& found, int digits) {
  std::string text = "status\n  ";
  text += (found.doubts.empty() ? "ok" : "not to be trusted: " + support::joined(found.doubts)) + "\n";
  text += motion_text(found, digits) + states_text(found, digits);
  text += "\nA\n" + matrix_text(found, found.A, names_of_states(found), digits);
  if (!found.inputs.empty()) text += "\nB\n" + matrix_text(found, found.B, found.inputs, digits);
  return text + eigenvalues_text(found, digits) + modes_text(found, digits);
}

nlohmann::ordered_json matrix_json(const analysis::Matrix& matrix, int digits) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    nlohmann::ordered_json row = nlohmann::ordered_json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(text_of(matrix(i, j), digits));
    rows.push_back(std::move(row));
  }
  return rows;
}

nlohmann::ordered_json mode_json(const Linearisation& found, const Mode& mode, int digits) {
  nlohmann::ordered_json entry;
  entry["real"] = text_of(mode.eigenvalue.real(), digits);
  entry["imaginary"] = text_of(mode.eigenvalue.imag(), digits);
  const Figures figures = figures_of(mode, digits);
  if (!figures.frequency.empty()) entry["frequency"] = figures.frequency;
  if (!figures.damping.empty()) entry["damping_ratio"] = figures.damping;
  if (!figures.time.empty()) entry["time_constant"] = figures.time;
  if (is_zero(mode)) return entry;
  for (std::size_t i = 0; i < found.states.size(); ++i) {
    const Complex part = mode.shape[static_cast<Eigen::Index>(i)];
    entry["mode"][found.states[i].name] = {text_of(part.real(), digits), text_of(part.imag(), digits)};
  }
  return entry;
}

std::string json(const Linearisation& found, const model::Model& model, const Options& options, int digits) {
  nlohmann::ordered_json document;
  document["model"] = model.name.text;
  document["digits"] = digits;
  document["time"] = options.time;
  document["status"] = found.doubts.empty() ? "ok" : support::joined(found.doubts);
  document["motion"] = name_of_motion(found);
  for (const LinearState& state : found.states) {
    nlohmann::ordered_json entry;
    entry["name"] = state.name;
    entry["value"] = text_of(state.value, digits);
    entry["rate"] = text_of(state.rate, digits);
    if (!state.unit.empty()) entry["unit"] = state.unit;
    document["states"].push_back(std::move(entry));
  }
  document["inputs"] = found.inputs;
  document["dependent"] = found.dependent;
  document["cyclic"] = names_of(found, found.cyclic);
  document["changing"] = names_of(found, found.changing);
  document["A"] = matrix_json(found.A, digits);
  document["B"] = matrix_json(found.B, digits);
  for (const Mode& mode : found.modes) document["eigenvalues"].push_back(mode_json(found, mode, digits));
  document["warnings"] = found.warnings;
  return document.dump(2) + "\n";
}

/// What --set names, as speeds and coordinates are called.
std::set<std::string> fixed_names(const std::vector<std::string>& assignments) {
  std::set<std::string> names;
  for (const std::string& assignment : assignments) {
    std::string name = assignment.substr(0, assignment.find('='));
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    const bool is_dot = name.rfind("dot(", 0) == 0 && name.back() == ')';
    names.insert(is_dot ? name.substr(4, name.size() - 5) + "_dot" : name);
  }
  return names;
}

const std::vector<std::string> k_stages{"derivation", "initial state", "equilibrium", "linearisation"};

}  // namespace

int linearize(const Options& options) {
  const support::Rational time = parse_time(options.time);
  std::optional<ReadingGuard> guard(options.messages);
  support::Source source = read_source(options.model);
  support::Diagnostics diagnostics;
  std::optional<model::Model> model = read_model(source, diagnostics, options.pipeline.choices);
  guard.reset();
  if (model) apply_overrides(options.overrides, *model);
  const int code = report(diagnostics, source, options.messages);
  if (!model || code != k_ok) return code;
  std::optional<DerivationGuard> derivation(std::in_place, k_stages, options.most_seconds, options.messages);
  support::Diagnostics structure;
  check_early(*model, {}, structure);
  if (structure.has_errors()) return report(structure, source, options.messages);
  Mechanics mechanics(*model, {});
  check_structure(mechanics, structure);
  derivation->finish_stage();
  if (!structure.has_errors()) set_start(mechanics, *model, time, k_start_digits, options, structure);
  if (const int found = report(structure, source, options.messages); found != k_ok) return found;
  const Preferences preferences(mechanics);
  derivation->finish_stage();
  std::vector<std::string> doubts;
  if (options.linearised_at == LinearisedAt::equilibrium) {
    const Equilibrium found = go_to_equilibrium(mechanics, *model, time, 2 * k_start_digits);
    if (!found.failure.empty()) return fail(found.failure, k_model_error, options.messages, found.remedy);
    doubts = found.doubts;
  }
  derivation->finish_stage();
  Linearisation found =
      linearise(mechanics, {preferences, options.linearised_at, time, fixed_names(options.overrides)});
  if (!found.failure.empty()) return fail(found.failure, k_model_error, options.messages);
  found.warnings.insert(found.warnings.begin(), doubts.begin(), doubts.end());
  derivation.reset();  // before anything is written
  const int digits = digits_of(options);
  write_standard_output(options.format == Format::json ? json(found, *model, options, digits) : table(found, digits));
  for (const std::string& warning : found.warnings) warn(warning, options.messages);
  return k_ok;
}

}  // namespace gaussgen::cli
