#pragma once
// Shared by the tests of this folder.

#include <string>

#include "spec/reader.hpp"

namespace test {

struct Read {
  gaussgen::support::Source source;
  gaussgen::support::Diagnostics diagnostics;
  std::optional<gaussgen::spec::Node> root;

  explicit Read(const std::string& text)
      : source("m.yaml", text), root(gaussgen::spec::read_yaml(source, diagnostics)) {}

  /// The code of the first finding, or an empty text.
  std::string code() const { return diagnostics.all().empty() ? "" : diagnostics.all()[0].code; }
  gaussgen::support::Position place(std::size_t finding = 0) const {
    return source.position(diagnostics.all().at(finding).span.begin);
  }

  const gaussgen::spec::Node& at(const std::string& key) const {
    static const gaussgen::spec::Node nothing;
    const auto* node = root ? gaussgen::spec::find(*root, key) : nullptr;
    return node == nullptr ? nothing : *node;
  }

  /// What the source says behind text[begin, end) of the scalar at `key`.
  std::string behind(const std::string& key, const std::string& part) const {
    const auto& scalar = at(key).scalar;
    const std::size_t begin = scalar.text.find(part);
    if (begin == std::string::npos) return "<absent>";
    return std::string(source.text(scalar.span_of(begin, begin + part.size())));
  }
};

}  // namespace test
