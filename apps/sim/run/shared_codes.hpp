#pragma once
// Code that several bodies of one scene share: derived once for each set of effects, whatever values and start each body has.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "pipeline.hpp"

namespace gausssim {

/// What was derived for one body, and does for others.
struct SharedCode {
  std::string key;
  std::shared_ptr<const gaussgen::PipelineResult> result;
  std::vector<std::string> where_possible;  ///< outputs that were welcome when it was derived
  std::string text;                         ///< of what is compiled
};

class SharedCodes {
 public:
  /// Null: none that may be shared was derived by this key.
  const SharedCode* find(const std::string& key) const;

  /// What was derived now. `may_be_shared`: no value of a body is in it. Returns its number among texts that differ.
  std::size_t add(SharedCode code, bool may_be_shared);

  /// Of one that `find` knows.
  std::size_t number_of(const SharedCode& code) const;

  /// How many texts there are.
  std::size_t count() const { return texts_.size(); }
  /// How often equations were derived.
  std::size_t derivations() const { return derivations_; }

 private:
  std::vector<SharedCode> codes_;
  std::vector<std::string> texts_;
  std::size_t derivations_ = 0;
};

/// What code depends on: the acting effects, the outputs, how it is written, and which values are formulas or open. Numbers are no part of it.
std::string key_of_code(const gaussgen::model::Model& read, const gaussgen::PipelineOptions& options);

/// Whether nothing that was found at the values of one body, or at its start, stands in its code: constraints that are solved with the motion have a rank there, and
/// folded code has the values themselves.
bool may_be_shared(const gaussgen::PipelineResult& derived, const gaussgen::PipelineOptions& options);

/// `code` with the values of parameters and inputs that `start` has, which was derived with them, and without a start of its own: that is in `start`.
gaussgen::PipelineResult with_values_of(const gaussgen::PipelineResult& start, const gaussgen::PipelineResult& code);

}  // namespace gausssim
