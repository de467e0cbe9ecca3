#pragma once
// The ways to describe one motion: models, how Z is minimised, how equations are written out.

#include <memory>
#include <string>
#include <vector>

#include "sim/run/build_engine.hpp"

namespace gausssim {

struct Form {
  std::string formulation;  ///< as the scene calls it, and how Z is minimised if that is not the usual way
  std::string code;         ///< "optimised", "expanded", "folded"
  PreparedModel model;
  std::vector<std::string> scalars;  ///< number types that it is compiled for
  std::unique_ptr<Engine> engine;
  EngineTimes times;
  std::string why = {};  ///< it cannot be compared with the others; empty: it can
};

/// The scene itself first, and `is_alone` nothing else. Forms of one text are there once. Nothing after an error, which is reported: `code` is the exit code. Throws as `prepare`.
std::vector<Form> forms_of(const std::string& file, bool is_alone, const gaussgen::cli::MessageOptions& messages,
                           int& code);

}  // namespace gausssim
