#include "emit/header.hpp"

#include "emit/cpp_printer.hpp"
#include "emit/functions.hpp"
#include "emit/identifiers.hpp"
#include "emit/lookup.hpp"
#include "emit/patterns.hpp"
#include "emit/provenance.hpp"
#include "emit/structs.hpp"
#include "emit/tables.hpp"

namespace gaussgen::emit {

namespace {

// gauss::linux -> gauss::linux_; the names of ours are reserved inside gauss only as a whole word.
std::string safe_name_space(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find("::", begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    result += (result.empty() ? "" : "::") + (part == "gauss" && begin == 0 ? part : mangled(part));
    begin = end + 2;
  }
  return result;
}

std::string guard_name(const std::string& name_space) {
  std::string guard = "GAUSS_MODEL_";
  for (const char c : name_space) {
    if (c >= 'a' && c <= 'z') {
      guard += static_cast<char>(c - 'a' + 'A');
    } else if (const char kept = c == ':' ? '_' : c; kept != '_' || guard.back() != '_') {
      guard += kept;
    }
  }
  return guard + (guard.back() == '_' ? "HPP" : "_HPP");
}

class HeaderBuilder {
 public:
  explicit HeaderBuilder(Plan& plan) : plan_(plan) { file_.name_space = safe_name_space(plan.unit.name_space); }

  cpp::File build() {
    const std::string guard = guard_name(file_.name_space);
    std::vector<cpp::Function> functions{prepare_function(plan_)};
    for (const Task& task : plan_.tasks) functions.push_back(artefact_function(plan_, task));
    std::vector<cpp::Function> tables = table_functions(plan_);
    file_.before = {cpp::Comment{provenance_text(plan_, functions, costs_of(tables))}, cpp::BlankLine{},
                    cpp::Verbatim{"#ifndef " + guard + "\n#define " + guard + "\n\n"},
                    cpp::Verbatim{std::string(prelude())}, cpp::BlankLine{}};
    // A model outside of namespace gauss still needs Math, Status and their like.
    const bool is_inside = file_.name_space.rfind("gauss::", 0) == 0;
    file_.items.emplace_back(cpp::BlankLine{});
    if (!is_inside) add(cpp::Verbatim{"using namespace ::gauss;\n"});
    add_all(sizes(plan_));
    // Before everything that may call them, default values included.
    for (cpp::Function& function : tables) add(std::move(function));
    for (cpp::Struct& type : types()) add(std::move(type));
    for (cpp::Struct& type : pattern_structs(plan_.unit)) add(std::move(type));
    for (cpp::Function& function : functions) add(std::move(function));
    for (cpp::Function& function : dense_functions(plan_)) add(std::move(function));
    add_all(introspection_tables(plan_));
    file_.after = {cpp::BlankLine{}, cpp::Verbatim{"#endif  // " + guard + "\n"}};
    return std::move(file_);
  }

 private:
  void add(cpp::Item item) { add_all({std::move(item)}); }

  void add_all(std::vector<cpp::Item> items) {
    for (cpp::Item& item : items) file_.items.push_back(std::move(item));
    file_.items.emplace_back(cpp::BlankLine{});
  }

  std::vector<cpp::Struct> types() {
    std::vector<cpp::Struct> result{parameters_struct(plan_), inputs_struct(plan_), prepared_struct(plan_),
                                    state_struct(plan_), derivative_struct(plan_)};
    for (cpp::Struct& type : plan_.result_types.structs()) result.push_back(std::move(type));
    return result;
  }

  Plan& plan_;
  cpp::File file_;
};

}  // namespace

Header build_header(const ir::Graph& graph, const Unit& unit) {
  Plan plan(graph, unit);
  Header header;
  header.planned = std::chrono::steady_clock::now();
  header.nodes_planned = plan.graph.size();
  for (Task& task : plan.tasks) header.passes.push_back({task.artefact->name, std::move(task.effects)});
  header.text = cpp::print(HeaderBuilder(plan).build());
  header.nodes = plan.graph.size();
  return header;
}

std::string emit_header(const ir::Graph& graph, const Unit& unit) { return build_header(graph, unit).text; }

}  // namespace gaussgen::emit
