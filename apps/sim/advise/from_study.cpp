#include "sim/advise/from_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/files.hpp"
#include "sim/methods/methods.hpp"
#include "sim/run/identity.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using Json = nlohmann::json;

constexpr double k_margin = 0.5;
constexpr double k_most_steps = 1e15;     ///< that anybody has counted
constexpr double k_agreement = 1.0 / 20;  ///< of the error: what a reference may be off by

std::string text_at(const Json& point, const char* key) {
  const auto found = point.find(key);
  return found != point.end() && found->is_string() ? found->get<std::string>() : "";
}

double number_at(const Json& point, const char* key) {
  const auto found = point.find(key);
  return found != point.end() && found->is_number() ? found->get<double>() : 0;
}

bool is_timed(const Json& point) {
  const auto has = [&](const char* key) { return point.contains(key) && point[key].is_number(); };
  if (text_at(point, "status") != "ok" || !has("error") || !has("time_s")) return false;
  if (!(number_at(point, "tolerance") > 0) && !(number_at(point, "step") > 0)) return false;
  // Whoever has edited the study may have made anything of it.
  const MethodInfo* const method = find_method(text_at(point, "method"));
  return method != nullptr && point["error"].get<double>() >= 0 && point["time_s"].get<double>() > 0;
}

StudyPoint point_of(const Json& point) {
  StudyPoint result{text_at(point, "formulation"), text_at(point, "code"),       text_at(point, "method"),
                    text_at(point, "number"),      text_at(point, "projection"), number_at(point, "tolerance"),
                    number_at(point, "step"),      number_at(point, "error"),    number_at(point, "time_s")};
  result.steps = static_cast<long>(std::min(number_at(point, "steps"), k_most_steps));
  return result;
}

/// How good the reference is: infinite where there is none.
double agreement_of(const Json& problem) {
  const auto reference = problem.find("reference");
  const bool is_there = reference != problem.end() && reference->is_object() && reference->contains("agreement") &&
                        (*reference)["agreement"].is_number();
  return is_there ? (*reference)["agreement"].get<double>() : std::numeric_limits<double>::infinity();
}

/// What a study cannot say anything of this problem for; empty: it can.
std::string difference(const Json& problem, const PreparedModel& prepared) {
  const double duration = number_at(problem, "duration");
  if (!(std::abs(duration - prepared.span.duration) <= 1e-12 * prepared.span.duration))
    return fmt::format("it lasts {:.6g} s, and here {:.6g} s", duration, prepared.span.duration);
  std::vector<std::string> there, here;
  for (const Json& output : problem.value("outputs", Json::array()))
    if (output.is_object()) there.push_back(text_at(output, "name"));
  for (const Column& column : prepared.columns.columns) here.push_back(column.name);
  if (there != here) return "it has other outputs";
  if (text_at(problem, "identity") == identity_of_problem(prepared)) return "";
  return prepared.scene.code ? "the model, a value in it, its start, its number of samples, or how the code is written "
                               "out is not the same"
                             : "the model, a value in it, its start or its number of samples is not the same";
}

/// Other descriptions of the motion, of which runs of the study may be. Returns what is not the same now; empty: nothing.
std::string difference_of_forms(const Json& problem, const Scene& scene, const FormOfScene& prepared_form) {
  std::vector<std::pair<std::string, std::string>> there, here;
  for (const Json& form : problem.value("formulations", Json::array()))
    if (form.is_object()) there.emplace_back(text_at(form, "name"), text_at(form, "identity"));
  for (const GivenForm& form : scene.forms) {
    const auto prepared = prepared_form(form.name.text);
    if (!prepared) return fmt::format("its formulation '{}' cannot be derived now", form.name.text);
    here.emplace_back(form.name.text, identity_of_problem(*prepared));
  }
  if (there.size() != here.size()) return "it has other formulations";
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (here[i].first != there[i].first) return "it has other formulations";
    if (here[i].second != there[i].second) return fmt::format("its formulation '{}' is not the same", here[i].first);
  }
  return "";
}

/// What the scene says is kept.
bool is_allowed(const StudyPoint& point, const Scene& scene) {
  const auto fits = [](const std::optional<Word>& wanted, const std::string& has) {
    return !wanted || wanted->text == has;
  };
  return (chooses_method(scene) || scene.method->text == point.method) && fits(scene.number, point.number) &&
         fits(scene.projection, point.projection) && fits(scene.code, point.code);
}

Json read(const std::string& path) {
  Json study = Json::parse(cli::read_source(path).text(), nullptr, false);
  if (!study.is_object() || study.value("format", Json()) != 1 || !study["problems"].is_array())
    throw cli::FileError(path + " is no study of gauss-sim (docs/study-format.md)");
  return study;
}

}  // namespace

StudyPoint cheapest_in_study(const std::string& path, const PreparedModel& prepared, const FormOfScene& prepared_form,
                             double error, std::string& why) {
  const Json study = read(path);
  double least_error = std::numeric_limits<double>::infinity(), agreement = 0;
  StudyPoint best;
  best.seconds = std::numeric_limits<double>::infinity();
  std::string why_no_reference;
  bool is_known = false;
  for (const Json& problem : study["problems"]) {
    if (!problem.is_object() || text_at(problem, "name") != prepared.name() || !problem["points"].is_array()) continue;
    is_known = true;
    std::string other = difference(problem, prepared);
    if (other.empty()) other = difference_of_forms(problem, prepared.scene, prepared_form);
    if (!other.empty())
      throw cli::FileError(fmt::format("{}: '{}' is another problem there: {}", path, prepared.name(), other));
    agreement = agreement_of(problem);
    why_no_reference = text_at(problem, "why");
    for (const Json& one : problem["points"]) {
      if (!is_timed(one)) continue;
      const StudyPoint point = point_of(one);
      if (!is_allowed(point, prepared.scene)) continue;
      least_error = std::min(least_error, point.error);
      if (point.error <= k_margin * error && point.seconds < best.seconds) best = point;
    }
  }
  if (!is_known) throw cli::FileError(fmt::format("{} has no problem '{}'", path, prepared.name()));
  if (std::isinf(agreement))
    why = fmt::format("the study has no reference{}{}", why_no_reference.empty() ? "" : ": ", why_no_reference);
  else if (!(agreement <= k_agreement * error))
    why = fmt::format("the reference of the study is good to {:.1e}, and an error of {:.1e} takes {:.1e}", agreement,
                      error, k_agreement * error);
  else if (std::isinf(least_error))
    why = "the study has no run that arrives with what is asked for";
  else if (best.method.empty())
    why = fmt::format("no run of the study delivers an error of {:.1e} with a margin of two; the best has {:.1e}",
                      error, least_error);
  return best;
}

}  // namespace gausssim
