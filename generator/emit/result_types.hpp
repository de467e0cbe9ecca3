#pragma once

#include <map>
#include <string>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/unit.hpp"

namespace gaussgen::emit {

/// The structs that artefacts fill. Several artefacts may share one; then it has the groups and fields of all of them.
class ResultTypes {
 public:
  explicit ResultTypes(const Unit& unit);

  /// In order of first use.
  std::vector<cpp::Struct> structs() const;

  /// `reactions.rolling_around.multiplier`, without the index.
  std::string path(const std::string& result_type, const std::string& group, const std::string& field) const;

 private:
  struct Type {
    std::string name;
    std::vector<Group> groups;
    std::vector<Constant> constants;
    std::map<std::string, std::string> texts;  ///< names of groups and "group/field" as emitted
  };

  static void merge(Type& type, const Group& group);
  static void name_members(Type& type);
  static cpp::Struct printed(const Type& type);

  std::vector<Type> types_;
};

}  // namespace gaussgen::emit
