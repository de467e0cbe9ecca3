#pragma once
// A header that names some sets of effects, and regimes, of one model, for programs that choose one while they run.

#include <string>
#include <vector>

namespace gaussgen::emit {

struct Variant {
  std::string name;        ///< that programs know it by
  std::string model_name;  ///< of its header, without ending
  std::string name_space;
  std::vector<std::string> effects;
  std::vector<std::string> modes = {};   ///< of its regime, as floor=closed
  std::vector<std::string> guards = {};  ///< members of Guards; empty: it is generated without them

  bool has_code_of(const Variant& other) const { return effects == other.effects && modes == other.modes; }
};

/// `name`: of the header, without ending. Those with the same code share a header and a namespace.
std::string variants_header(const std::string& name, const std::string& name_space, const std::string& command,
                            const std::vector<Variant>& variants);

/// A header of a set with the same code as another one: its namespace is `alias`, beside that.
std::string alias_header(const std::string& model_name, const std::string& command, const Variant& same,
                         const std::string& alias);

}  // namespace gaussgen::emit
