#include "sim/run/among_instances.hpp"

#include <fmt/format.h>

#include "cli/assignments.hpp"
#include "cli/overrides.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;
using gaussgen::support::Diagnostic;
using gaussgen::support::Diagnostics;
using gaussgen::support::Severity;

namespace {

std::string identity_of(const Diagnostic& one, const std::string& file) {
  return fmt::format("{} {} {} {} {}", file, one.span.begin, one.span.end, one.code, one.message);
}

bool is_within(const gaussgen::support::Span& inner, const gaussgen::support::Span& outer) {
  return inner.begin >= outer.begin && inner.end <= outer.end;
}

}  // namespace

Diagnostics AmongInstances::not_yet_said(const Diagnostics& found, bool is_of_scene, const std::string& file,
                                         gaussgen::support::Span own) {
  Diagnostics result;
  std::set<std::string> of_this_one;
  for (const Diagnostic& one : found.all()) {
    const std::string identity = identity_of(one, file);
    const bool waits = is_of_scene && one.severity == Severity::warning && !is_within(one.span, own);
    if (waits && of_this_one.insert(identity).second) {
      Waiting& waiting = waiting_[identity];
      waiting.warning = one;
      ++waiting.count;
    } else if (!waits && said_.insert(identity).second) {
      result.add(one);
    }
  }
  return result;
}

Diagnostics AmongInstances::for_all(std::size_t count) const {
  Diagnostics result;
  for (const auto& [identity, waiting] : waiting_) {
    if (waiting.count == count) result.add(waiting.warning);
  }
  return result;
}

std::vector<std::string> AmongInstances::sets_for(const std::vector<std::string>& sets,
                                                  const gaussgen::model::Model& read) {
  std::vector<std::string> kept;
  for (const std::string& set : sets) {
    const std::string name = cli::trimmed(set.substr(0, set.find('=')));
    if (cli::absent_effect_of(name, read) != nullptr) continue;
    kept.push_back(set);
    taken_.insert(set);
  }
  return kept;
}

std::string AmongInstances::set_for_nobody(const std::vector<std::string>& sets) const {
  for (const std::string& set : sets) {
    if (taken_.count(set) == 0) return set;
  }
  return "";
}

}  // namespace gausssim
