#include "sim/run/among_instances.hpp"

#include <fmt/format.h>

#include "cli/assignments.hpp"
#include "cli/overrides.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;
using gaussgen::support::Diagnostic;
using gaussgen::support::Diagnostics;
using gaussgen::support::Severity;

namespace {

std::string identity_of(const Diagnostic& one) {
  return fmt::format("{} {} {} {}", one.span.begin, one.span.end, one.code, one.message);
}

bool is_within(const gaussgen::support::Span& inner, const gaussgen::support::Span& outer) {
  return inner.begin >= outer.begin && inner.end <= outer.end;
}

}  // namespace

void AmongInstances::note(const Diagnostics& found, const std::string& instance, gaussgen::support::Span own) {
  std::set<std::string> of_this_one;
  for (const Diagnostic& one : found.all()) {
    const std::string identity = identity_of(one);
    if (!of_this_one.insert(identity).second) continue;
    Found& noted = in_scene_[identity];
    noted.finding = one;
    noted.instances.push_back(instance);
    noted.is_own = noted.is_own || is_within(one.span, own);
  }
}

Diagnostics AmongInstances::in_scene(std::size_t count) const {
  Diagnostics result;
  for (const auto& [identity, noted] : in_scene_) {
    const bool is_of_all = noted.is_own || noted.instances.size() == count;
    Diagnostic finding = noted.finding;
    if (!is_of_all) finding.message += fmt::format(", of {}", gaussgen::support::joined_first(noted.instances));
    if (is_of_all || finding.severity == Severity::error) result.add(std::move(finding));
  }
  return result;
}

Diagnostics AmongInstances::not_yet_said(const Diagnostics& found) {
  Diagnostics result;
  for (const Diagnostic& one : found.all()) {
    if (said_.insert(identity_of(one)).second) result.add(one);
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
