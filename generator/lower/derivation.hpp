#pragma once
// The derivation of a model's equations as a text: Z, the metric, Γ, э, c_p^μ, b^{μi}, equations and reactions, each
// with the number that it has in Vujičić's paper.

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gaussgen::lower {

/// One formula: `left = right`, or `right = 0` without a left side.
struct Formula {
  std::string left;                ///< LaTeX
  std::vector<std::string> right;  ///< LaTeX, term by term
  std::string plain;               ///< the whole in infix form, as names of the code
};

/// A symbol with what the user says about it.
struct Item {
  std::string symbol;  ///< LaTeX
  std::string plain;
  std::string about;  ///< as the user wrote it, not escaped
};

struct Section {
  std::string title;
  std::string equation;              ///< "(1.13)", or empty
  std::string words;                 ///< may hold $formulas$; no user's text
  std::vector<std::string> general;  ///< formulas as the paper has them, LaTeX
  std::vector<Item> items;
  std::vector<Formula> formulas;
};

struct Derivation {
  std::string obstacle;  ///< why there is none; then everything else is empty
  std::string title;
  std::string about;
  std::vector<Section> sections;
};

Derivation derive(const model::Model& model);

std::string as_markdown(const Derivation& derivation);
std::string as_latex(const Derivation& derivation);  ///< a complete document
std::string as_plain_text(const Derivation& derivation);

}  // namespace gaussgen::lower
