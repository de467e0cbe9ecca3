#include "model/inertia.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/ast_build.hpp"
#include "model/fields.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Node;
using spec::NodeKind;
using support::Span;

namespace {

void read_diagonal(const Node& list, Inertia& inertia, Reading& reading) {
  inertia.shape = Inertia::Shape::diagonal;
  for (std::size_t i = 0; i < 3; ++i) inertia.entries[i] = read_expression(list.items[i], list.span, reading);
}

/// What stands for both entries.
Ast mirrored(const Ast& upper, const Ast& lower, std::size_t row, std::size_t column, Reading& reading) {
  if (is_broken(upper) || is_broken(lower) || same_expression(upper, lower)) return upper;
  reading.diagnostics.error(
      code::k_asymmetric_inertia, lower.span,
      fmt::format("the entry in row {}, column {} of the inertia matrix differs from the one in row {}, column {}",
                  column + 1, row + 1, row + 1, column + 1),
      "an inertia matrix is symmetric: write the same expression in both places");
  // Without a value nothing is said of moments; names in both are looked at.
  return sum_of(sum_of(upper, lower), broken_expression());
}

void read_matrix(const Node& list, Inertia& inertia, Reading& reading) {
  // xx, yy, zz, xy, xz, yz
  constexpr std::size_t k_slot[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  inertia.shape = Inertia::Shape::full;
  std::array<std::array<Ast, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i)
    rows[i] = read_vector(list.items[i], list.span, "a row of the inertia matrix", reading);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      inertia.entries[k_slot[i][j]] = j > i ? mirrored(rows[i][j], rows[j][i], i, j, reading) : rows[i][j];
    }
  }
}

}  // namespace

bool same_expression(const Ast& a, const Ast& b) {
  if (a.kind != b.kind || a.name != b.name || a.number != b.number) return false;
  return std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), same_expression);
}

Inertia read_inertia(const spec::Entry& entry, Reading& reading) {
  Inertia inertia;
  const Node& node = entry.value;
  if (node.kind == NodeKind::map) {
    reading.diagnostics.error(code::k_wrong_kind, entry.key.span, "'inertia' is a map",
                              "write J, the three moments [Jx, Jy, Jz], or the matrix [[Jx, Jxy, Jxz], [Jxy, Jy, Jyz], "
                              "[Jxz, Jyz, Jz]], about the mass centre");
    inertia.entries[0] = broken_expression();
    return inertia;
  }
  if (node.kind != NodeKind::sequence) {
    inertia.entries[0] = read_expression(node, entry.key.span, reading);
    return inertia;
  }
  if (!expect_length(node, 3, "'inertia'", reading)) return inertia;
  const bool nested = std::any_of(node.items.begin(), node.items.end(),
                                  [](const Node& item) { return item.kind == NodeKind::sequence; });
  if (nested) {
    read_matrix(node, inertia, reading);
  } else {
    read_diagonal(node, inertia, reading);
  }
  return inertia;
}

}  // namespace gaussgen::model
