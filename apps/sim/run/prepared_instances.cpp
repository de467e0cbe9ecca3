#include "sim/run/prepared_instances.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/exit_codes.hpp"
#include "cli/usage_error.hpp"
#include "sim/run/settings.hpp"
#include "sim/scene/instances.hpp"
#include "sim/scene/read_scene.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
namespace code = gaussgen::support::code;
using gaussgen::support::Diagnostics;
using gaussgen::support::Source;

std::string take_one_of(const Scene& scene) {
  const std::vector<std::string> names = instance_names(scene);
  return fmt::format("--instance {} takes one of them; there are {}", names.front(),
                     gaussgen::support::joined_first(names));
}

/// A setting is found for one motion.
void refuse_error(const RunOptions& options, const Scene& scene, Diagnostics& found) {
  if (options.error)
    throw cli::UsageError("--error: a setting is looked for of one motion, and these are several: " +
                          take_one_of(scene));
  if (scene.error && !options.tolerance && !options.step)
    found.error(code::k_conflicting_keys, scene.places.at("error"),
                "a setting is looked for of one motion, and these are several", take_one_of(scene));
}

/// They are rows of one table. Other values of parameters may make other times of them.
void check_times(const std::vector<std::unique_ptr<const PreparedModel>>& all, Diagnostics& found) {
  const PreparedModel& first = *all.front();
  for (const auto& other : all) {
    const auto differ = [&](const char* key, double a, double b, const std::optional<gaussgen::model::Ast>& given) {
      if (a == b || !given || found.has_errors()) return;
      const std::string message =
          fmt::format("'{}' is {:.6g} s for '{}' and {:.6g} s for '{}': instances have the same rows", key, a,
                      first.scene.instance, b, other->scene.instance);
      if (!given->text.empty()) throw cli::UsageError(fmt::format("--{}: {}", key, message));
      found.error(code::k_conflicting_keys, given->span, message, "write it without what differs between them");
    };
    const Span &a = first.span, &b = other->span;
    differ("start", a.start, b.start, first.scene.start);
    differ("every", a.every, b.every, first.scene.every);
    differ("duration", a.duration, b.duration, first.scene.duration);
  }
}

}  // namespace

namespace {

/// Each by itself; those that are wrong are missing. Returns an exit code.
int prepare_each(const RunOptions& options, const Source& text, const Scene& scene, PreparedInstances& result) {
  int worst = cli::k_ok;
  for (const Instance& one : scene.instances) {
    int own = cli::k_ok;
    auto prepared = prepare_instance(options, one.name.text, text, *result.among, own);
    if (!prepared && worst == cli::k_ok) worst = own;
    if (prepared) result.all.push_back(std::make_unique<const PreparedModel>(std::move(*prepared)));
  }
  return worst;
}

Diagnostics joined(const Diagnostics& first, Diagnostics second) {
  for (const auto& one : first.all()) second.add(one);
  return second;
}

}  // namespace

std::optional<PreparedInstances> prepare_instances(const RunOptions& options, const Source& text, int& code) {
  Diagnostics said_by_each, of_all;
  const Scene scene = read_scene(text, said_by_each).value_or(Scene());
  PreparedInstances result;
  result.among = std::make_unique<AmongInstances>();
  const auto say = [&] {
    return cli::report(joined(of_all, result.among->in_scene(scene.instances.size())), text, options.messages);
  };
  try {
    refuse_error(options, scene, of_all);
    code = prepare_each(options, text, scene, result);
    if (code == cli::k_ok) check_times(result.all, of_all);
    if (const std::string nobody = result.among->set_for_nobody(options.sets); code == cli::k_ok && !nobody.empty())
      throw cli::UsageError(fmt::format("--set {}: it is of an effect that acts for none of the instances", nobody));
  } catch (...) {
    // The command line is wrong, and the scene may be, too.
    say();
    throw;
  }
  const int of_scene = say();
  if (code == cli::k_ok) code = of_scene;
  if (code != cli::k_ok) return std::nullopt;
  return result;
}

}  // namespace gausssim
