#include "emit/cpp_printer.hpp"

#include <algorithm>
#include <cctype>

#include "emit/line.hpp"

namespace gaussgen::emit::cpp {

namespace {

constexpr std::size_t k_step = 2;

std::string spaces(std::size_t count) { return std::string(count, ' '); }

class Printer {
 public:
  std::string out;

  void operator()(const Comment& comment) { comment_lines(comment.text, "//", 0); }
  void operator()(const BlankLine&) { out += "\n"; }
  void operator()(const Verbatim& verbatim) { out += verbatim.text; }

  void operator()(const Constant& constant) {
    Line line(0);
    line.text("inline constexpr " + constant.type + " " + constant.name + " = ").expression(constant.value).text(";");
    out += line.str() + (constant.comment.empty() ? "" : "  ///< " + constant.comment) + "\n";
  }

  void operator()(const Table& table) {
    comment_lines(table.comment, "///", 0);
    if (table.is_template) out += "template <class S>\n";
    out += "inline constexpr " + table.type + " " + table.name + "[] = {\n";
    for (const std::vector<Expression>& row : table.rows) row_of_array(row, k_step);
    out += "};\n";
  }

  void operator()(const Struct& type) { structure(type, 0); }
  void operator()(const Function& function) { free_function(function); }

  void operator()(const Instantiation& instantiation) {
    Function function = instantiation.function;
    function.prefix = std::string(instantiation.prefix) + "template";
    function.type = with_scalar(function.type, instantiation.scalar);
    for (Argument& argument : function.arguments) {
      argument = {with_scalar(argument.type, instantiation.scalar), argument.name, true};
    }
    signature(function, ";\n");
  }

 private:
  void comment_lines(const std::string& text, const std::string& mark, std::size_t indent) {
    if (text.empty()) return;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      out += spaces(indent) + mark + (line.empty() ? "" : " " + line) + "\n";
      begin = end + 1;
    }
  }

  void row_of_array(const std::vector<Expression>& row, std::size_t indent) {
    Line line(indent);
    const bool is_plain = row.size() == 1;
    line.text(is_plain ? "" : "{");
    for (std::size_t i = 0; i < row.size(); ++i) line.text(i > 0 ? ", " : "").expression(row[i]);
    out += line.text(is_plain ? "," : "},").str() + "\n";
  }

  void structure(const Struct& type, std::size_t indent) {
    comment_lines(type.comment, "///", indent);
    if (type.is_template) out += spaces(indent) + "template <class S>\n";
    const bool is_empty = type.nested.empty() && type.members.empty() && type.functions.empty();
    out += spaces(indent) + "struct " + type.name + " {" + (is_empty ? "" : "\n");
    for (const Struct& nested : type.nested) structure(nested, indent + k_step);
    if (!type.nested.empty() && !type.members.empty()) out += "\n";
    members(type.members, indent + k_step);
    if (!type.functions.empty() && !type.members.empty()) out += "\n";
    for (const Function& function : type.functions) out += spaces(indent + k_step) + one_line(function) + "\n";
    out += (is_empty ? "" : spaces(indent)) + "}" + (type.instance.empty() ? "" : " " + type.instance) + ";\n";
  }

  // The comments of neighbouring members stand in one column.
  void members(const std::vector<Member>& members, std::size_t indent) {
    std::vector<std::string> texts;
    std::size_t column = 0;
    for (const Member& member : members) {
      Line line(indent);
      line.text(member.type + " " + member.name);
      for (const std::string& size : member.shape) line.text("[" + size + "]");
      if (member.value) line.text(" = ").expression(*member.value);
      texts.push_back(line.text(";").str());
      if (!member.comment.empty()) column = std::max(column, texts.back().size());
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::size_t gap = column > texts[i].size() ? column - texts[i].size() : 0;
      out += texts[i] + (members[i].comment.empty() ? "" : spaces(gap + 2) + "///< " + members[i].comment) + "\n";
    }
  }

  static std::string head(const Function& function) {
    return (function.prefix.empty() ? "" : function.prefix + " ") + function.type + " " + function.name + "(";
  }

  static std::string text_of(const Argument& argument) {
    return argument.type + (argument.is_used ? " " + argument.name : " /*" + argument.name + "*/");
  }

  // Accessors.
  static std::string one_line(const Function& function) {
    std::string text = head(function) + ")" + (function.suffix.empty() ? "" : " " + function.suffix) + " {";
    for (const Statement& statement : function.body) {
      if (const auto* value = std::get_if<Return>(&statement)) text += " return " + print(value->value) + ";";
    }
    return text + " }";
  }

  /// S as a word of its own.
  static std::string with_scalar(const std::string& type, const std::string& scalar) {
    const auto is_in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::string result;
    for (std::size_t i = 0; i < type.size(); ++i) {
      const bool is_scalar =
          type[i] == 'S' && (i == 0 || !is_in_word(type[i - 1])) && (i + 1 == type.size() || !is_in_word(type[i + 1]));
      result += is_scalar ? scalar : std::string(1, type[i]);
    }
    return result;
  }

  void free_function(const Function& function) {
    comment_lines(function.comment, "///", 0);
    if (function.is_template) out += "template <class S>\n";
    signature(function, " {\n");
    for (const Statement& statement : function.body) {
      std::visit([this](const auto& s) { this->statement(s); }, statement);
    }
    out += "}\n";
  }

  void signature(const Function& function, const char* end) {
    std::string line = head(function);
    const std::size_t column = std::min(line.size(), k_line_length / 2);
    for (std::size_t i = 0; i < function.arguments.size(); ++i) {
      const bool is_last = i + 1 == function.arguments.size();
      const std::string argument = text_of(function.arguments[i]) + (is_last ? ")" : ", ");
      if (i > 0 && line.size() + argument.size() + (is_last ? 11 : 0) > k_line_length) {
        line.pop_back();
        out += line + "\n";
        line = spaces(column);
      }
      line += argument;
    }
    out +=
        line + (function.arguments.empty() ? ")" : "") + (function.suffix.empty() ? "" : " " + function.suffix) + end;
  }

  void statement(const Definition& s) { finish(Line(indent_).text(s.type + " " + s.name + " = ").expression(s.value)); }
  void statement(const Declaration& s) {
    Line line(indent_);
    line.text(s.type + " ");
    for (std::size_t i = 0; i < s.names.size(); ++i) line.text((i > 0 ? ", " : "") + s.names[i]);
    finish(line);
  }
  void statement(const Alias& s) { finish(Line(indent_).text("using " + s.name + " = " + s.type)); }
  void statement(const Assignment& s) { finish(Line(indent_).expression(s.target).text(" = ").expression(s.value)); }
  void statement(const Evaluation& s) { finish(Line(indent_).expression(s.expression)); }
  void statement(const Return& s) { finish(Line(indent_).text("return ").expression(s.value)); }
  void statement(const EarlyReturn& s) {
    finish(Line(indent_).text("if (").expression(s.condition).text(") return ").expression(s.value));
  }
  void statement(const BlankLine&) { out += "\n"; }
  void statement(const Comment& s) { comment_lines(s.text, "//", indent_); }

  void statement(const Array& s) {
    const std::string size = "[" + std::to_string(s.rows.size()) + "][" + std::to_string(s.rows.front().size()) + "]";
    out += spaces(indent_) + "const " + s.type + " " + s.name + size + " = {\n";
    for (const std::vector<Expression>& row : s.rows) row_of_array(row, indent_ + 2 * k_step);
    out += spaces(indent_) + "};\n";
  }

  void statement(const Loop& s) {
    const std::string& i = s.index;
    const std::string also = s.condition.empty() ? "" : " && " + s.condition;
    out += spaces(indent_) + "for (int " + i + " = " + s.from + "; " + i + " < " + s.to + also + "; ++" + i + ") {\n";
    indent_ += k_step;
    for (const AnyStatement& inner : s.body) {
      std::visit([this](const auto& one) { this->statement(one); }, inner.statement);
    }
    indent_ -= k_step;
    out += spaces(indent_) + "}\n";
  }

  void finish(Line line) { out += line.text(";").str() + "\n"; }

  std::size_t indent_ = k_step;  ///< of statements
};

}  // namespace

std::string print(const File& file) {
  Printer printer;
  for (const Item& item : file.before) std::visit(printer, item);
  printer.out += "namespace " + file.name_space + " {\n";
  for (const Item& item : file.items) std::visit(printer, item);
  printer.out += "}  // namespace " + file.name_space + "\n";
  for (const Item& item : file.after) std::visit(printer, item);
  return std::move(printer.out);
}

std::string print(const Expression& expression) { return Line(0).expression(expression).str(); }

}  // namespace gaussgen::emit::cpp
