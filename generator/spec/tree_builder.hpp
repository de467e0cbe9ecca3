#pragma once
// yaml-cpp's events to a Node tree. Private to the folder.

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <optional>
#include <string>
#include <vector>

#include "spec/align.hpp"
#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::spec {

/// Ends yaml-cpp's parse early; what happened is already reported.
struct Stop {};

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const support::Source& source, support::Diagnostics& diagnostics);

  /// The tree of the only document; empty when the text held nothing.
  std::optional<Node> take_root() { return std::move(root_); }

  /// As a tree with aliases has: reading on would report what stands behind them as missing.
  bool has_holes() const { return has_holes_; }

  void OnDocumentStart(const YAML::Mark& mark) override;
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override;
  void OnSequenceEnd() override;
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override;
  void OnMapEnd() override;

 private:
  struct Open {
    Node node;
    std::optional<LocatedText> key;  ///< of a map: read, and its value not yet
    bool bad_key = false;            ///< the key was refused, so its value is dropped
  };

  std::uint32_t offset(const YAML::Mark& mark) const;
  bool expects_key() const;
  void count_node(support::Span span);
  void refuse_extras(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor);
  void open(const YAML::Mark& mark, NodeKind kind, YAML::EmitterStyle::value style);
  void refuse_slip_of_key(const LocatedText& key);
  void take_empty_key(support::Span span);
  void refuse_key(support::Span span);
  bool refuse_escaped_characters(LocatedText& scalar);
  void check_key_length(const LocatedText& key);
  void close();
  void add(Node node);
  void drop_repeated_keys(std::vector<Entry>& entries);

  const support::Source& source_;
  support::Diagnostics& diagnostics_;
  std::uint32_t skipped_;  ///< bytes of a byte order mark, which yaml-cpp does not count
  std::optional<Node> root_;
  std::vector<Open> open_;
  int nodes_ = 0;
  int documents_ = 0;
  bool has_holes_ = false;
};

}  // namespace gaussgen::spec
