#pragma once
// The dimension of an expression from those of its names. Private to the folder.

#include <set>

#include "model/measure.hpp"
#include "support/diagnostics.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

class Inference {
 public:
  Inference(const Model& model, const support::Source& source, support::Diagnostics& diagnostics)
      : model_(model), source_(source), diagnostics_(diagnostics) {}

  /// Reports sums, comparisons, choices and arguments that do not fit; what follows from a mistake is unknown. Where terms of a sum
  /// disagree, those in `wanted` are right.
  Measure operator()(const Ast& ast, const Dimension* wanted = nullptr);

  /// Of a sum, without its sign; or of what is compared or chosen from.
  struct Term {
    const Ast* ast;
    Measure measure;
  };

  /// Only the first finding about one place.
  void report(const support::ErrorCode& code, const Ast& at, std::string message, std::string hint);

 private:
  Measure sum(const Ast& ast, const Dimension* wanted);
  Measure product(const Ast& ast);
  Measure call(const Ast& ast, const Dimension* wanted);
  Measure atan2(const Ast& ast);
  Measure comparison(const Ast& ast);
  Measure extreme(const Ast& ast, const Dimension* wanted);
  Measure cases(const Ast& ast, const Dimension* wanted);
  Measure table(const Ast& ast);
  Measure function(const Ast& ast);

  /// The measure that all terms share. `whole` names in messages what they are part of; without it none is written.
  Measure shared(const std::vector<Term>& terms, const Dimension* wanted, const char* whole);
  void report_unlike(const Term& term, const Term& reference, const char* whole);

  /// The text of a term as a name for it: "'r*wx'", or `otherwise` when it is long.
  std::string quoted(const Ast& ast, const std::string& otherwise) const;
  /// For a parameter that a hint proposes.
  std::string free_name() const;
  bool is_taken(const std::string& name) const;

  std::string literal_text(const Ast& ast) const;
  std::string hint_for_argument(const Ast& call, const Measure& argument) const;

  const Model& model_;
  const support::Source& source_;
  support::Diagnostics& diagnostics_;
  std::set<std::uint32_t> reported_;  ///< where they begin: a shorthand may use an expression more than once
};

}  // namespace gaussgen::model
