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
#include "model/dimension.hpp"

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
  std::string unit;                    ///< of a formula that states none: what follows from the others
  std::optional<Dimension> dimension;  ///< of `unit`
  std::string about;
};

/// What a caller supplies at each evaluation, such as a motor torque; `value` is the default.
struct Input {
  Name name;
  Ast value;
  std::string unit;
  std::optional<Dimension> dimension;
  std::string about;
  bool is_load = false;  ///< inverse dynamics takes its value as it is
};

/// A function of one argument by its points; an expression calls it by name.
struct Table {
  enum class Kind { linear, spline };   ///< straight between points, or the natural cubic spline
  enum class Outside { hold, extend };  ///< beyond the points: the value at the end, or straight on
  Name name;
  std::string about;
  std::vector<Ast> of;      ///< growing; numbers and pi
  std::vector<Ast> values;  ///< likewise, one for each
  Kind kind = Kind::linear;
  Outside outside = Outside::hold;
  std::string of_unit;                             ///< of the arguments; empty when not given
  std::optional<Dimension> of_dimension;           ///< of `of_unit`
  std::string unit;                                ///< of the values; empty when not given
  std::optional<Dimension> dimension;              ///< of `unit`
  std::shared_ptr<const support::Table> function;  ///< what calls refer to
};

/// q^α when `held_at` is empty; else the held coordinate x^i with x^i = c^i(t) (Vujičić (1.4), theory §4).
struct Coordinate {
  Name name;
  std::string unit;
  std::optional<Dimension> dimension;
  std::string about;
  std::optional<Ast> held_at;  ///< over parameters and t
  std::optional<Ast> initial;  ///< free coordinates: over parameters; when not given, constraints may move it
  std::optional<Ast> guess;    ///< where the search for an open value starts; default 0
  std::optional<std::size_t>
      speed;  ///< index into Model::speeds: of the speed that takes the place of the rate in the state
  std::optional<Ast>
      initial_rate;  ///< of the rate, or of `speed`; over parameters; when not given, the constraints determine it
  std::optional<Ast> rate_guess;  ///< where the search for a rate that is not given starts; default 0
  bool is_of_joint = false;       ///< declared by a joint, which gives it its unit
  std::string starts_at = {};     ///< the joint at which its initial values stand; empty: with itself

  /// The initial value, or where the search for it starts.
  Ast start() const { return initial ? *initial : guess ? *guess : Ast(); }
};

/// A quasi-velocity: in the state it takes the place of a rate (theory section 5). As many as the rates in them.
struct Speed {
  Name name;
  Ast is;  ///< linear in rates; over coordinates, parameters, t
  std::string unit;
  std::optional<Dimension> dimension;
  std::string about;
};

/// The axes in which a vector is resolved.
enum class Axes { space, body };

/// A unit quaternion (turned axes to those that it starts from, scalar first) with the angular velocity as quasi-velocity
/// (theory §5). Each of the seven names is a symbol in expressions. On a frame with a parent, "space" is the parent's axes.
struct Orientation {
  Name name;
  std::string about;
  std::array<Name, 4> quaternion;
  std::array<Name, 3> angular_velocity;  ///< rad/s, resolved in `axes`
  Axes axes = Axes::space;
  std::array<Ast, 4> initial;                                  ///< over parameters; normalised when emitted
  bool is_open = false;                                        ///< constraints may turn it from `initial`
  std::array<std::optional<Ast>, 3> initial_angular_velocity;  ///< an empty one is open
  /// Of `--assemble`: where the search for an open one starts.
  std::array<std::optional<Ast>, 3> angular_velocity_guess;
};

/// A turn about x, y or z, or about a vector over parameters (of any length but 0).
struct Turn {
  std::variant<char, std::array<Ast, 3>> axis = 'z';
  Ast angle;  ///< rad, over coordinates, quaternions, parameters, t
};

/// Turns about moving axes, the first one first: R = R_0 R_1 …, from the turned axes to those at the start.
using Turns = std::vector<Turn>;

/// Index into Model::orientations.
struct QuaternionOrientation {
  std::size_t index = 0;
};

/// Inertia about the mass centre, resolved in the axes of its frame: xx, yy, zz, xy, xz, yz.
struct Inertia {
  enum class Shape { isotropic, diagonal, full } shape = Shape::isotropic;
  std::array<Ast, 6> entries;  ///< isotropic: the first; diagonal: the first three
};

using Attitude = std::variant<std::monostate, Turns, QuaternionOrientation>;

/// Stands for space as the parent of a frame.
inline constexpr std::size_t k_space = static_cast<std::size_t>(-1);

/// An origin with axes: a part that joints carry, a place on it, or a body with its mass centre as the origin.
/// `name.x`, `name.y`, `name.z` in expressions are the coordinates of the origin in space.
struct Frame {
  Name name;
  std::string about;
  std::size_t parent = k_space;  ///< index into Model::frames, always an earlier one
  std::array<Ast, 3>
      position;           ///< of the origin, in the axes of the parent; over coordinates, quaternions, parameters, t
  Attitude attitude;      ///< against the parent; std::monostate: its axes
  bool is_point = false;  ///< a place on the parent, which says nothing of how anything moves there
};

enum class JointType { revolute, prismatic, cylindrical, universal, spherical, planar, free, fixed };

/// Carries a frame; what it transmits is the force and moment on that frame from its parent.
struct Joint {
  Name name;
  std::string about;
  JointType type = JointType::revolute;
  std::size_t frame = 0;  ///< index into Model::frames: the child, with its origin in the joint
};

/// A rigid body, or a particle (no inertia).
struct Body {
  Name name;
  std::string about;
  Ast mass;                        ///< over parameters
  std::size_t frame = 0;           ///< index into Model::frames: what it is part of
  std::array<Ast, 3> centre;       ///< mass centre, in the axes of the frame; over parameters
  std::optional<Inertia> inertia;  ///< in the axes of the frame
  bool is_particle = false;        ///< has none, and says so
};

/// φ_μ(y, ẏ, t) = 0 (Vujičić (3.1)), linear or nonlinear in the velocities.
struct VelocityLaw {
  Ast phi;
};

/// f(y, t) = 0, an implicit holonomic constraint (theory §4): its row is φ = df/dt, its multiplier the reaction R of f.
struct PositionLaw {
  Ast f;
  bool is_coincidence = false;  ///< a component of the way from one place to another
  std::optional<Ast> phi = {};  ///< instead of df/dt: the same where f = 0
};

/// The point of `frame` that is at `at` now has there the velocity of the point of `surface`, along one direction.
struct SlipLaw {
  std::size_t frame = k_space;
  std::size_t surface = k_space;
  std::variant<std::size_t, std::array<Ast, 3>> at;  ///< origin of a frame, or a place in space
  std::size_t axes = k_space;                        ///< the frame in which `direction` is resolved
  std::array<Ast, 3> direction;                      ///< over parameters, t; of any length but 0
};

/// One row. What the file writes as one constraint may be several: `rolls` is three.
struct Constraint {
  Name name;
  std::string about;
  support::Span span;  ///< of the law
  std::variant<VelocityLaw, PositionLaw, SlipLaw> law;
  std::optional<std::array<Ast, 3>>
      point;                    ///< where its reaction is reported to act, in space; default: each mass centre
  std::string multiplier_unit;  ///< power per φ, energy per f; empty when a name in it has no unit
  bool may_vanish = false;      ///< one of several directions; left out where it says nothing, as the third in a plane
  std::optional<Ast> breaks_at = std::nullopt;  ///< size of its reaction above which it is no more; over parameters
  std::optional<Dimension> multiplier_dimension = std::nullopt;  ///< of `multiplier_unit`
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

/// A force at a point of a frame, and its opposite at the same place on another one.
struct PointForce {
  std::size_t frame = k_space;    ///< on what it acts
  std::array<Ast, 3> at;          ///< in the axes of `frame`, from its origin; over parameters
  std::size_t from = k_space;     ///< what feels the opposite
  std::size_t axes = k_space;     ///< in which `components` are resolved
  std::array<Ast, 3> components;  ///< N; over everything
};

/// A moment on a frame, and its opposite on another one.
struct Torque {
  std::size_t frame = k_space;
  std::size_t from = k_space;
  std::size_t axes = k_space;
  std::array<Ast, 3> components;  ///< N m; over everything
};

/// Spring and damper between the origins of two frames, along the line through them: it pulls with stiffness (d - length) +
/// damping dd/dt. Without a length the forces are stiffness d and damping times the difference of the velocities, as vectors.
struct Spring {
  std::size_t first = k_space;
  std::size_t second = k_space;
  Ast stiffness;               ///< N/m, over parameters and t
  std::optional<Ast> length;   ///< m, over parameters and t
  std::optional<Ast> damping;  ///< N s/m, over parameters and t
};

/// Spring and damper along a coordinate: Q = -stiffness (y - rest) - damping dy/dt.
struct CoordinateSpring {
  Name coordinate;
  Ast stiffness;
  std::optional<Ast> rest;
  std::optional<Ast> damping;
};

/// Against slip φ in one direction or several: -limit φ_i/|φ| times ∂φ_i/∂ẏ, with |φ| the root of their squares. Smooth friction has
/// sqrt(|φ|² + v_s²) instead: it fades below a slip v_s, and creeps where it is to stick.
struct Friction {
  std::vector<std::variant<VelocityLaw, SlipLaw>> slips;
  Ast limit;                  ///< power per slip: N for m/s; over everything, linear in reactions
  std::optional<Ast> smooth;  ///< v_s, over parameters; in the unit of slip
  int sense = 0;  ///< of slip, where it is known as long as the regime lasts: ±1; 0: it follows from the state
};

/// What a switch of the model does in the regime that was read.
enum class Mode { open, closed, sticks, slides, forwards, backwards, free, holds, broken };

/// As scenes and emitted code call it.
std::string name_of(Mode mode);

/// gap ≥ 0: open, or closed and a constraint as long as its reaction presses (theory.md, section 11).
struct Contact {
  Name name;
  std::string about;
  Ast gap;                         ///< m or rad; over coordinates, places, parameters, t
  std::optional<Ast> restitution;  ///< over parameters; 0 if left out
  Mode mode = Mode::open;
  std::string impulse_unit = {};  ///< energy per gap, times s; empty where a name in it has no unit
};

/// Friction that sticks: a constraint as long as less than its static limit holds it. Forwards and backwards are the signs of its only
/// slip.
struct DryFriction {
  Name name;
  std::string about;
  Friction law;
  std::optional<Ast> static_limit;  ///< as `law.limit`, where it is more
  Mode mode = Mode::sticks;
  bool is_idle = false;         ///< its limit is a part of the reaction of a contact that is open
  std::vector<Name> rows = {};  ///< of constraints, as long as it sticks
};

/// What ends a regime when it falls through 0, or goes along with such a function.
struct Guard {
  enum class Kind {
    falls,        ///< the regime ends where it becomes negative
    rate_of_gap,  ///< of the gap that stands before it
    slip,         ///< of friction that slides: it ends where all of them are 0
  };
  std::string name;  ///< floor_opens
  Name of;           ///< the contact, the friction, the constraint
  Kind kind = Kind::falls;
  Ast value;
  std::vector<Name> rows = {};    ///< constraints whose reactions it judges
  std::optional<Ast> limit = {};  ///< of the root of their squares; none: the reaction is not negative
};

struct Force {
  Name name;
  std::string about;
  std::variant<UniformField, Potential, GeneralizedForce, PointForce, Torque, Spring, CoordinateSpring, Friction> law;
};

/// What a user of the emitted code wants to know of a state: one expression, or the three components of a vector.
struct NamedQuantity {
  Name name;
  std::vector<Ast> values;  ///< over everything
  std::string unit;         ///< when not given: what follows from the values
  std::optional<Dimension> dimension;
  std::string about;
};

/// What a coordinate, its rate or a speed is at a time, in the motion from the initial state: for studies of accuracy. Nothing is emitted of it.
struct ClosedForm {
  Name name;  ///< as a table calls it: x, x_dot
  Name of;    ///< the coordinate or speed
  bool is_rate = false;
  Ast value;  ///< over parameters and t
};

/// A named part of the model that a scene may do without: its entries are in the model where it acts, and nothing of it is where not.
struct Effect {
  Name name;
  std::string about;
  bool by_default = false;
  bool acts = false;
  std::vector<Name> needs = {};  ///< `requires`
  std::vector<Name> excludes = {};
  std::optional<Name> one_of = std::nullopt;  ///< the choice of which exactly one acts
};

/// A reaction in the formulas of forces or quantities: `floor.reaction` is the multiplier of the row `floor` or the generalized reaction
/// of the held coordinate `floor`, at the same instant.
struct NamedReaction {
  std::string of;
  bool is_held = false;                               ///< of a coordinate, else of a constraint
  bool is_in_force = false;                           ///< else of quantities or guards alone
  bool is_of_user = false;                            ///< else guards alone mention it
  bool is_absent = false;                             ///< there is none in this regime: it is 0
  std::optional<Dimension> dimension = std::nullopt;  ///< energy per unit of what is held, power per φ
};

enum class SymbolKind {
  time,                  ///< `t`
  pi,                    ///< `pi`
  parameter,             ///< index into parameters
  input,                 ///< index into inputs
  coordinate,            ///< index into coordinates (free and held)
  quaternion_component,  ///< index = 4 * orientation + component
  angular_velocity,      ///< index = 3 * orientation + component
  speed,                 ///< index into speeds
  place,                 ///< index = 3 * frame + component: where its origin is, in space
  spin,                  ///< likewise: its angular velocity, in space
  slip,                  ///< index = 2 * dry friction + direction
  reaction,              ///< index into reactions
  axis,                  ///< index = 9 * frame + 3 * axis + component, in space; no name of a model file
};

struct SymbolRef {
  SymbolKind kind;
  std::size_t index = 0;
};

struct Model {
  Name name;
  std::string about;
  std::string file;             ///< base name of the model file, or "<stdin>"
  std::string content_hash;     ///< FNV-1a 64 of the text, 16 hexadecimal digits
  bool leaves_out = false;      ///< an entry with count 0: what it would use may stand unused
  std::vector<Effect> effects;  ///< all of the file
  std::map<std::string, std::vector<std::string>>
      words_of_absent_effects;  ///< names that those that do not act declare or mention, each with all of them
  std::vector<Parameter> parameters;
  std::vector<Input> inputs;
  std::vector<Table> tables;
  std::vector<Coordinate> coordinates;
  std::vector<Speed> speeds;
  std::vector<Orientation> orientations;
  std::vector<Frame> frames;  ///< parents first
  std::vector<Joint> joints;
  std::vector<Body> bodies;
  std::vector<Constraint> constraints;
  std::vector<Contact> contacts;
  std::vector<DryFriction> frictions;
  bool is_ground = false;                  ///< contacts are open and friction is left out
  std::vector<Constraint> broken;          ///< rows that are no more in the regime that was read
  std::vector<Guard> guards;               ///< of the regime that was read
  std::vector<Constraint> idle_slips;      ///< directions of `rolls` in which the motion is held anyway
  std::vector<std::string> idle_closures;  ///< rows of `coincide` that hold in every motion and are left out
  std::vector<Force> forces;
  std::vector<NamedQuantity> quantities;
  std::vector<NamedReaction> reactions;  ///< that are mentioned
  std::vector<ClosedForm> exact;
  std::vector<Name> dependent;      ///< the user's choice of dependent speeds (3.6); empty: chosen by the generator
  std::vector<Name> outputs;        ///< empty: the default set
  std::vector<Name> sensitivities;  ///< parameters by which derivatives are emitted
  /// Sine of the angle to all others below which a constraint follows from them; empty: from the digits of the scalar type.
  std::optional<support::Rational> rank_tolerance;
  std::map<std::string, SymbolRef> symbols;

  /// The declared symbol; asserts that it exists (the checks guarantee it).
  SymbolRef resolve(const std::string& symbol) const;

  /// Index of the coordinate whose rate this speed replaces; asserts that it exists.
  std::size_t coordinate_of_speed(std::size_t speed) const;
};

/// Of the constraint of which this is one direction: without _x, _y, _z.
std::string name_in_file(const Constraint& row);

/// What a force on a frame acts on: for a point, the frame that it is on, since the contact of a wheel wanders over it and its material
/// does not; of a point in space, space. A point that carries a body is its own.
std::size_t pushed_by_force_on(const Model& model, std::size_t frame);

/// Forces of the model depend on reactions, which depend on forces: theory.md, section 10.
bool has_reactions_in_forces(const Model& model);

/// Whether any unit is stated; if not, no dimension was checked.
bool has_units(const Model& model);

}  // namespace gaussgen::model
