#pragma once
// The ways to describe one motion: models, how Z is minimised, how equations are written out.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/run/build_engine.hpp"

namespace gausssim {

/// One plugin for each number type, as a run has it: compilers inline less in larger ones.
class EngineOfNumbers final : public Engine {
 public:
  void add(const std::string& scalar, std::unique_ptr<const Engine> engine) { engines_[scalar] = std::move(engine); }

  const char* name() const override { return "compiled"; }
  Entry find(const std::string& function, const std::string& scalar) const override {
    const auto found = engines_.find(scalar);
    return found == engines_.end() ? Entry{} : found->second->find(function, scalar);
  }
  std::unique_ptr<const Engine> another() const override {
    auto copy = std::make_unique<EngineOfNumbers>();
    for (const auto& [scalar, engine] : engines_) copy->add(scalar, engine->another());
    return copy;
  }

 private:
  std::map<std::string, std::unique_ptr<const Engine>> engines_;
};

struct Form {
  std::string formulation;  ///< as the scene calls it, and how Z is minimised if that is not the usual way
  std::string code;         ///< "optimised", "expanded", "folded"
  PreparedModel model;
  std::vector<std::string> scalars;  ///< number types that it is compiled for
  std::unique_ptr<Engine> engine;
  EngineTimes times;
  std::string why = {};      ///< it cannot be compared with the others; empty: it can
  bool is_of_scene = false;  ///< one of its `formulations`
};

/// The scene itself, or its `instance`, first, and `is_alone` nothing else. Forms of one text are there once. Nothing after an error, which is reported: `code` is the exit code. Throws as `prepare`, and Interrupted.
std::vector<Form> forms_of(const std::string& file, const std::string& instance, bool is_alone,
                           const gaussgen::cli::MessageOptions& messages, int& code);

}  // namespace gausssim
