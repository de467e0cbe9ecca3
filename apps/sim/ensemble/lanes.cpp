#include "sim/ensemble/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/engine/plugin_text.hpp"
#include "sim/model/layout.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

/// What lanes do may differ from one trajectory alone by rounding, so products and sums need not be rounded one by one. Loops over columns of a product have to be
/// straight code, or sums go through memory; loops over orders, which are around several of them, are no faster when they are unrolled.
Toolchain for_lanes(Toolchain toolchain) {
  auto& flags = toolchain.flags;
  for (std::string& flag : flags) {
    if (flag == "-ffp-contract=off") flag = "-ffp-contract=fast";
    if (flag == "-O2") flag = "-O3";
  }
  const auto is_dropped = [](const std::string& flag) {
    return flag == "-fno-tree-slp-vectorize" || flag == "-funroll-loops";
  };
  flags.erase(std::remove_if(flags.begin(), flags.end(), is_dropped), flags.end());
  return toolchain;
}

}  // namespace

namespace {

void build(const Described& model, const Toolchain& toolchain, BuiltLanes& result) {
  const Built built = build_plugin(lanes_text(model), toolchain, ends_now);
  if (built.was_ended) throw_if_ended();
  result.compile_seconds = built.compile_seconds;
  result.was_cached = built.was_cached;
  if (!built.plugin) {
    const bool has_xsimd = built.why.find("xsimd/xsimd.hpp") == std::string::npos;
    result.why = has_xsimd ? built.why : "the compiler finds no xsimd (Debian: libxsimd-dev)";
    return;
  }
  int lanes = 0;
  void* const arguments[] = {&lanes};
  built.plugin->find("count_lanes", "double")(arguments);
  result.kernel = std::make_unique<LanesKernel>(built.plugin, lanes);
}

}  // namespace

std::string lanes_text(const Described& model) {
  const std::string& name_space = model.tree.name_space;
  std::string text = plugin_header(model.tree);
  text += std::string(lanes_runtime()) + "\nGAUSS_MODEL(GaussSimModel, ::" + name_space + ");\n";
  text += "using GaussSimBatch = xsimd::batch<double>;\n";
  text += fmt::format(
      "extern \"C\" GAUSS_SIM_VISIBLE int {}(const void*, void* const* a) {{\n"
      "  *static_cast<int*>(a[0]) = static_cast<int>(GaussSimBatch::size);\n  return 0;\n}}\n",
      entry_symbol("count_lanes", "double"));
  text += fmt::format(
      "extern \"C\" GAUSS_SIM_VISIBLE int {}(const void*, void* const* a) {{\n"
      "  return gauss_sim_glue::run_lanes<GaussSimModel, GaussSimBatch, "
      "::{}::TaylorSeries<GaussSimBatch>>(*static_cast<gauss_sim_glue::LanesJob*>(a[0]));\n}}\n",
      entry_symbol("run_lanes", "double"), name_space);
  return text;
}

LanesKernel::LanesKernel(std::shared_ptr<const Plugin> plugin, int lanes)
    : plugin_(std::move(plugin)), run_(plugin_->find("run_lanes", "double")), lanes_(lanes) {}

void LanesKernel::run(LanesJob& job) const {
  void* const arguments[] = {&job};
  run_(arguments);
}

BuiltLanes build_lanes(const Described& model) {
  BuiltLanes result;
  const auto toolchain = find_toolchain(result.why);
  if (find_function(model.tree, "taylor") == nullptr) {
    result.why = "the model has no power series";
  } else if (toolchain) {
    build(model, for_lanes(*toolchain), result);
  }
  return result;
}

}  // namespace gausssim
