// `prepare`: formulas of the model in the order in which they need each other, then the terms that functions read.

#include <algorithm>

#include "emit/body.hpp"
#include "emit/functions.hpp"
#include "passes/schedule.hpp"
#include "passes/share.hpp"

namespace gaussgen::emit {

namespace {

using passes::Request;
using passes::Writing;

class PrepareBuilder {
 public:
  explicit PrepareBuilder(Plan& plan) : plan_(plan), scope_(plan.names.function_scope()) {}

  cpp::Function build() {
    function_.comment = "What depends on parameters alone, to be computed once.";
    function_.prefix = "GAUSS_FUNCTION";
    function_.type = "Prepared<S>";
    function_.name = "prepare";
    function_.suffix = "noexcept";
    read_parameters();
    for (const PreparedMember& member : plan_.prepared) {
      if (member.is_formula) compute_formula(member);
    }
    blank_line();
    fill_members();
    name_type_of_conditions(function_.body);
    return std::move(function_);
  }

 private:
  void append(Body& body) {
    for (cpp::Statement& statement : body.take()) function_.body.push_back(std::move(statement));
  }

  void blank_line() {
    const bool is_needed = !function_.body.empty() && !std::holds_alternative<cpp::BlankLine>(function_.body.back());
    if (is_needed) function_.body.push_back(cpp::BlankLine{});
  }

  void read_parameters() {
    std::vector<NodeId> roots;
    for (const PreparedMember& member : plan_.prepared) roots.push_back(member.value);
    const Writing writing(plan_.graph, roots);
    for (const ParameterEntry& parameter : plan_.unit.parameters) {
      if (parameter.is_formula || !writing.contains(plan_.graph.use(parameter.entry.symbol))) continue;
      const std::string& name = plan_.names.of(parameter.entry);
      function_.body.push_back(cpp::Definition{"const S&", name, cpp::atom("parameters." + name)});
    }
    const bool reads = !function_.body.empty();
    function_.arguments = {{"const Parameters<S>&", "parameters", reads}};
    blank_line();
  }

  // Formula by formula, since later ones use the names of earlier ones.
  void compute_formula(const PreparedMember& member) {
    const Request request{{member.value}, {}, {}};
    const Writing writing(plan_.graph, request.outputs);
    Body body(writing, plan_.names, scope_);
    body.define(schedule(writing, share(writing, request), request));
    body.add(cpp::Definition{"const S", member.name, body.value(member.value)});
    append(body);
  }

  void fill_members() {
    Request request;
    for (const PreparedMember& member : plan_.prepared) {
      if (member.is_plain || member.is_formula) continue;
      request.outputs.push_back(member.value);
      request.suggestions.emplace_back(member.value, member.name);
    }
    const Writing writing(plan_.graph, request.outputs);
    Body body(writing, plan_.names, scope_);
    for (const auto& [value, name] : request.suggestions) body.reserve(passes::unwrapped(plan_.graph, value), name);
    body.define(schedule(writing, share(writing, request), request));
    body.blank_line();
    append(body);
    blank_line();
    body.add(cpp::Declaration{"Prepared<S>", {"prepared"}});
    for (const PreparedMember& member : plan_.prepared) {
      const bool is_local = member.is_formula || member.is_plain;
      cpp::Expression value = is_local ? cpp::atom(member.name) : body.value(member.value);
      body.add(cpp::Assignment{cpp::atom("prepared." + member.name), std::move(value)});
    }
    body.add(cpp::Return{cpp::atom("prepared")});
    append(body);
  }

  Plan& plan_;
  NameScope scope_;
  cpp::Function function_;
};

}  // namespace

cpp::Function prepare_function(Plan& plan) { return PrepareBuilder(plan).build(); }

}  // namespace gaussgen::emit
