// tables: functions by their points. They are read before all expressions, which may call them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/constant.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/parser.hpp"
#include "model/points.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using support::Rational;

namespace {

constexpr std::size_t k_most_points = 256;
constexpr double k_most_bits = 1 << 16;  ///< of all numbers of a table together: exact splines stay quick
constexpr double k_largest_slope = 1e290;
constexpr double k_smallest_slope = 1e-290;

/// A word out of two, or the default when the key is absent.
template <class Word>
Word choice(const spec::Node& map, const std::string& key, const std::pair<std::string, Word>& one,
            const std::pair<std::string, Word>& other, Word missing, Reading& reading) {
  const spec::Node* node = spec::find(map, key);
  if (node == nullptr || !expect_scalar(*node, map.span, "'" + key + "'", reading)) return missing;
  for (const auto& [text, word] : {one, other}) {
    if (node->scalar.text == text) return word;
  }
  reading.diagnostics.error(code::k_unknown_word, node->span,
                            fmt::format("'{}' is {} or {}, not '{}'", key, one.first, other.first, node->scalar.text),
                            fmt::format("write '{}: {}' or '{}: {}'", key, one.first, key, other.first));
  return missing;
}

/// pi as a number that serves for all digits that anyone asks for in practice.
Ast with_number_for_pi(Ast ast) {
  for (Ast& child : ast.children) child = with_number_for_pi(std::move(child));
  if (ast.kind != AstKind::symbol || ast.name != "pi") return ast;
  ast.kind = AstKind::number;
  ast.number = pi_of_table();
  return ast;
}

bool has_name(const Ast& ast) {
  if (ast.kind == AstKind::symbol && ast.name != "pi") return true;
  for (const Ast& child : ast.children) {
    if (has_name(child)) return true;
  }
  return false;
}

bool are_in_range(const std::vector<Ast>& all) {
  return std::all_of(all.begin(), all.end(), [](const Ast& ast) {
    return (ast.kind != AstKind::number || is_in_range_of_double(ast.number)) && are_in_range(ast.children);
  });
}

class TableReader {
 public:
  TableReader(const Entry& entry, Reading& reading)
      : entry_(entry), where_(fmt::format("table '{}'", entry.key.text)), reading_(reading) {}

  Table run() {
    Table table;
    table.name = name_of(entry_.key);
    if (!expect_map(entry_.value, entry_.key.span, where_, reading_)) return table;
    check_keys(entry_.value, where_, format::keys_of(format::table()), reading_);
    table.of = list("of");
    table.values = list("values");
    const std::size_t findings = reading_.diagnostics.all().size();
    read_course(table);
    // How smooth it is meant to be is open.
    const bool is_slip =
        has_misspelt(entry_.value, "kind", reading_) || has_misspelt(entry_.value, "outside", reading_);
    is_good_ = is_good_ && !is_slip && reading_.diagnostics.all().size() == findings;
    read_words(table);
    const auto of = numbers(table.of);
    const auto values = numbers(table.values);
    if (!is_good_ || !has_good_size(table) || !grows(table.of, *of)) return table;
    // Numbers beyond double are refused where all expressions are checked.
    if (!are_in_range(table.of) || !are_in_range(table.values)) return table;
    table.function = function_of(table, {*of, *values});
    return table;
  }

 private:
  void refuse(support::Span span, std::string message, std::string hint) {
    reading_.diagnostics.error(code::k_table_points, span, std::move(message), std::move(hint));
    is_good_ = false;
  }

  /// Between the points and beyond them.
  void read_course(Table& table) {
    using Kind = Table::Kind;
    using Outside = Table::Outside;
    const spec::Node& map = entry_.value;
    table.kind = choice<Kind>(map, "kind", {"linear", Kind::linear}, {"spline", Kind::spline}, Kind::linear, reading_);
    const Outside by_kind = table.kind == Kind::spline ? Outside::extend : Outside::hold;
    table.outside =
        choice<Outside>(map, "outside", {"hold", Outside::hold}, {"extend", Outside::extend}, by_kind, reading_);
  }

  void read_words(Table& table) {
    const spec::Node& map = entry_.value;
    table.of_unit = text_field(map, "of_unit", reading_);
    table.of_dimension = dimension_at(map, "of_unit", table.of_unit, reading_);
    read_unit(map, table, reading_);
    table.about = text_field(map, "about", reading_);
  }

  std::vector<Ast> list(const std::string& key) {
    std::vector<Ast> entries;
    const spec::Node* node = required(entry_.value, key, entry_.key.span, where_, reading_);
    if (node == nullptr || !expect_list(*node, entry_.key.span, "'" + key + "'", reading_)) {
      is_good_ = false;
      return entries;
    }
    for (const spec::Node& item : node->items) entries.push_back(read_expression(item, node->span, reading_));
    spans_.push_back(node->span);
    return entries;
  }

  /// Names other than pi are refused where all expressions are checked.
  std::optional<std::vector<Rational>> numbers(const std::vector<Ast>& entries) {
    std::vector<Rational> values;
    for (const Ast& entry : entries) {
      const auto value = exact_value(with_number_for_pi(entry));
      if (!value && !is_broken(entry) && !has_name(entry)) {
        refuse(entry.span, "a point of a table is a number, or made of numbers and pi by + - * / ^",
               "write its value as a decimal number");
      }
      is_good_ = is_good_ && value;
      values.push_back(value.value_or(0));
      bits_ += growth(entry);
    }
    return values;
  }

  bool has_good_size(const Table& table) {
    const std::size_t points = table.of.size();
    const std::size_t least = table.kind == Table::Kind::spline ? 3 : 2;
    if (points != table.values.size()) {
      refuse(spans_[1],
             fmt::format("{} has {} entries in 'of' and {} in 'values'", where_, points, table.values.size()),
             "write one value for each point; a comma separates entries, the decimal sign is a point");
    } else if (points < least) {
      refuse(spans_[0], fmt::format("{} has {} point{}, and needs {}", where_, points, points == 1 ? "" : "s", least),
             "a straight line needs 2 points, a spline 3");
    } else if (points > k_most_points) {
      refuse(spans_[0], fmt::format("{} has {} points; the limit is {}", where_, points, k_most_points),
             "emitted code compares with all of them at each call: leave out points between which others interpolate "
             "well");
    } else if (bits_ > k_most_bits) {
      refuse(spans_[0], fmt::format("the numbers of {} have too many digits", where_), "round them");
    }
    return is_good_;
  }

  bool grows(const std::vector<Ast>& entries, const std::vector<Rational>& of) {
    for (std::size_t i = 1; i < of.size(); ++i) {
      if (of[i] > of[i - 1]) continue;
      refuse(entries[i].span,
             fmt::format("the entries of 'of' have to grow, and this is {} the one before it",
                         of[i] == of[i - 1] ? "equal to" : "less than"),
             of[i] == of[i - 1] ? "a table has one value at each place; for a jump write piecewise(...)"
                                : "sort the points");
      return false;
    }
    return true;
  }

  std::shared_ptr<const support::Table> function_of(const Table& table, const Points& points) {
    auto function = std::make_shared<support::Table>();
    function->name = table.name.text;
    function->about = described(table);
    function->pieces = pieces_through(points, table.kind, table.outside);
    function->derivatives = derivatives_of(table.kind, table.outside);
    for (const auto& piece : function->pieces) {
      for (const Rational& coefficient : piece.coefficients) {
        const double size = std::abs(support::to_double(coefficient));
        if (coefficient == 0 || (size > k_smallest_slope && size < k_largest_slope)) continue;
        refuse(entry_.key.span, fmt::format("{} is too steep or too flat for the arithmetic of a computer", where_),
               "choose units in which numbers are of moderate size");
        return nullptr;
      }
    }
    return function;
  }

  static std::string described(const Table& table) {
    const bool is_spline = table.kind == Table::Kind::spline;
    std::string text = table.about + (table.about.empty() ? "" : "; ");
    text +=
        fmt::format("{} {} points, {} outside of them", is_spline ? "natural cubic spline through" : "straight between",
                    table.of.size(), table.outside == Table::Outside::hold ? "constant" : "straight");
    if (!table.unit.empty()) text += fmt::format("; values in {}", table.unit);
    if (!table.of_unit.empty()) text += fmt::format("; x in {}", table.of_unit);
    return text + ".";
  }

  const Entry& entry_;
  std::string where_;
  Reading& reading_;
  std::vector<support::Span> spans_;  ///< of the lists
  double bits_ = 0;
  bool is_good_ = true;
};

}  // namespace

void read_tables(const spec::Node& root, Reading& reading) {
  KnownTables tables;  // known only afterwards: a table does not call another one
  read_section(root, "tables", reading, [&](const Entry& entry) {
    Table table = TableReader(entry, reading).run();
    if (declare_table(table.name, reading)) tables.emplace(table.name.text, table.function);
    reading.model.tables.push_back(std::move(table));
  });
  for (const Entry& section : root.entries) {
    const bool is_misspelt = reading.unknown_keys.count(section.key.span.begin) > 0 &&
                             support::closest(section.key.text, {"tables"}) == "tables";
    const bool is_unread = section.key.text == "tables" && section.value.kind != spec::NodeKind::map;
    if (is_unread && section.value.kind != spec::NodeKind::empty) tables.emplace(k_any_table, nullptr);
    for (const Entry& table : section.value.entries) {
      if (is_misspelt) tables.emplace(table.key.text, nullptr);
    }
  }
  reading.tables = std::move(tables);
}

}  // namespace gaussgen::model
