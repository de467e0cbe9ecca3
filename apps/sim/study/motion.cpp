#include "sim/study/motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/run/error_estimate.hpp"

namespace gausssim {

namespace {

constexpr long k_most_samples = 301;  ///< eyes see no more

/// The numbers of a run by their names.
class Table {
 public:
  Table(const Rows& rows, const Columns& columns) : rows_(rows) {
    for (std::size_t i = 0; i < columns.columns.size(); ++i) place_[columns.columns[i].name] = i;
  }

  bool has(const std::string& name) const { return place_.count(name) != 0; }
  double at(long k, const std::string& name) const { return static_cast<double>(rows_.at(k, place_.at(name))); }
  Place vector(long k, const std::string& name) const {
    return {at(k, name + "[0]"), at(k, name + "[1]"), at(k, name + "[2]")};
  }
  Eigen::Matrix3d matrix(long k, const std::string& name) const {
    Eigen::Matrix3d result;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) result(i, j) = at(k, name + "[" + std::to_string(i) + "][" + std::to_string(j) + "]");
    return result;
  }
  long samples() const { return rows_.samples(); }

 private:
  const Rows& rows_;
  std::map<std::string, std::size_t> place_;
};

struct Joint {
  std::string name;
  std::vector<Place> position;
};

Eigen::Vector3d vector_of(const Place& place) { return {place[0], place[1], place[2]}; }

bool starts_with(const std::string& text, const std::string& begin) { return text.rfind(begin, 0) == 0; }

/// What stands between `begin` and the last `end`; empty where it does not.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t last = text.rfind(end);
  const bool fits = starts_with(text, begin) && last != std::string::npos && last >= begin.size();
  return fits ? text.substr(begin.size(), last - begin.size()) : "";
}

class Reader {
 public:
  Reader(const Columns& columns, const Rows& rows) : columns_(columns), table_(rows, columns) {}

  Motion read() {
    for (const Column& column : columns_.columns) {
      if (const std::string name = between(column.name, "poses.", ".position[0]"); !name.empty()) add_pose(name);
    }
    measure();
    for (const Motion::Body& body : motion_.bodies) add_lines(body);
    for (const Column& column : columns_.columns) add_force(column);
    return std::move(motion_);
  }

 private:
  std::vector<Place> track(const std::string& name) const {
    std::vector<Place> all;
    for (long k = 0; k < table_.samples(); ++k) all.push_back(table_.vector(k, name));
    return all;
  }

  void add_pose(const std::string& name) {
    const std::string whole = "poses." + name;
    if (starts_with(name, "at_")) return joints_.push_back({name.substr(3), track(whole + ".position")});
    Motion::Body body{name, track(whole + ".position"), {}};
    for (long k = 0; table_.has(whole + ".rotation[0][0]") && k < table_.samples(); ++k) {
      const Eigen::Quaterniond turn(table_.matrix(k, whole + ".rotation"));
      body.orientation.push_back({turn.w(), turn.x(), turn.y(), turn.z()});
    }
    motion_.bodies.push_back(std::move(body));
  }

  void measure() {
    Eigen::AlignedBox3d room;
    const auto look = [&](const std::vector<Place>& track) {
      for (const Place& place : track)
        if (vector_of(place).allFinite()) room.extend(vector_of(place));
    };
    for (const Motion::Body& body : motion_.bodies) look(body.position);
    for (const Joint& joint : joints_) look(joint.position);
    motion_.size = room.isEmpty() ? 0 : room.diagonal().norm();
  }

  /// A joint is a point of a body where it does not move against it.
  bool is_part(const Joint& joint, const Motion::Body& body) const {
    const auto seen = [&](std::size_t k) -> Eigen::Vector3d {
      const Eigen::Vector3d way = vector_of(joint.position[k]) - vector_of(body.position[k]);
      const auto& [w, x, y, z] = body.orientation[k];
      return Eigen::Quaterniond(w, x, y, z).conjugate() * way;
    };
    if (body.orientation.empty()) return false;
    constexpr double k_rounding = 1e-6;  ///< of a run, and of turns from matrices
    const Eigen::Vector3d first = seen(0);
    for (std::size_t k = 1; k < body.position.size(); ++k)
      if (!((seen(k) - first).norm() <= k_rounding * motion_.size)) return false;
    return true;
  }

  void add_lines(const Motion::Body& body) {
    Motion::Line line{body.name, std::vector<std::vector<Place>>(body.position.size())};
    for (const Joint& joint : joints_) {
      if (!is_part(joint, body)) continue;
      for (std::size_t k = 0; k < body.position.size(); ++k) {
        if (!line.points[k].empty()) line.points[k].push_back(body.position[k]);
        line.points[k].push_back(joint.position[k]);
      }
    }
    if (line.points.empty() || line.points.front().empty()) return;
    if (line.points.front().size() == 1) {
      for (std::size_t k = 0; k < body.position.size(); ++k) line.points[k].push_back(body.position[k]);
    }
    motion_.lines.push_back(std::move(line));
  }

  void add_force(const Column& column) {
    if (const std::string joint = between(column.name, "joint_reactions.", ".force[0]"); !joint.empty()) {
      const auto found =
          std::find_if(joints_.begin(), joints_.end(), [&](const Joint& one) { return one.name == joint; });
      if (found != joints_.end()) add(joint, "", column, found->position);
      return;
    }
    const std::string constraint = between(column.name, "reaction_forces.", ".force_on_");
    if (constraint.empty() || column.name.compare(column.name.size() - 3, 3, "[0]") != 0) return;
    const std::size_t begin = column.name.rfind(".force_on_") + std::string(".force_on_").size();
    const std::string name = column.name.substr(begin, column.name.size() - 3 - begin);
    for (const Motion::Body& body : motion_.bodies)
      if (body.name == name) return add(constraint, name, column, body.position);
  }

  void add(const std::string& name, const std::string& body, const Column& column, const std::vector<Place>& at) {
    const std::string vector = column.name.substr(0, column.name.size() - 3);
    motion_.forces.push_back({name, body, column.unit, at, track(vector)});
  }

  const Columns& columns_;
  Table table_;
  std::vector<Joint> joints_;
  Motion motion_;
};

}  // namespace

std::optional<Motion> motion_of(const PreparedModel& model, const Engine& engine, const Setting& setting) {
  PreparedModel seen = model;
  seen.span.samples = std::min(model.span.samples, k_most_samples);
  std::vector<Word> wanted;
  for (const std::string& group : output_names(model.model)) {
    if (group == "poses" || group == "reaction_forces" || group == "joint_reactions") wanted.push_back({group, {}});
  }
  const bool has_poses = std::any_of(wanted.begin(), wanted.end(), [](const Word& one) { return one.text == "poses"; });
  if (!has_poses) return std::nullopt;
  gaussgen::support::Diagnostics none;
  seen.columns = choose_columns(model.model, wanted, none);
  Rows rows(seen.columns.columns.size(), seen.span.samples);
  Listeners listeners;
  std::vector<double> times;
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { rows.set(k, row); };
  listeners.on_drift = [&](double t, double, double) { times.push_back(t); };
  simulate(seen, engine, setting, listeners);
  if (rows.samples() < 2) return std::nullopt;
  Motion motion = Reader(seen.columns, rows).read();
  motion.t = std::move(times);
  return motion;
}

}  // namespace gausssim
