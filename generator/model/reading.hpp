#pragma once
// What the readers of the sections share while a model is built. Private to the folder.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/choices.hpp"
#include "model/copies.hpp"
#include "model/model.hpp"
#include "model/unread.hpp"
#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// A file full of unknown names gets no suggestions after the first ones: each costs a search through all names.
class Searches {
 public:
  bool are_spent() const { return count_ >= k_most || names_ >= k_most_names; }

  /// False when the search is not to be.
  bool begin(std::size_t names) {
    if (are_spent()) return false;
    count_ += 1;
    names_ += names;
    return true;
  }

 private:
  static constexpr int k_most = 50;
  static constexpr std::size_t k_most_names = 20'000;
  int count_ = 0;
  std::size_t names_ = 0;  ///< of all searches
};

/// Of the characters of all expressions of a model: what they stand for takes a hundred times the memory.
class ExpressionBudget {
 public:
  static constexpr std::size_t k_most = 1'000'000;

  bool is_spent() const { return count_ > k_most; }
  void take(std::size_t characters) { count_ += characters; }

 private:
  std::size_t count_ = 0;
};

struct Declared {
  support::Span span;
  std::string what;  ///< "the parameter"
};

/// An entry that the model does without: of a submodel, or of an effect that does not act.
struct LeftOut {
  std::string section;
  std::string entry;
  std::string submodel;
  std::string effect = {};  ///< empty: it is of a submodel
  Unread names = {};        ///< that it may have declared
};

struct Reading {
  const support::Source& source;
  support::Diagnostics& diagnostics;
  Model model;
  KnownTables tables = {};
  std::map<std::string, Declared> declared = {};
  std::map<std::string, support::Span> bodies = {};  ///< particles too
  std::map<std::string, std::size_t> orientations = {};
  std::map<std::string, std::size_t> frames = {};  ///< index into Model::frames
  /// What each of Model::frames is placed against, until order_frames has found it; empty: space.
  std::vector<std::optional<Name>> parents = {};
  bool has_unknown_carrier = false;      ///< of a frame, or a place that a constraint relates, which a slip has hidden
  std::vector<std::size_t> second = {};  ///< frames of bodies on other frames, whose names another frame has
  Unread unread = {};
  std::vector<LeftOut> left_out = {};
  Copies copies = {};
  std::set<std::string> refused =
      {};  ///< declared, and may not be or are of two things: nothing is known of what uses them
  std::set<std::uint32_t> unknown_keys = {};   ///< where keys begin that were reported
  std::set<std::uint32_t> faulty_values = {};  ///< where expressions begin that use what may not stand there
  std::set<std::uint32_t> along_joints = {};   ///< where joints name coordinates that are declared elsewhere
  ExpressionBudget expressions = {};
  Choices choices = {};
  std::set<std::string> switches = {};  ///< what has modes
  Searches searches = {};  ///< of the whole file, for names that may be meant

  std::string line_text(support::Span span) const { return source.line_text(span.begin); }
};

/// Index of an orientation that was named but not found.
inline constexpr std::size_t k_no_orientation = static_cast<std::size_t>(-1);

}  // namespace gaussgen::model
