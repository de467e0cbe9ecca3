#include "model/format.hpp"

#include <algorithm>

namespace gaussgen::model::format {

namespace {

using Names = std::vector<std::string>;

Value of_shape(Shape shape) {
  Value value;
  value.shape = shape;
  return value;
}

Value text() {
  Value value = of_shape(Shape::text);
  value.may_be_empty = true;
  return value;
}

Value path() { return of_shape(Shape::text); }

Value expression() { return of_shape(Shape::expression); }

Value name() { return of_shape(Shape::name); }

Value new_name() { return of_shape(Shape::new_name); }

Value word_of(Names words) {
  Value value = of_shape(Shape::word);
  value.words = std::move(words);
  return value;
}

Value list_of(Value item, std::size_t count = 0) {
  Value value = of_shape(Shape::list);
  value.item = std::make_shared<Value>(std::move(item));
  value.count = count;
  return value;
}

Value vector() { return list_of(expression(), 3); }

Value map_of(const Map& map) {
  Value value = of_shape(Shape::map);
  value.map = std::make_shared<Map>(map);
  return value;
}

Value entries_of(Value item) {
  Value value = of_shape(Shape::entries);
  value.item = std::make_shared<Value>(std::move(item));
  return value;
}

Value or_else(Value value, Value other) {
  value.others.push_back(std::move(other));
  return value;
}

Value or_empty(Value value) {
  value.may_be_empty = true;
  return value;
}

Value list_of_most(const Value& item, std::size_t most) {
  Value value = list_of(item);
  value.most = most;
  return value;
}

Value counts() {
  Value value = entries_of(of_shape(Shape::count));
  value.shape = Shape::counts;
  return value;
}

Value axis() { return or_else(word_of({"x", "y", "z", "-x", "-y", "-z"}), vector()); }

Value attitude() { return or_else(or_else(name(), map_of(euler_angles())), map_of(single_turn())); }

Value inertia() { return or_else(or_else(expression(), vector()), list_of(vector(), 3)); }

/// What a joint says of its coordinates: one each, and one alone without brackets.
Value for_each(const Value& item, std::size_t count) {
  return count == 1 ? or_else(item, list_of(item, 1)) : list_of(item, count);
}

/// An entry of a section, of which there may be several.
Map repeatable(Map map) {
  map.keys.push_back({"count", or_else(of_shape(Shape::count), list_of_most(of_shape(Shape::count), 3)),
                      "how many of it there are; $i in texts is its number"});
  for (Rule& rule : map.rules) rule.beside.push_back("count");
  return map;
}

Value entry(const Map& map) { return map_of(repeatable(map)); }

Value section(const Map& map) { return or_empty(entries_of(entry(map))); }

Key about() { return {"about", text(), "a sentence about it"}; }

Key unit() { return {"unit", text(), "such as kg*m^2/s; 1 for a plain number"}; }

/// x, y and z, each once after another one.
Names euler_sequences() {
  Names sequences;
  for (const char a : {'x', 'y', 'z'}) {
    for (const char b : {'x', 'y', 'z'}) {
      for (const char c : {'x', 'y', 'z'}) {
        if (a != b && b != c) sequences.push_back({a, b, c});
      }
    }
  }
  return sequences;
}

/// What joints of one type have besides the keys of all.
Rule joint_rule(const char* type, std::size_t coordinates, Names more, std::vector<Key> narrowed = {}) {
  Rule rule{"type", {"parent", "child", "at", "about"}, {}, type, When::present, std::move(narrowed)};
  if (coordinates > 0) {
    rule.beside.insert(rule.beside.end(), {"coordinates", "initial", "initial_guess", "initial_rate"});
    rule.narrowed.push_back({"coordinates", for_each(new_name(), coordinates), ""});
    for (const char* key : {"initial", "initial_guess", "initial_rate"}) {
      rule.narrowed.push_back({key, for_each(expression(), coordinates), ""});
    }
  }
  rule.beside.insert(rule.beside.end(), more.begin(), more.end());
  return rule;
}

bool has(const Names& names, const std::string& wanted) {
  return std::find(names.begin(), names.end(), wanted) != names.end();
}

}  // namespace

const std::vector<std::string>& outputs() {
  static const Names k_outputs{"rhs",           "reactions",  "reaction_forces", "joint_reactions",  "energy",
                               "compulsion",    "residuals",  "mobility",        "mass_matrix",      "project",
                               "initial_state", "quantities", "poses",           "inverse_dynamics", "jacobian",
                               "sensitivities", "taylor",     "guards"};
  return k_outputs;
}

const Map& parameter() {
  static const Map k_map{
      {{"value", expression(), "a number, or an expression over parameters", Need::required}, unit(), about()}};
  return k_map;
}

const Map& input() {
  static const Map k_map{{{"value", expression(), "a number, the default; 0 if left out"}, unit(), about()}};
  return k_map;
}

const Map& coordinate() {
  static const Map k_map{{unit(),
                          about(),
                          {"held_at", expression(), "the law of a held coordinate, over parameters and t"},
                          {"initial", expression(), "value at the start"},
                          {"initial_guess", expression(), "where the search for an open value starts"},
                          {"initial_rate", expression(), "rate at the start; open if left out"},
                          {"initial_rate_guess", expression(), "where the search for an open rate starts"}},
                         {{"held_at", {"unit", "about"}},
                          {"initial", {"unit", "about", "initial_rate", "initial_rate_guess"}},
                          {"initial_rate", {"unit", "about", "initial", "initial_guess"}}}};
  return k_map;
}

const Map& orientation() {
  static const Map k_map{
      {{"quaternion", list_of(new_name(), 4), "names of the components, scalar first", Need::required},
       {"angular_velocity", list_of(new_name(), 3), "names of the components, rad/s", Need::required},
       {"frame", word_of({"space", "body"}), "where the angular velocity is resolved"},
       {"initial", list_of(expression(), 4), "the quaternion at the start"},
       {"initial_angular_velocity", or_else(vector(), entries_of(expression())), "what is left out is open"},
       about()}};
  return k_map;
}

const Map& euler_angles() {
  static const Map k_map{
      {{"euler", word_of(euler_sequences()), "axes of the rotations, in their order", Need::required},
       {"angles", vector(), "in rad; what does not turn is 0", Need::required}}};
  return k_map;
}

const Map& single_turn() {
  static const Map k_map{
      {{"axis", axis(), "x, y, z or a direction", Need::required}, {"angle", expression(), "in rad", Need::required}}};
  return k_map;
}

const Map& frame() {
  static const Map k_map{{{"parent", name(), "the frame that it is placed against; space if left out"},
                          {"position", vector(), "of its origin, in axes of the parent"},
                          {"orientation", attitude(), "against the parent"},
                          about()}};
  return k_map;
}

const Map& point() {
  static const Map k_map{{{"on", name(), "the frame or body that carries it; space if left out"},
                          {"at", vector(), "in axes of what carries it", Need::required},
                          about()}};
  return k_map;
}

const std::vector<std::string>& joint_types() {
  static const Names k_types{"revolute",  "prismatic", "cylindrical", "universal",
                             "spherical", "planar",    "free",        "fixed"};
  return k_types;
}

const Map& joint() {
  const Key velocity{"initial_angular_velocity", or_else(vector(), entries_of(expression())),
                     "what is left out is open"};
  static const Map k_map{
      {{"type", word_of(joint_types()), "which motion is left", Need::required},
       {"parent", name(), "the frame that carries it; space if left out"},
       {"child", new_name(), "the frame that it carries", Need::required},
       {"at", vector(), "where it is, in axes of the parent"},
       about(),
       {"axes", list_of(axis(), 2), "of a universal joint"},
       {"axis", axis(), "x, y, z or a direction in the parent; z if left out"},
       {"coordinates", or_else(new_name(), list_of(new_name())), "their names"},
       {"initial", or_else(expression(), list_of(expression())), "values at the start"},
       {"initial_guess", or_else(expression(), list_of(expression())), "where searches start"},
       {"initial_rate", or_else(expression(), list_of(expression())), "rates at the start"},
       {"orientation", attitude(), "an orientation of the model; of a fixed joint any attitude"},
       velocity},
      {joint_rule("revolute", 1, {"axis"}),
       joint_rule("prismatic", 1, {"axis"}),
       joint_rule("cylindrical", 2, {"axis"}),
       joint_rule("universal", 2, {"axes"}),
       joint_rule("spherical", 0, {"orientation", "initial_angular_velocity"}, {{"orientation", name(), ""}}),
       joint_rule("planar", 3, {"axis"}, {{"axis", word_of({"x", "y", "z"}), ""}}),
       joint_rule("free", 3, {"orientation", "initial_angular_velocity"}, {{"orientation", name(), ""}}),
       joint_rule("fixed", 0, {"orientation"}),
       {"initial",
        {"type", "parent", "child", "at", "about", "axes", "axis", "coordinates", "initial_rate", "orientation",
         "initial_angular_velocity"}}}};
  return k_map;
}

const Map& body() {
  static const Map k_map{{{"mass", expression(), "in kg, over parameters", Need::required},
                          {"inertia", inertia(), "about the mass centre, in body axes: J, [Jx, Jy, Jz] or a matrix"},
                          {"frame", name(), "the frame that it is part of"},
                          {"centre", vector(), "of mass, in axes of the frame"},
                          {"position", vector(), "of the mass centre, in space"},
                          {"orientation", attitude(), "of the body axes in space"},
                          about()},
                         {{"position", {"mass", "inertia", "orientation", "about"}},
                          {"orientation", {"mass", "inertia", "position", "about"}, {"position"}}}};
  return k_map;
}

const Map& particle() {
  static const Map k_map{{{"mass", expression(), "in kg, over parameters", Need::required},
                          {"frame", name(), "the frame that it is part of"},
                          {"centre", vector(), "where it is, in axes of the frame"},
                          {"position", vector(), "where it is, in space"},
                          about()},
                         {{"position", {"mass", "about"}}}};
  return k_map;
}

const Map& constraint() {
  static const Map k_map{{{"velocity", expression(), "is zero along the motion"},
                          {"equation", expression(), "of places, is zero along the motion"},
                          {"rolls", name(), "the body that rolls without slipping"},
                          {"no_slip", name(), "the body that does not slip in one direction"},
                          {"coincide", list_of(name(), 2), "two places that stay together"},
                          {"distance", list_of(name(), 2), "two places that keep their distance"},
                          {"on", name(), "what it touches; space if left out"},
                          {"at", or_else(vector(), name()), "where they touch: a point, or where it is"},
                          {"in", name(), "in which axes directions are"},
                          {"direction", axis(), "x, y, z or three components"},
                          {"is", expression(), "the distance"},
                          {"point", vector(), "where its reaction is reported to act"},
                          {"breaks_at", expression(), "size of its reaction at which it breaks for good"},
                          about()},
                         {{"velocity", {"point", "breaks_at", "about"}},
                          {"equation", {"point", "breaks_at", "about"}},
                          {"rolls", {"on", "at", "breaks_at", "about"}, {"at"}},
                          {"no_slip", {"on", "at", "in", "direction", "breaks_at", "about"}, {"at", "direction"}},
                          {"coincide", {"in", "breaks_at", "about"}},
                          {"distance", {"is", "breaks_at", "about"}, {"is"}}},
                         {"velocity", "equation", "rolls", "no_slip", "coincide", "distance"}};
  return k_map;
}

const Map& contact() {
  static const Map k_map{{{"gap", expression(), "what does not become negative", Need::required},
                          {"restitution", expression(), "part of the speed that an impact leaves; 0 if left out"},
                          about()}};
  return k_map;
}

const Map& force() {
  static const Map k_map{
      {{"uniform", vector(), "the same acceleration for every mass"},
       {"potential", expression(), "its negative gradient is the force"},
       {"generalized", entries_of(expression()), "along coordinates or angular velocities"},
       {"force", vector(), "three components"},
       {"torque", vector(), "three components"},
       {"spring", or_else(name(), list_of(name(), 2)), "between two places, or along a coordinate"},
       {"on", name(), "what it acts on"},
       {"at", or_else(vector(), name()), "where, in axes of what it acts on"},
       {"from", name(), "what takes the opposite force"},
       {"in", name(), "in which axes the components are"},
       {"stiffness", expression(), "force for each length"},
       {"length", expression(), "of the spring without force"},
       {"rest", expression(), "value of the coordinate without force"},
       {"damping", expression(), "force for each speed"},
       {"drag", name(), "what a medium slows: a place"},
       {"magnus", name(), "a body that spins in a medium"},
       {"buoyancy", name(), "a body that displaces a medium"},
       {"friction", or_else(expression(), list_of_most(expression(), 2)), "against these velocities"},
       {"slides", name(), "a body with friction on another one"},
       {"linear", expression(), "force for each speed"},
       {"quadratic", expression(), "force for the square of each speed"},
       {"coefficient", expression(), "in kg: force for each speed and angular velocity"},
       {"displaced", expression(), "mass of the medium in its place"},
       {"wind", vector(), "velocity of the medium, in space"},
       {"directions", or_else(axis(), list_of_most(axis(), 2)), "in which it may slip, in the axes of 'in'"},
       {"limit", expression(), "of friction while it slides; may contain reactions"},
       {"static_limit", expression(), "of friction while it sticks; as 'limit' if left out"},
       {"smooth", expression(), "slip below which friction fades"},
       about()},
      {{"uniform", {"about"}},
       {"potential", {"about"}},
       {"generalized", {"about"}},
       {"force", {"on", "at", "from", "in", "about"}, {"on"}, "", When::present, {{"at", vector(), ""}}},
       {"torque", {"on", "from", "in", "about"}, {"on"}},
       {"spring", {"stiffness", "length", "damping", "about"}, {}, "", When::is_list, {}, {"stiffness", "damping"}},
       {"spring", {"stiffness", "rest", "damping", "about"}, {}, "", When::is_single, {}, {"stiffness", "damping"}},
       {"drag", {"linear", "quadratic", "wind", "about"}, {}, "", When::present, {}, {"linear", "quadratic"}},
       {"magnus", {"coefficient", "wind", "about"}, {"coefficient"}},
       {"buoyancy", {"displaced", "at", "about"}, {"displaced"}, "", When::present, {{"at", vector(), ""}}},
       {"friction", {"limit", "static_limit", "smooth", "about"}, {"limit"}},
       {"slides",
        {"on", "at", "in", "directions", "limit", "static_limit", "smooth", "about"},
        {"at", "directions", "limit"},
        "",
        When::present,
        {{"at", or_else(vector(), name()), ""}}}},
      {"uniform", "potential", "generalized", "force", "torque", "spring", "drag", "magnus", "buoyancy", "friction",
       "slides"}};
  return k_map;
}

const Map& table() {
  static const Map k_map{{{"of", list_of(expression()), "numbers in growing order", Need::required},
                          {"values", list_of(expression()), "numbers, one for each", Need::required},
                          {"kind", word_of({"linear", "spline"}), "linear if left out"},
                          {"outside", word_of({"hold", "extend"}), "what happens beyond the points"},
                          {"of_unit", text(), "unit of the argument"},
                          unit(),
                          about()}};
  return k_map;
}

const Map& submodel() {
  static const Map k_map{{{"file", path(), "path of its model file, relative to this one", Need::required},
                          {"on", name(), "the frame that carries what stands in space there"},
                          {"parameters", entries_of(expression()), "values of its parameters"},
                          {"effects", or_else(name(), list_of(name())), "which of its effects act"},
                          {"without", list_of(name()), "entries that are left out"},
                          about()}};
  return k_map;
}

const Map& speed() {
  static const Map k_map{{{"is", expression(), "linear in rates dot(x)", Need::required},
                          {"initial", expression(), "value at the start; open if left out"},
                          {"initial_guess", expression(), "where the search for an open value starts"},
                          unit(),
                          about()},
                         {{"initial", {"is", "unit", "about"}}}};
  return k_map;
}

const Map& quantity() {
  static const Map k_map{
      {{"value", or_else(expression(), vector()), "over everything; three components for a vector", Need::required},
       unit(),
       about()}};
  return k_map;
}

const Map& elimination() {
  static const Map k_map{{{"dependent", list_of(name()), "speeds, as many as constraints", Need::required}}};
  return k_map;
}

namespace {

/// What a model file and an effect in it have alike.
const std::vector<Key>& sections() {
  static const std::vector<Key> k_sections{
      {"submodels", section(submodel()), "parts in files of their own"},
      {"parameters", or_empty(entries_of(or_else(expression(), entry(parameter())))),
       "constants that a program may change at run time"},
      {"inputs", or_empty(entries_of(or_empty(or_else(expression(), entry(input()))))), "values of each evaluation"},
      {"tables", section(table()), "functions by their points"},
      {"coordinates", or_empty(entries_of(or_empty(entry(coordinate())))), "free and held ones"},
      {"speeds", section(speed()), "velocities that stand in the state instead of rates"},
      {"orientations", section(orientation()), "attitudes by unit quaternion"},
      {"frames", section(frame()), "axes placed against others"},
      {"joints", section(joint()), "frames carried by others, with coordinates of the motion between them"},
      {"points", section(point()), "places on frames and bodies"},
      {"bodies", section(body()), "with mass and inertia"},
      {"particles", section(particle()), "with mass alone"},
      {"constraints", section(constraint()), "on velocities, on positions, between places"},
      {"contacts", section(contact()), "gaps that do not become negative"},
      {"forces", section(force()), "each with one law"},
      {"quantities", or_empty(entries_of(or_else(or_else(expression(), vector()), entry(quantity())))),
       "what else the emitted code shall tell of a state"}};
  return k_sections;
}

/// An entry that may add keys to one that is there: nothing has to stand in it.
Map partial(Map map) {
  for (Key& key : map.keys) key.need = Need::optional;
  for (Rule& rule : map.rules) {
    rule.required.clear();
    rule.one_of.clear();
  }
  map.laws.clear();
  return map;
}

Value with_partial_map(Value value) {
  if (value.map != nullptr) value.map = std::make_shared<Map>(partial(*value.map));
  for (Value& other : value.others) other = with_partial_map(std::move(other));
  return value;
}

Key with_partial_entries(Key section) {
  section.value.item = std::make_shared<Value>(with_partial_map(*section.value.item));
  return section;
}

Map effect_map() {
  Map map{{about(),
           {"default", word_of({"on", "off"}), "whether it acts where nobody chooses; off if left out"},
           {"requires", list_of(name()), "effects without which it does not act"},
           {"excludes", list_of(name()), "effects beside which it does not act"},
           {"one_of", new_name(), "of the effects with the same word, exactly one acts"}}};
  for (const Key& section : sections()) map.keys.push_back(with_partial_entries(section));
  return map;
}

Map model_map() {
  Map map{{{"gauss", of_shape(Shape::version), "version of the format: 1", Need::required},
           {"name", new_name(), "of the model: the namespace and the file name", Need::required},
           about(),
           {"counts", or_empty(counts()), "whole numbers, $n in texts"}}};
  map.keys.insert(map.keys.end(), sections().begin(), sections().end());
  const std::vector<Key> more{
      {k_effects, or_empty(entries_of(or_empty(map_of(effect())))),
       "named parts of the model that a scene may do without"},
      {"exact", or_empty(entries_of(expression())),
       "coordinates, rates x_dot and speeds as functions of t, where they are known"},
      {"elimination", map_of(elimination()), "the choice of dependent speeds"},
      {"rank_tolerance", expression(), "a number: sine of the angle below which a constraint follows from the others"},
      {"outputs", or_empty(list_of(word_of(outputs()))), "what is emitted; all if left out"},
      {"sensitivities", or_empty(list_of(name())), "parameters by which derivatives are emitted"}};
  map.keys.insert(map.keys.end(), more.begin(), more.end());
  return map;
}

}  // namespace

std::vector<std::string> section_names() {
  Names names;
  for (const Key& section : sections()) names.push_back(section.name);
  return names;
}

const Map& effect() {
  static const Map k_map = effect_map();
  return k_map;
}

const Map& model_file() {
  static const Map k_map = model_map();
  return k_map;
}

std::vector<std::string> keys_of(const Map& map) {
  Names names;
  for (const Key& key : map.keys) names.push_back(key.name);
  return names;
}

std::vector<std::string> keys_beside(const Map& map, const std::string& key, const std::string& word) {
  Names allowed{key};
  for (const Rule& rule : map.rules) {
    if (rule.key != key || rule.word != word) continue;
    allowed.insert(allowed.end(), rule.beside.begin(), rule.beside.end());
  }
  Names names = keys_of(map);
  names.erase(std::remove_if(names.begin(), names.end(), [&](const auto& name) { return !has(allowed, name); }),
              names.end());
  return names;
}

bool is_law(const Map& map, const std::string& key) { return has(map.laws, key); }

}  // namespace gaussgen::model::format
