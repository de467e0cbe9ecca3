#pragma once
// What the instances of one scene have in common while they are read and derived one after another.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "sim/engine/plugin.hpp"
#include "sim/run/shared_codes.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

class AmongInstances {
 public:
  SharedCodes codes;
  std::shared_ptr<PluginShelf> plugins = std::make_shared<PluginShelf>();

  /// What is found in the scene while `instance` is read, of which `own` is what it says itself. It waits for `in_scene`.
  void note(const gaussgen::support::Diagnostics& found, const std::string& instance, gaussgen::support::Span own);

  /// All that `count` of them have found, each once, though each instance has what its scene says. What is wrong for some of them names these; warnings are of all, or
  /// of one: what one does not use of the scene's settings another one may.
  gaussgen::support::Diagnostics in_scene(std::size_t count) const;

  /// Of what is found in a file that they share, what has not been said yet.
  gaussgen::support::Diagnostics not_yet_said(const gaussgen::support::Diagnostics& found);

  /// Whether nobody has said it yet.
  bool is_new(const std::string& remark) { return said_.insert(remark).second; }

  /// Of NAME=VALUE those for what this one has.
  std::vector<std::string> sets_for(const std::vector<std::string>& sets, const gaussgen::model::Model& read);

  /// The first one that no instance has taken; empty: all were.
  std::string set_for_nobody(const std::vector<std::string>& sets) const;

 private:
  struct Found {
    gaussgen::support::Diagnostic finding;
    std::vector<std::string> instances;
    bool is_own = false;  ///< at a place within an instance
  };

  std::set<std::string> said_, taken_;
  std::map<std::string, Found> in_scene_;
};

}  // namespace gausssim
