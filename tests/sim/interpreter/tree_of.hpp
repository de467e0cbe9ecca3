#pragma once
// The tree of the header that a model is compiled to.

#include <sstream>
#include <stdexcept>
#include <string>

#include "pipeline.hpp"
#include "support/files.hpp"

namespace headertest {

inline gaussgen::PipelineResult compiled_text(const std::string& path, const std::string& text,
                                              const gaussgen::PipelineOptions& options) {
  gaussgen::support::Source source(path, text, gaussgen::support::read_regular_file);
  gaussgen::support::Diagnostics diagnostics;
  auto result = gaussgen::compile(source, options, diagnostics, {});
  if (!result) throw std::runtime_error(gaussgen::support::render(diagnostics, source));
  return std::move(*result);
}

/// `model`: a file below the root of the project, then outputs, and counts as n=3.
inline gaussgen::PipelineResult compiled_model(const std::string& model) {
  std::istringstream words(model);
  std::string file, why;
  words >> file;
  gaussgen::PipelineOptions options;
  for (std::string word; words >> word;) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos) {
      options.outputs.push_back(word);
    } else {
      options.choices.counts[word.substr(0, sign)] = std::stoi(word.substr(sign + 1));
    }
  }
  const std::string path = std::string(GAUSS_SOURCE_DIR) + "/" + file;
  return compiled_text(path, gaussgen::support::read_file(path, why).value(), options);
}

}  // namespace headertest
