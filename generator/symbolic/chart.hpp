#pragma once
// The coordinates y^A = (q^α, x^i) of a model with their symbols, and derivatives along a motion.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "symbolic/frames.hpp"
#include "symbolic/quaternion.hpp"
#include "symbolic/translate.hpp"

namespace gaussgen::symbolic {

/// α: a free speed. i: a held coordinate. A: all, the free ones first.
using FreeIndex = support::Index<struct FreeTag>;
using HeldIndex = support::Index<struct HeldTag>;
using FullIndex = support::Index<struct FullTag>;

/// One y^A. For an angular velocity component y is a rotation coordinate θ about the present attitude, rate and
/// acceleration are ω and dω/dt, and everything is taken at θ = 0.
struct ChartCoordinate {
  std::string label;  ///< what indices are called: chi, wx
  GiNaC::realsymbol y;
  GiNaC::realsymbol rate;          ///< chi_dot, wx
  GiNaC::realsymbol acceleration;  ///< chi_ddot, wx_dot
  std::optional<ex> held_at;       ///< c^i(t)
};

/// A speed that the model puts in the place of a rate: u(q, q̇, t). The chart itself keeps to the rates.
struct ChartSpeed {
  std::string name;
  ex is;
};

/// Order of the speeds: free coordinates as declared, then the angular velocities as declared.
class Chart {
 public:
  explicit Chart(const model::Model& model);
  Chart(const Chart&) = delete;  // the scope refers to this chart
  Chart& operator=(const Chart&) = delete;

  std::size_t free_count() const { return free_.size(); }
  std::size_t held_count() const { return all_.size() - free_count(); }
  std::size_t full_count() const { return all_.size(); }
  FullIndex full(FreeIndex i) const { return FullIndex{i.value}; }
  FullIndex full(HeldIndex i) const { return FullIndex{free_count() + i.value}; }
  std::vector<FreeIndex> free() const { return support::indices<FreeIndex>(free_count()); }
  std::vector<HeldIndex> held() const { return support::indices<HeldIndex>(held_count()); }
  std::vector<FullIndex> all() const { return support::indices<FullIndex>(full_count()); }
  const ChartCoordinate& operator[](FullIndex i) const { return all_[i]; }
  const ChartCoordinate& operator[](FreeIndex i) const { return all_[full(i)]; }
  const ChartCoordinate& operator[](HeldIndex i) const { return all_[full(i)]; }
  const GiNaC::realsymbol& time() const { return time_; }

  /// The index with this label.
  FullIndex find(const std::string& label) const;

  /// What the model has instead of the rate; empty where it has the rate itself.
  const std::optional<ChartSpeed>& speed_instead(FreeIndex i) const { return speeds_[i]; }

  /// A user's expression over the chart: quaternion components and angular velocities depend on θ.
  ex operator()(const model::Ast& ast) const { return translate(ast, scope_); }
  Vector3 operator()(const std::array<model::Ast, 3>& ast) const;

  /// d/dt along ẏ, ÿ.
  ex rate_of(const ex& f) const;
  Vector3 rate_of(const Vector3& v) const;

  /// θ = 0; the last step after all derivatives.
  ex at_attitude(const ex& f) const;

  /// f with ẏ = 0.
  ex at_rest(const ex& f) const;

  /// The attitude of an orientation, e(θ), and its angular velocity in its own frame.
  const Quaternion& attitude(std::size_t orientation) const { return orientations_[orientation].e; }
  const Vector3& omega(std::size_t orientation) const { return orientations_[orientation].omega; }

  const Frames& frames() const { return frames_; }

  /// Every symbol of the model by its name: parameters, inputs, t, y, rates, accelerations, quaternion components.
  const std::map<std::string, GiNaC::realsymbol>& symbols() const { return symbols_; }

  /// Formula parameters and what they stand for.
  const std::map<std::string, ex>& formulas() const { return formulas_; }

 private:
  struct Attitude {
    Quaternion e;
    Vector3 omega;
  };

  GiNaC::realsymbol declare(const std::string& name);
  void declare_constants(const model::Model& model);
  void declare_coordinates(const model::Model& model);
  void declare_orientation(const model::Orientation& orientation);
  void declare_speeds(const model::Model& model);

  std::map<std::string, GiNaC::realsymbol> symbols_;  // first: the others are declared in it
  support::Indexed<FreeIndex, std::string> free_;
  support::Indexed<FullIndex, ChartCoordinate> all_;
  support::Indexed<FreeIndex, std::optional<ChartSpeed>> speeds_;
  GiNaC::realsymbol time_;
  std::vector<Attitude> orientations_;
  GiNaC::exmap attitude_origin_;
  GiNaC::exmap rest_;
  Scope scope_;
  std::map<std::string, ex> formulas_;
  Frames frames_;
};

}  // namespace gaussgen::symbolic
