#pragma once
// What parts of a model that could not be read may have declared: such names are not called unknown. Private to the folder.

#include <set>
#include <string>
#include <vector>

#include "spec/node.hpp"

namespace gaussgen::model {

/// Whatever looks like a name in it.
std::vector<std::string> words_in(const spec::Node& part);

class Unread {
 public:
  /// Any word in it may be a name, and the beginning of names that follow from it, as those of a joint's coordinates do.
  void add(const spec::Entry& part);
  void add(const spec::Node& part);

  /// `leg` brings leg_hip; an index may end it, as in leg_$i.
  void add_owner(const std::string& name);

  /// In a submodel, names begin with `prefix`.
  void add_everything(const std::string& prefix = "");
  void add_any_frame(const std::string& prefix) { frames_.insert(prefix); }

  /// What is missing in a submodel, whose names get `prefix` in front.
  void add(const Unread& inside, const std::string& prefix);

  /// Whether something is missing at all: then nothing can be counted.
  bool any() const { return !frames_.empty() || !names_.empty() || !beginnings_.empty(); }

  bool may_declare(const std::string& name) const;
  bool may_declare_frame(const std::string& name) const;

 private:
  std::set<std::string> names_;
  std::set<std::string> beginnings_;
  std::set<std::string> frames_;  ///< how names of frames begin that may be any
};

}  // namespace gaussgen::model
