#include "sim/effects/effects.hpp"
#include "scene_choice.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <list>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/effects/ladder.hpp"
#include "sim/effects/ladder_text.hpp"
#include "sim/effects/lean_scene.hpp"
#include "sim/output/files.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// Beside the scene or model, which it names, so that the model is found from there.
std::string lean_path(const EffectsOptions& options) {
  const std::filesystem::path file(options.file);
  return (file.parent_path() / (file.stem().string() + ".lean.yaml")).string();
}

/// Empty: the scene is written in a way in which the key cannot be put, or has others in it.
std::string lean_scene(const EffectsOptions& options, const Workbench& bench, const Measured& chosen) {
  if (!options.instance.empty()) return "";
  const auto source = cli::read_source(options.file);
  const auto names = in_order(chosen.acting, bench.effects());
  if (gaussgen::is_scene(source)) return scene_with_effects(std::string(source.text()), names);
  const std::filesystem::path file(options.file);
  return scene_of_model(file.stem().string() + "_lean", file.filename().string(), names);
}

std::string why_it_cannot_tell(const Workbench& bench, double need) {
  const std::string known =
      bench.noise() ? fmt::format("is good to {:.1e} in {} only", bench.noise()->value, bench.noise()->output)
                    : "has an error that nothing tells: " + bench.why_no_noise();
  return fmt::format(
      "the run with all effects {}, so it cannot tell a change of {:g}; a smaller --tolerance or --step may", known,
      need);
}

bool changes_by_options(const EffectsOptions& options) {
  return !options.sets.empty() || !options.counts.empty() || !options.duration.empty() || !options.start.empty();
}

}  // namespace

int effects(const EffectsOptions& options) {
  const Interruption interruption;
  Workbench bench(options);
  if (const int code = bench.begin(); code != cli::k_ok) return code;
  const std::string output =
      options.output.empty() ? bench.name() + ".effects" : without_ending(options.output, {".json", ".svg", ".yaml"});
  for (const char* const ending : {".json", ".svg"}) check_writable(output + ending);
  const auto ladder = make_ladder(bench);
  if (!ladder) throw Interrupted{};
  EffectsReport report{bench, *ladder, options.need, {}};
  if (options.need) report.chosen = cheapest_within(*ladder, *options.need);
  std::list<cli::Replacement> files;
  files.emplace_back(output + ".json", in_json(report));
  files.emplace_back(output + ".svg", chart_of_effects(report));
  const std::string lean = options.need ? lean_scene(options, bench, *report.chosen) : "";
  if (!lean.empty()) files.emplace_back(lean_path(options), lean);
  const bool is_known = !options.need || (bench.noise() && bench.noise()->value < *options.need);
  if (is_known)
    for (cli::Replacement& file : files) file.commit();
  if (!options.quiet) cli::write_standard_output(in_words(report));
  if (!is_known) return cli::fail(why_it_cannot_tell(bench, *options.need), cli::k_not_delivered, options.messages);
  if (!options.quiet)
    cli::write_standard_output(fmt::format("wrote {0}.json and {0}.svg{1}\n", output,
                                           lean.empty() ? "" : ", and the scene " + lean_path(options)));
  if (options.need && !options.instance.empty())
    cli::remark(fmt::format("no leaner scene is written of one instance; what it needs: effects: [{}]",
                            fmt::join(in_order(report.chosen->acting, bench.effects()), ", ")),
                options.messages);
  else if (options.need && lean.empty())
    cli::warn(fmt::format("'{}' is not written in lines, so no leaner scene is", options.file), options.messages);
  if (!lean.empty() && changes_by_options(options))
    cli::warn("values that options give are not in the leaner scene", options.messages);
  return cli::k_ok;
}

}  // namespace gausssim
