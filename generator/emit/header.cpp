#include "emit/header.hpp"

#include <algorithm>
#include <utility>

#include "emit/cpp_printer.hpp"
#include "emit/functions.hpp"
#include "emit/identifiers.hpp"
#include "emit/lookup.hpp"
#include "emit/operations.hpp"
#include "emit/patterns.hpp"
#include "emit/provenance.hpp"
#include "emit/structs.hpp"
#include "emit/tables.hpp"
#include "emit/two_ways.hpp"

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

bool has_series(const Unit& unit) {
  return std::any_of(unit.artefacts.begin(), unit.artefacts.end(), [](const Artefact& one) { return one.is_series; });
}

bool has_two_ways(const Unit& unit) {
  return std::any_of(unit.artefacts.begin(), unit.artefacts.end(), [](const Artefact& one) { return one.ways; });
}

class HeaderBuilder {
 public:
  explicit HeaderBuilder(Plan& plan) : plan_(plan) { file_.name_space = safe_name_space(plan.unit.name_space); }

  cpp::File header() {
    const std::string guard = guard_name(file_.name_space);
    std::vector<cpp::Function> functions{prepare_function(plan_)};
    std::vector<Parts> parts;
    auto task = plan_.tasks.begin();
    for (const Artefact& artefact : plan_.unit.artefacts) {
      if (artefact.ways) {
        parts.push_back(two_ways(artefact));
        functions.push_back(parts.back().function);
        continue;
      }
      FunctionCode code =
          artefact.is_caller() ? FunctionCode{search_function(artefact)} : artefact_function(plan_, *task++);
      functions.push_back(code.function);
      parts.push_back(split(std::move(code), plan_.unit.part_operations));
    }
    std::vector<cpp::Function> tables = table_functions(plan_);
    const std::vector<Operations> counts = operations_of_all(functions, costs_of(tables));
    add_sizes(counts);
    file_.before = {cpp::Comment{provenance_text(plan_, functions, counts)}, cpp::BlankLine{},
                    cpp::Verbatim{"#ifndef " + guard + "\n#define " + guard + "\n\n"},
                    cpp::Verbatim{std::string(prelude())}, cpp::BlankLine{}};
    if (has_two_ways(plan_.unit)) {
      file_.before.emplace_back(cpp::Verbatim{std::string(constrained_prelude())});
      file_.before.emplace_back(cpp::BlankLine{});
    }
    if (has_series(plan_.unit)) {
      file_.before.emplace_back(cpp::Verbatim{std::string(series_prelude())});
      file_.before.emplace_back(cpp::BlankLine{});
    }
    // A model outside of namespace gauss still needs Math, Status and their like.
    const bool is_inside = file_.name_space.rfind("gauss::", 0) == 0;
    file_.items.emplace_back(cpp::BlankLine{});
    if (!is_inside) add(cpp::Verbatim{"using namespace ::gauss;\n"});
    add_all(sizes(plan_));
    // Before everything that may call them, default values included.
    for (cpp::Function& function : tables) add(std::move(function));
    for (cpp::Struct& type : types()) add(std::move(type));
    for (cpp::Struct& type : pattern_structs(plan_.unit)) add(std::move(type));
    if (!plan_.unit.compiled_for.empty()) {
      for (cpp::Function& function : functions) function.prefix = k_separate;
      for (Parts& part : parts) part.function.prefix = k_separate;
    }
    compiled_ = functions;
    add(std::move(functions.front()));
    for (Parts& part : parts) add_parts(std::move(part));
    for (cpp::Function& function : dense_functions(plan_)) add(std::move(function));
    add_all(introspection_tables(plan_));
    if (!plan_.unit.compiled_for.empty()) {
      file_.items.emplace_back(
          cpp::Comment{"Compiled in " + plan_.unit.model_name + ".cpp; with other types, where they are used."});
      add_all(instantiations("extern "));
    }
    file_.after = {cpp::BlankLine{}, cpp::Verbatim{"#endif  // " + guard + "\n"}};
    return std::move(file_);
  }

  /// After the header.
  std::vector<OutputSize> sizes_of_outputs() { return std::move(sizes_); }

  /// After the header.
  cpp::File source() const {
    const Unit& unit = plan_.unit;
    cpp::File file;
    file.name_space = safe_name_space(unit.name_space);
    file.before = {
        cpp::Comment{unit.model_name + ": the functions of its header, compiled once.\nGenerated by gauss-gen " +
                     unit.provenance.tool_version + " from " + unit.provenance.model_file +
                     ". Do not edit.\nCommand: " + unit.provenance.command},
        cpp::BlankLine{}, cpp::Verbatim{"#include \"" + unit.model_name + ".hpp\"\n"}, cpp::BlankLine{}};
    file.items.emplace_back(cpp::BlankLine{});
    for (cpp::Item& item : instantiations("")) file.items.push_back(std::move(item));
    file.items.emplace_back(cpp::BlankLine{});
    return file;
  }

 private:
  /// Of what is not inline: compilers leave templates alone that they find instantiated elsewhere.
  static constexpr const char* k_separate = "GAUSS_SEPARATE";

  std::vector<cpp::Item> instantiations(const char* prefix) const {
    std::vector<cpp::Item> items;
    for (const std::string& scalar : plan_.unit.compiled_for) {
      for (const cpp::Function& function : compiled_) items.emplace_back(cpp::Instantiation{prefix, scalar, function});
    }
    return items;
  }

  /// `counts` are of `prepare`, which belongs to all, then of the artefacts.
  void add_sizes(const std::vector<Operations>& counts) {
    std::size_t next = 1;
    for (const Artefact& artefact : plan_.unit.artefacts) {
      const int operations = total(counts[next++]);
      if (sizes_.empty() || sizes_.back().output != artefact.output) sizes_.push_back({artefact.output, 0});
      // What a search calls is counted where it is written.
      if (!artefact.is_caller()) sizes_.back().operations += operations;
    }
  }

  void add(cpp::Item item) { add_all({std::move(item)}); }

  void add_all(std::vector<cpp::Item> items) {
    for (cpp::Item& item : items) file_.items.push_back(std::move(item));
    file_.items.emplace_back(cpp::BlankLine{});
  }

  void add_parts(Parts parts) {
    if (parts.live) add(std::move(*parts.live));
    for (cpp::Function& function : parts.functions) add(std::move(function));
    add(std::move(parts.function));
  }

  std::vector<cpp::Struct> types() {
    std::vector<cpp::Struct> result{parameters_struct(plan_), inputs_struct(plan_), prepared_struct(plan_),
                                    state_struct(plan_), derivative_struct(plan_)};
    for (cpp::Struct& type : plan_.result_types.structs()) result.push_back(std::move(type));
    return result;
  }

  Plan& plan_;
  cpp::File file_;
  std::vector<cpp::Function> compiled_;
  std::vector<OutputSize> sizes_;
};

}  // namespace

Header build_header(ir::Graph graph, const Unit& unit) {
  Plan plan(std::move(graph), unit);
  Header header;
  header.planned = std::chrono::steady_clock::now();
  header.nodes_planned = plan.graph.size();
  for (Task& task : plan.tasks) header.passes.push_back({task.artefact->name, std::move(task.effects)});
  HeaderBuilder builder(plan);
  header.tree = builder.header();
  header.text = cpp::print(header.tree);
  header.outputs = builder.sizes_of_outputs();
  if (!unit.compiled_for.empty()) header.source = cpp::print(builder.source());
  header.nodes = plan.graph.size();
  return header;
}

std::string emit_header(ir::Graph graph, const Unit& unit) { return build_header(std::move(graph), unit).text; }

}  // namespace gaussgen::emit
