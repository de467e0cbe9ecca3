#pragma once
// The checked model: every name resolves, every expression uses only what is allowed at its place.
// Later stages may rely on that and report nothing more about the user's text.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/ast.hpp"

namespace gaussgen::model {

struct Name {
  std::string text;
  support::Span span;
};

/// A run-time constant. With a plain value (no other parameter in it) it is a member of the emitted
/// `Parameters`; with a formula it follows the parameters in it and is computed by `prepare`.
struct Parameter {
  Name name;
  Ast value;  ///< over earlier or later parameters, cycle-free; `Model::parameters` is in dependency order
  bool is_formula = false;
  std::string unit;
  std::string about;
};

/// What a caller supplies at each evaluation, such as a motor torque; `value` is the default.
struct Input {
  Name name;
  Ast value;
  std::string unit;
  std::string about;
};

/// q^α when `held_at` is empty; else the held coordinate x^i with x^i = c^i(t) (Vujičić (1.4), theory §4).
struct Coordinate {
  Name name;
  std::string unit;
  std::string about;
  std::optional<Ast> held_at;       ///< over parameters and t
  Ast initial;                      ///< free coordinates: over parameters; 0 when not given
  std::optional<Ast> initial_rate;  ///< over parameters; when not given, the constraints determine it
  std::optional<Ast> rate_guess;    ///< where the search for a rate that is not given starts; default 0
};

/// The frame in which a vector is resolved.
enum class Frame { space, body };

/// A unit quaternion (body to space, scalar first) with the angular velocity as quasi-velocity (theory §5).
/// Each of the seven names is a symbol in expressions.
struct Orientation {
  Name name;
  std::string about;
  std::array<Name, 4> quaternion;
  std::array<Name, 3> angular_velocity;  ///< rad/s, resolved in `frame`
  Frame frame = Frame::space;
  std::array<Ast, 4> initial;            ///< over parameters; normalised when emitted
  std::array<std::optional<Ast>, 3> initial_angular_velocity;  ///< an empty one is open
};

/// Rotations about moving axes in the order of `sequence`: R = R_a(angle 0) R_b(angle 1) R_c(angle 2), body to space.
struct EulerAngles {
  std::string sequence;  ///< three letters of x, y, z, such as "zxz"
  std::array<Ast, 3> angles;
};

/// Index into Model::orientations.
struct QuaternionOrientation {
  std::size_t index = 0;
};

/// Inertia about the mass centre, resolved in body axes: xx, yy, zz, xy, xz, yz.
struct Inertia {
  enum class Shape { isotropic, diagonal, full } shape = Shape::isotropic;
  std::array<Ast, 6> entries;  ///< isotropic: the first; diagonal: the first three
};

/// A rigid body, or a particle (no inertia, no orientation).
struct Body {
  Name name;
  std::string about;
  Ast mass;                     ///< over parameters
  std::array<Ast, 3> position;  ///< of the mass centre, in space; over coordinates, quaternions, parameters, t
  std::optional<Inertia> inertia;
  std::variant<std::monostate, EulerAngles, QuaternionOrientation> orientation;
};

/// φ_μ(y, ẏ, t) = 0 (Vujičić (3.1)), linear or nonlinear in the velocities.
struct VelocityConstraint {
  Name name;
  std::string about;
  Ast velocity;
  std::optional<std::array<Ast, 3>> point;  ///< where its reaction is reported to act, in space; default: each mass centre
};

/// The same acceleration on every mass: F = m * field at the mass centre.
struct UniformField {
  std::array<Ast, 3> field;  ///< over parameters and t
};

/// Q_A = -∂V/∂y^A.
struct Potential {
  Ast energy;  ///< over coordinates, quaternions, parameters, t
};

/// Q_A by name of a coordinate (held ones too) or of an angular velocity component.
struct GeneralizedForce {
  std::vector<std::pair<Name, Ast>> components;  ///< over everything
};

struct Force {
  Name name;
  std::string about;
  std::variant<UniformField, Potential, GeneralizedForce> law;
};

enum class SymbolKind {
  time,                  ///< `t`
  pi,                    ///< `pi`
  parameter,             ///< index into parameters
  input,                 ///< index into inputs
  coordinate,            ///< index into coordinates (free and held)
  quaternion_component,  ///< index = 4 * orientation + component
  angular_velocity,      ///< index = 3 * orientation + component
};

struct SymbolRef {
  SymbolKind kind;
  std::size_t index = 0;
};

struct Model {
  Name name;
  std::string about;
  std::string file;          ///< base name of the model file, or "<stdin>"
  std::string content_hash;  ///< FNV-1a 64 of the text, 16 hexadecimal digits
  std::vector<Parameter> parameters;
  std::vector<Input> inputs;
  std::vector<Coordinate> coordinates;
  std::vector<Orientation> orientations;
  std::vector<Body> bodies;
  std::vector<VelocityConstraint> constraints;
  std::vector<Force> forces;
  std::vector<Name> dependent;  ///< the user's choice of dependent speeds (3.6); empty: chosen by the generator
  std::vector<Name> outputs;    ///< empty: the default set
  std::map<std::string, SymbolRef> symbols;

  /// The declared symbol; asserts that it exists (the checks guarantee it).
  SymbolRef resolve(const std::string& symbol) const;
};

}  // namespace gaussgen::model
