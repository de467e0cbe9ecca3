#include "spec/reader.hpp"

#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>
#include <algorithm>

#include <locale>
#include <sstream>
#include <utility>

#include "spec/syntax_error.hpp"
#include "spec/text_check.hpp"
#include "spec/tree_builder.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::spec {

namespace code = support::code;

namespace {

/// Every document, so that a second one is noticed. False when the text could not be read to its end.
bool run_parser(const support::Source& source, TreeBuilder& builder, support::Diagnostics& diagnostics) {
  const std::size_t mark = byte_order_mark(source.text());
  std::string text(source.text().substr(mark));
  // yaml-cpp 0.7 says less of a quote that is open where the last line ends without it.
  if (!text.empty() && text.back() != '\n') text += '\n';
  std::istringstream stream{std::move(text)};
  stream.imbue(std::locale::classic());
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return true;
  } catch (const Stop&) {
    return false;
  } catch (const YAML::Exception& error) {
    // An escape without a character, at the end of the text, is behind it.
    const auto at = static_cast<std::uint32_t>((error.mark.pos < 0 ? 0 : error.mark.pos) + static_cast<int>(mark));
    report_syntax_error(source, std::min(at, static_cast<std::uint32_t>(source.text().size())), error.msg, diagnostics);
    return false;
  }
}

}  // namespace

std::optional<Node> read_yaml(const support::Source& source, support::Diagnostics& diagnostics) {
  if (!check_text(source, diagnostics)) return std::nullopt;
  TreeBuilder builder(source, diagnostics);
  if (!run_parser(source, builder, diagnostics) || builder.has_holes()) return std::nullopt;
  std::optional<Node> root = builder.take_root();
  if (!root || root->kind == NodeKind::empty) {
    diagnostics.error(code::k_empty_file, {0, 0}, "the file is empty", "begin with 'gauss: 1' and 'name: ...'");
    return std::nullopt;
  }
  return root;
}

std::optional<Node> read_yaml_behind(support::Source& source, const std::string& name, const std::string& text,
                                     support::Diagnostics& diagnostics) {
  support::Diagnostics found;
  std::optional<Node> root = read_yaml({name, text}, found);
  const std::uint32_t begin = source.add(name, text);
  for (support::Diagnostic finding : found.all()) {
    finding.span = {finding.span.begin + begin, finding.span.end + begin};
    diagnostics.add(std::move(finding));
  }
  if (root) shift(*root, begin);
  return root;
}

}  // namespace gaussgen::spec
