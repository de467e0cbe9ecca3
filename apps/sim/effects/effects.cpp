#include "sim/effects/effects.hpp"
#include "scene_choice.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <list>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/effects/ladder.hpp"
#include "sim/effects/ladder_json.hpp"
#include "sim/effects/ladder_text.hpp"
#include "sim/effects/lean_scene.hpp"
#include "sim/output/files.hpp"
#include "sim/page/page.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

constexpr const char* k_standard_input = "-";

/// Beside the scene or model, which it names, so that the model is found from there; what has no file, in the working folder.
std::string lean_path(const EffectsOptions& options, const Workbench& bench) {
  const std::filesystem::path file(options.file == k_standard_input ? bench.name() : options.file);
  return (file.parent_path() / (file.stem().string() + ".lean.yaml")).string();
}

/// Empty: the scene is written in a way in which the key cannot be put, or has others in it, or there is no file of the model that a scene could name.
std::string lean_scene(const EffectsOptions& options, const Workbench& bench, const Measured& chosen) {
  if (!options.instance.empty()) return "";
  const auto source = cli::read_source(options.file);
  const auto names = in_order(chosen.acting, bench.effects());
  if (gaussgen::is_scene(source)) return scene_with_effects(std::string(source.text()), names);
  if (options.file == k_standard_input) return "";
  const std::filesystem::path file(options.file);
  return scene_of_model(file.stem().string() + "_lean", file.filename().string(), names);
}

std::string why_no_lean_scene(const EffectsOptions& options) {
  if (options.file == k_standard_input)
    return "standard input is no file that a scene could name, or it is not written in lines, so no leaner scene is";
  return fmt::format("'{}' is not written in lines, so no leaner scene is", options.file);
}

/// A study without runs: its page shows what effects cost and change.
std::string page_of_effects(const EffectsOptions& options, const Workbench& bench,
                            const nlohmann::ordered_json& found) {
  const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  nlohmann::ordered_json problem{
      {"name", bench.name()}, {"about", bench.about()}, {"file", name_of(bench.model_file())}};
  if (bench.model_file() != options.file) problem["scene"] = name_of(options.file);
  problem["duration"] = bench.duration();
  problem["effects"] = found;
  auto study = head_of_study();
  study["problems"] = nlohmann::ordered_json::array({problem});
  return page_of(study);
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
  const std::string output = options.output.empty()
                                 ? bench.name() + ".effects"
                                 : without_ending(options.output, {".json", ".svg", ".html", ".yaml"});
  std::vector<const char*> endings{".json", ".svg"};
  if (options.writes_page) endings.push_back(".html");
  for (const char* const ending : endings) check_writable(output + ending);
  const auto ladder = make_ladder(bench);
  if (!ladder) throw Interrupted{};
  EffectsReport report{bench, *ladder, options.need, {}};
  if (options.need) report.chosen = cheapest_within(*ladder, *options.need);
  std::list<cli::Replacement> files;
  const auto json = json_of(report);
  files.emplace_back(output + ".json", json.dump(1) + "\n");
  files.emplace_back(output + ".svg", chart_of_effects(report));
  if (options.writes_page) files.emplace_back(output + ".html", page_of_effects(options, bench, json));
  const std::string lean = options.need ? lean_scene(options, bench, *report.chosen) : "";
  if (!lean.empty()) files.emplace_back(lean_path(options, bench), lean);
  const bool is_known = !options.need || (bench.noise() && bench.noise()->value < *options.need);
  if (is_known)
    for (cli::Replacement& file : files) file.commit();
  if (!options.quiet) cli::write_standard_output(in_words(report));
  if (!is_known) return cli::fail(why_it_cannot_tell(bench, *options.need), cli::k_not_delivered, options.messages);
  if (!options.quiet)
    cli::write_standard_output(fmt::format(
        options.writes_page ? "wrote {0}.json, {0}.svg and {0}.html{1}\n" : "wrote {0}.json and {0}.svg{1}\n", output,
        lean.empty() ? "" : ", and the scene " + lean_path(options, bench)));
  if (options.need && !options.instance.empty())
    cli::remark(fmt::format("no leaner scene is written of one instance; what it needs: effects: [{}]",
                            fmt::join(in_order(report.chosen->acting, bench.effects()), ", ")),
                options.messages);
  else if (options.need && lean.empty())
    cli::warn(why_no_lean_scene(options), options.messages);
  if (!lean.empty() && changes_by_options(options))
    cli::warn("values that options give are not in the leaner scene", options.messages);
  return cli::k_ok;
}

}  // namespace gausssim
