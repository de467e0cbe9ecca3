#pragma once
// The model format as a table: what maps there are, which keys stand in them, what their values look like. The readers take
// their keys from it, and `gauss-gen schema` prints it, so both know the same format. What needs more than the shape of a
// file (names that are declared, expressions, units, mechanics) is not in it.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gaussgen::model::format {

/// Of one entry; also the largest count.
inline constexpr std::int64_t k_most_copies = 10'000;

struct Map;

enum class Shape {
  version,
  text,        ///< a single value
  expression,  ///< a single value
  count,       ///< a whole number, or a formula of such
  word,        ///< one of `words`
  new_name,    ///< of something that is declared here
  name,        ///< of something else
  list,
  map,      ///< with keys of the format
  entries,  ///< a map with names of the model as keys
  counts,   ///< a map with names of counts as keys
};

struct Value {
  Shape shape = Shape::text;
  std::vector<std::string> words = {};
  std::size_t count = 0;                        ///< of a list; 0: any
  std::size_t most = 0;                         ///< of a list without `count`, which is not empty then; 0: any
  std::shared_ptr<const Value> item = nullptr;  ///< of a list, of entries
  std::shared_ptr<const Map> map = nullptr;
  bool may_be_empty = false;
  std::vector<Value> others = {};  ///< other shapes that will do
};

enum class Need { optional, required };

struct Key {
  std::string name;
  Value value;
  std::string about;  ///< for editors
  Need need = Need::optional;
};

enum class When { present, is_list, is_single };

/// Where `key` stands (with this `word`, if there is one), only it and the keys of `beside` may stand, and those of
/// `required` have to.
struct Rule {
  std::string key;
  std::vector<std::string> beside;
  std::vector<std::string> required = {};
  std::string word = {};
  When when = When::present;
  std::vector<Key> narrowed = {};        ///< keys whose values have less freedom then
  std::vector<std::string> one_of = {};  ///< keys of which one at least has to stand
};

struct Map {
  std::vector<Key> keys;
  std::vector<Rule> rules = {};
  /// The keys that say what it is, of which exactly one has to stand.
  std::vector<std::string> laws = {};
};

inline constexpr const char* k_effects = "effects";

const Map& model_file();
const Map& parameter();
const Map& input();
const Map& coordinate();
const Map& orientation();
const Map& frame();
const Map& point();
const Map& joint();
const Map& body();
const Map& particle();
const Map& constraint();
const Map& contact();
const Map& force();
const Map& table();
const Map& submodel();
const Map& effect();
const Map& quantity();
const Map& speed();
const Map& elimination();
const Map& euler_angles();
const Map& single_turn();

const std::vector<std::string>& outputs();
const std::vector<std::string>& joint_types();

/// The keys of a model file that an effect may have, too.
std::vector<std::string> section_names();

std::vector<std::string> keys_of(const Map& map);

/// Those that may stand where `key` does (with `word`), itself among them.
std::vector<std::string> keys_beside(const Map& map, const std::string& key, const std::string& word = {});

bool is_law(const Map& map, const std::string& key);

}  // namespace gaussgen::model::format
