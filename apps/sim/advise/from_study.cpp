#include "sim/advise/from_study.hpp"

#include <fmt/format.h>

#include <limits>

#include "cli/files.hpp"
#include "sim/methods/methods.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using Json = nlohmann::json;

constexpr double k_margin = 0.5;

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
  // Whoever has edited the study may have made anything of it.
  const MethodInfo* const method = find_method(text_at(point, "method"));
  return method != nullptr && point["error"].get<double>() >= 0 && point["time_s"].get<double>() > 0;
}

StudyPoint point_of(const Json& point) {
  return {text_at(point, "formulation"), text_at(point, "code"),       text_at(point, "method"),
          text_at(point, "number"),      text_at(point, "projection"), number_at(point, "tolerance"),
          number_at(point, "step"),      number_at(point, "error"),    number_at(point, "time_s")};
}

Json read(const std::string& path) {
  Json study = Json::parse(cli::read_source(path).text(), nullptr, false);
  if (!study.is_object() || study.value("format", Json()) != 1 || !study["problems"].is_array())
    throw cli::FileError(path + " is no study of gauss-sim (docs/study-format.md)");
  return study;
}

}  // namespace

StudyPoint cheapest_in_study(const std::string& path, const std::string& name, double error, std::string& why) {
  const Json study = read(path);
  double least_error = std::numeric_limits<double>::infinity();
  StudyPoint best;
  best.seconds = std::numeric_limits<double>::infinity();
  bool is_known = false;
  for (const Json& problem : study["problems"]) {
    if (!problem.is_object() || text_at(problem, "name") != name || !problem["points"].is_array()) continue;
    is_known = true;
    for (const Json& one : problem["points"]) {
      if (!is_timed(one)) continue;
      const StudyPoint point = point_of(one);
      least_error = std::min(least_error, point.error);
      if (point.error <= k_margin * error && point.seconds < best.seconds) best = point;
    }
  }
  if (!is_known) throw cli::FileError(fmt::format("{} has no problem '{}'", path, name));
  if (best.method.empty())
    why = fmt::format("no run of the study delivers an error of {:.1e} with a margin of two; the best has {:.1e}",
                      error, least_error);
  return best;
}

}  // namespace gausssim
