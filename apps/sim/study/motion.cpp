#include "sim/study/motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include "sim/run/error_estimate.hpp"
#include "sim/study/places.hpp"
#include "sim/study/rods.hpp"
#include "sim/study/round_body.hpp"

namespace gausssim {

namespace {

constexpr long k_most_samples = 301;  ///< eyes see no more
constexpr double k_rounding = 1e-6;   ///< of a run, and of turns from matrices, beside the room of a motion

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

/// Of a joint, of a closing of a loop, or of a reaction.
struct Track {
  std::string name;
  std::vector<Place> position;
};

bool starts_with(const std::string& text, const std::string& begin) { return text.rfind(begin, 0) == 0; }

/// What stands between `begin` and the last `end`; empty where it does not.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t last = text.rfind(end);
  const bool fits = starts_with(text, begin) && last != std::string::npos && last >= begin.size();
  return fits ? text.substr(begin.size(), last - begin.size()) : "";
}

const Track* find(const std::vector<Track>& tracks, const std::string& name) {
  const auto found = std::find_if(tracks.begin(), tracks.end(), [&](const Track& one) { return one.name == name; });
  return found == tracks.end() ? nullptr : &*found;
}

/// Of the constraint that a row is, or is one direction of: pin, or pin_x of pin.
const Track* find_of_row(const std::vector<Track>& tracks, const std::string& row) {
  const Track* const whole = find(tracks, row);
  const bool is_direction = row.size() > 2 && row[row.size() - 2] == '_';
  return whole != nullptr || !is_direction ? whole : find(tracks, row.substr(0, row.size() - 2));
}

void turn_to(const Place& axis, Motion::Body& body) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), vector_of(axis));
  for (auto& orientation : body.orientation) {
    const auto& [w, x, y, z] = orientation;
    const Eigen::Quaterniond whole = Eigen::Quaterniond(w, x, y, z) * turn;
    orientation = {whole.w(), whole.x(), whole.y(), whole.z()};
  }
}

class Reader {
 public:
  Reader(const Columns& columns, const Rows& rows) : columns_(columns), table_(rows, columns) {}

  Motion read() {
    for (const Column& column : columns_.columns) {
      if (const std::string name = between(column.name, "poses.", ".position[0]"); !name.empty()) add_pose(name);
    }
    room_ = diagonal(0, table_.samples());
    motion_.edge = edge();
    for (const Motion::Body& body : motion_.bodies) add_lines(body);
    for (const Column& column : columns_.columns) add_force(column);
    std::set<std::string> constraints;
    for (const Motion::Force& one : motion_.forces)
      if (find(closings_, one.name) == nullptr) constraints.insert(one.name);
    add_rods(constraints, k_rounding, motion_);
    for (Motion::Body& body : motion_.bodies) give_shape(body);
    drop_idle_forces();
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
    for (const auto& [begin, tracks] : {std::pair{"at_", &joints_}, {"closing_", &closings_}, {"where_", &places_}}) {
      if (starts_with(name, begin))
        return tracks->push_back({name.substr(std::strlen(begin)), track(whole + ".position")});
    }
    Motion::Body body{name, track(whole + ".position"), {}};
    for (long k = 0; table_.has(whole + ".rotation[0][0]") && k < table_.samples(); ++k) {
      const Eigen::Quaterniond turn(table_.matrix(k, whole + ".rotation"));
      body.orientation.push_back({turn.w(), turn.x(), turn.y(), turn.z()});
    }
    motion_.bodies.push_back(std::move(body));
  }

  /// Of the box of all places at samples from `begin` to `end`.
  double diagonal(long begin, long end) const {
    Eigen::AlignedBox3d box;
    const auto look = [&](const std::vector<Place>& track) {
      for (long k = begin; k < end; ++k)
        if (const auto place = vector_of(track[static_cast<std::size_t>(k)]); place.allFinite()) box.extend(place);
    };
    for (const Motion::Body& body : motion_.bodies) look(body.position);
    for (const auto* const tracks : {&joints_, &closings_, &places_})
      for (const Track& one : *tracks) look(one.position);
    return box.isEmpty() ? 0 : box.diagonal().norm();
  }

  /// In proportion to the mechanism, which may be small beside its way. A lone body reaches to where it is held, if that is known.
  double edge() const {
    constexpr double k_part_of_mechanism = 0.06, k_part_of_room = 0.04;
    double mechanism = 0;
    for (long k = 0; k < table_.samples(); ++k) mechanism = std::max(mechanism, diagonal(k, k + 1));
    const bool is_alone = motion_.bodies.size() == 1 && joints_.empty();
    return mechanism > 0 ? (is_alone ? mechanism : k_part_of_mechanism * mechanism) : k_part_of_room * room_;
  }

  /// A joint is a point of a body where it does not move against it.
  bool is_part(const Track& joint, const Motion::Body& body) const {
    const auto seen = [&](std::size_t k) -> Eigen::Vector3d {
      const Eigen::Vector3d way = vector_of(joint.position[k]) - vector_of(body.position[k]);
      const auto& [w, x, y, z] = body.orientation[k];
      return Eigen::Quaterniond(w, x, y, z).conjugate() * way;
    };
    if (body.orientation.empty()) return false;
    const Eigen::Vector3d first = seen(0);
    for (std::size_t k = 1; k < body.position.size(); ++k)
      if (!((seen(k) - first).norm() <= k_rounding * room_)) return false;
    return true;
  }

  /// From the mass centre to the first joint, and to each other one and back.
  void add_lines(const Motion::Body& body) {
    std::vector<const Track*> ends;
    for (const auto* const tracks : {&joints_, &closings_})
      for (const Track& joint : *tracks)
        if (is_part(joint, body)) ends.push_back(&joint);
    if (ends.empty()) return;
    Motion::Line line{body.name, {}};
    for (std::size_t k = 0; k < body.position.size(); ++k) {
      std::vector<Place> points{ends.front()->position[k], body.position[k]};
      for (std::size_t i = 1; i < ends.size(); ++i) {
        if (i > 1) points.push_back(body.position[k]);
        points.push_back(ends[i]->position[k]);
      }
      line.points.push_back(std::move(points));
    }
    motion_.lines.push_back(std::move(line));
  }

  void give_shape(Motion::Body& body) const {
    for (const Track& place : places_) {
      const auto found = touched_.count({place.name, body.name}) != 0
                             ? round_body(body, place.position, k_rounding * room_)
                             : std::nullopt;
      if (!found) continue;
      body.radius = found->radius;
      body.shape = found->axis ? Motion::Body::Shape::disc : Motion::Body::Shape::ball;
      if (found->axis) turn_to(*found->axis, body);
      return;
    }
  }

  void add_force(const Column& column) {
    if (const std::string joint = between(column.name, "joint_reactions.", ".force[0]"); !joint.empty()) {
      if (const Track* const found = find(joints_, joint)) add(joint, "", column, found->position);
      return;
    }
    const std::string row = between(column.name, "reaction_forces.", ".force_on_");
    if (row.empty() || column.name.compare(column.name.size() - 3, 3, "[0]") != 0) return;
    const std::size_t begin = column.name.rfind(".force_on_") + std::string(".force_on_").size();
    const std::string name = column.name.substr(begin, column.name.size() - 3 - begin);
    if (const Track* const closing = find_of_row(closings_, row)) {
      // The other side feels the opposite.
      if (felt_by_.emplace(closing->name, name).first->second == name)
        add(closing->name, name, column, closing->position);
    } else if (const Track* const place = find_of_row(places_, row)) {
      touched_.emplace(place->name, name);
      add(place->name, name, column, place->position);
    } else {
      for (const Motion::Body& body : motion_.bodies)
        if (body.name == name) return add(row, name, column, body.position);
    }
  }

  /// A joint that lets its child move freely holds nothing.
  void drop_idle_forces() {
    double most = 0;
    for (const Motion::Force& one : motion_.forces) most = std::max(most, largest_of(one.force));
    const auto is_idle = [&](const Motion::Force& one) {
      return find(joints_, one.name) != nullptr && largest_of(one.force) < k_rounding * most;
    };
    auto& all = motion_.forces;
    all.erase(std::remove_if(all.begin(), all.end(), is_idle), all.end());
  }

  /// The directions of one constraint are one force.
  void add(const std::string& name, const std::string& body, const Column& column, const std::vector<Place>& at) {
    const std::vector<Place> force = track(column.name.substr(0, column.name.size() - 3));
    for (Motion::Force& known : motion_.forces) {
      if (known.name != name || known.body != body) continue;
      for (std::size_t k = 0; k < force.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i) known.force[k][i] += force[k][i];
      return;
    }
    motion_.forces.push_back({name, body, column.unit, at, force});
  }

  const Columns& columns_;
  Table table_;
  std::vector<Track> joints_, closings_, places_;
  std::map<std::string, std::string> felt_by_;             ///< of each closing, the side whose force is shown
  std::set<std::pair<std::string, std::string>> touched_;  ///< places, and the bodies that feel a force there
  double room_ = 0;                                        ///< diagonal of the box of the whole motion [m]
  Motion motion_;
};

std::optional<Place> against(const Place& gravity) {
  const double size = vector_of(gravity).norm();
  if (!(size > 0)) return std::nullopt;
  const auto part = [&](std::size_t i) { return gravity[i] == 0 ? 0 : -gravity[i] / size; };
  return Place{part(0), part(1), part(2)};
}

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
  motion.up = against(model.gravity);
  return motion;
}

}  // namespace gausssim
