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

  /// Each mistake once, though each instance has what its scene says. Warnings of the scene's own settings wait for `for_all`: what one instance does not use
  /// another one may. `file`: that they are of. `own`: what this instance says itself.
  gaussgen::support::Diagnostics not_yet_said(const gaussgen::support::Diagnostics& found, bool is_of_scene,
                                              const std::string& file, gaussgen::support::Span own);

  /// Warnings that each of `count` instances has.
  gaussgen::support::Diagnostics for_all(std::size_t count) const;

  /// Whether nobody has said it yet.
  bool is_new(const std::string& remark) { return said_.insert(remark).second; }

  /// Of NAME=VALUE those for what this one has.
  std::vector<std::string> sets_for(const std::vector<std::string>& sets, const gaussgen::model::Model& read);

  /// The first one that no instance has taken; empty: all were.
  std::string set_for_nobody(const std::vector<std::string>& sets) const;

 private:
  struct Waiting {
    gaussgen::support::Diagnostic warning;
    std::size_t count = 0;
  };

  std::set<std::string> said_, taken_;
  std::map<std::string, Waiting> waiting_;
};

}  // namespace gausssim
