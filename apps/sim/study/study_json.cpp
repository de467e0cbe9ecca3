#include "sim/study/study_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/page/page.hpp"
#include "sim/run/identity.hpp"

namespace gausssim {

namespace {

using Json = nlohmann::ordered_json;

/// What is no number is nothing.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

const char* word(PointStatus status) {
  return status == PointStatus::ok ? "ok" : status == PointStatus::failed ? "failed" : "refused";
}

double constraints_of(const Drift& drift) { return std::max(drift.positions, drift.velocities); }

Json drift_json(const Drift& drift) {
  Json json = Json::object();
  if (drift.has_energy)
    json["energy"] = number(drift.energy_scale > 0 ? drift.energy / drift.energy_scale : drift.energy);
  if (drift.has_constraints) json["constraints"] = number(constraints_of(drift));
  return json;
}

Json point_json(const Point& point, const StudyProblem& problem) {
  const Setting& setting = point.candidate.setting;
  const MethodInfo* const method = find_method(setting.method);
  const Form& form = problem.forms[point.candidate.form];
  Json json;
  json["id"] = point.id;
  json["method"] = setting.method;
  json["library"] = method == nullptr ? "" : method->library;
  json["formulation"] = form.formulation;
  json["code"] = form.code;
  json["number"] = setting.number;
  json["projection"] = name_of(setting.projection);
  json["engine"] = "compiled";
  json["tolerance"] = setting.tolerance > 0 ? number(setting.tolerance) : Json(nullptr);
  json["step"] = setting.step > 0 ? number(setting.step) : Json(nullptr);
  json["status"] = word(point.status);
  json["why"] = point.why;
  json["error"] = point.error ? number(point.error->value) : Json(nullptr);
  json["worst_output"] = point.error ? Json(point.error->output) : Json(nullptr);
  const bool is_timed = point.status == PointStatus::ok;
  json["time_s"] = is_timed ? number(point.time) : Json(nullptr);
  json["time_min_s"] = is_timed ? number(point.least_time) : Json(nullptr);
  json["time_max_s"] = is_timed ? number(point.most_time) : Json(nullptr);
  json["repeats"] = point.repeats;
  json["calls"] = point.calls;
  json["steps"] = point.steps;
  json["rejected"] = point.rejected;
  json["drift"] = drift_json(point.drift);
  json["pareto"] = point.is_on_front;
  json["is_default"] = point.candidate.is_default;
  return json;
}

std::string numbers_of(const Form& form) {
  std::vector<std::string> names;
  for (const std::string& scalar : form.scalars) names.push_back(number_of(scalar));
  return fmt::format("{}", fmt::join(names, ", "));
}

Json build_json(const Form& form) {
  const bool is_usual = form.code == "optimised";
  return {{"formulation", is_usual ? form.formulation : form.formulation + ", " + form.code},
          {"number", numbers_of(form)},
          {"generate_s", number(form.model.generate_seconds)},
          {"compile_s", form.times.was_cached || !form.engine ? Json(nullptr) : number(form.times.compile)},
          {"operations", form.model.operations > 0 ? Json(form.model.operations) : Json(nullptr)}};
}

/// Enough digits for a picture.
double for_eyes(double value) { return std::stod(fmt::format("{:.6g}", value)); }

template <class List>
Json places(const List& list) {
  Json json = Json::array();
  for (const auto& entry : list) {
    bool is_known = true;
    for (const double value : entry) is_known = is_known && std::isfinite(value);
    if (!is_known) {
      json.push_back(nullptr);
      continue;
    }
    Json numbers = Json::array();
    for (const double value : entry) numbers.push_back(for_eyes(value));
    json.push_back(numbers);
  }
  return json;
}

/// Boxes of one size but for what is seen to roll: a model says how heavy bodies are, and not how large.
Json shape_json(const Motion::Body& body, double edge) {
  using Shape = Motion::Body::Shape;
  constexpr double k_thickness = 0.12;  // of the radius
  if (body.shape == Shape::ball) return {{"kind", "sphere"}, {"radius", for_eyes(body.radius)}};
  if (body.shape == Shape::disc)
    return {{"kind", "cylinder"}, {"radius", for_eyes(body.radius)}, {"length", for_eyes(k_thickness * body.radius)}};
  if (body.orientation.empty() || !(edge > 0)) return {{"kind", "point"}};
  return {{"kind", "box"}, {"size", {edge, edge, edge}}};
}

Json body_json(const Motion::Body& body, double edge) {
  Json json{{"name", body.name}, {"position", places(body.position)}};
  json["shape"] = shape_json(body, edge);
  if (!body.orientation.empty()) json["orientation"] = places(body.orientation);
  return json;
}

Json motion_json(const Motion& motion) {
  Json json{
      {"t", numbers(motion.t)}, {"bodies", Json::array()}, {"lines", Json::array()}, {"reactions", Json::array()}};
  if (motion.up) json["up"] = *motion.up;
  for (const Motion::Body& body : motion.bodies) json["bodies"].push_back(body_json(body, motion.edge));
  for (const Motion::Line& line : motion.lines) {
    Json points = Json::array();
    for (const auto& one : line.points) points.push_back(places(one));
    json["lines"].push_back({{"name", line.name}, {"points", points}});
  }
  for (const Motion::Force& force : motion.forces) {
    json["reactions"].push_back({{"name", force.name},
                                 {"body", force.body.empty() ? Json(nullptr) : Json(force.body)},
                                 {"at", places(force.at)},
                                 {"force", places(force.force)},
                                 {"unit", force.unit}});
  }
  return json;
}

Json reference_json(const StudyReference& reference) {
  return {{"kind", reference.kind}, {"methods", reference.methods}, {"agreement", number(reference.agreement)}};
}

Json problem_json(const StudyProblem& problem) {
  const PreparedModel& model = problem.forms.front().model;
  Json json;
  json["name"] = problem.name;
  json["about"] = model.scene.about.empty() ? model.model.unit.about : model.scene.about;
  json["file"] = problem.file;
  json["identity"] = identity_of_problem(model);
  json["formulations"] = Json::array();
  for (const Form& form : problem.forms) {
    if (form.is_of_scene)
      json["formulations"].push_back({{"name", form.formulation}, {"identity", identity_of_problem(form.model)}});
  }
  if (!problem.scene.empty()) json["scene"] = problem.scene;
  if (!problem.why.empty()) json["why"] = problem.why;
  json["duration"] = model.span.duration;
  json["samples"] = model.span.samples;
  json["outputs"] = Json::array();
  for (std::size_t i = 0; i < model.columns.columns.size(); ++i) {
    const Column& column = model.columns.columns[i];
    const bool is_known = i < problem.ranges.size();
    const auto known = [&](auto value) { return is_known ? number(static_cast<double>(value())) : Json(nullptr); };
    json["outputs"].push_back({{"name", column.name},
                               {"unit", column.unit},
                               {"range", known([&] { return problem.ranges[i]; })},
                               {"scale", known([&] { return problem.reference.yardstick.scale(i); })}});
  }
  json["reference"] = problem.why.empty() ? reference_json(problem.reference) : Json(nullptr);
  json["builds"] = Json::array();
  for (const Form& form : problem.forms) json["builds"].push_back(build_json(form));
  json["points"] = Json::array();
  for (const Point& point : problem.points) json["points"].push_back(point_json(point, problem));
  json["drifts"] = Json::array();
  for (const DriftTrace& trace : problem.drifts) {
    Json one = {{"point", trace.point}, {"t", numbers(trace.t)}};
    if (!trace.energy.empty()) one["energy"] = numbers(trace.energy);
    if (!trace.constraints.empty()) one["constraints"] = numbers(trace.constraints);
    json["drifts"].push_back(std::move(one));
  }
  json["lanes"] = Json::array();
  for (const LanesRow& row : problem.lanes) {
    json["lanes"].push_back({{"number", row.number},
                             {"lanes", row.lanes},
                             {"threads", row.threads},
                             {"trajectories", row.trajectories},
                             {"trajectories_per_s", number(row.trajectories_per_s)},
                             {"ratio", number(row.ratio)}});
  }
  if (!problem.effects.is_null()) json["effects"] = problem.effects;
  if (problem.motion) json["motion"] = motion_json(*problem.motion);
  return json;
}

}  // namespace

bool was_interrupted(const std::vector<StudyProblem>& problems, const StudyOptions& options) {
  return problems.size() < options.files.size() || (!problems.empty() && problems.back().was_interrupted);
}

nlohmann::ordered_json study_json(const std::vector<StudyProblem>& problems, const StudyOptions& options) {
  Json json = head_of_study();
  json["budget_s"] = options.budget;
  json["interrupted"] = was_interrupted(problems, options);
  json["problems"] = Json::array();
  for (const StudyProblem& problem : problems) json["problems"].push_back(problem_json(problem));
  return json;
}

std::string study_csv(const std::vector<StudyProblem>& problems) {
  std::string text =
      "problem,formulation,code,number,method,projection,tolerance,step [s],status,error,worst_output,time "
      "[s],calls,steps,rejected,on_front,why\n";
  for (const StudyProblem& problem : problems) {
    for (const Point& point : problem.points) {
      const Setting& setting = point.candidate.setting;
      const Form& form = problem.forms[point.candidate.form];
      const auto or_nothing = [](bool is_there, double value) {
        return is_there ? fmt::format("{}", value) : std::string();
      };
      text +=
          fmt::format("{},\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\"\n", problem.name, form.formulation,
                      form.code, setting.number, setting.method, name_of(setting.projection),
                      or_nothing(setting.tolerance > 0, setting.tolerance), or_nothing(setting.step > 0, setting.step),
                      word(point.status), or_nothing(point.error.has_value(), point.error ? point.error->value : 0),
                      point.error ? point.error->output : "", or_nothing(point.status == PointStatus::ok, point.time),
                      point.calls, point.steps, point.rejected, point.is_on_front ? 1 : 0, point.why);
    }
  }
  return text;
}

}  // namespace gausssim
