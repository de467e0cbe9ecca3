#include "sim/ensemble/measure_lanes.hpp"

#include <algorithm>
#include <thread>

#include "cli/usage_error.hpp"
#include "sim/ensemble/outcomes.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

/// Of the size of each component of the start: trajectories take other steps, and stay alike.
constexpr double k_part = 1e-3;

class LanesMeter {
 public:
  LanesMeter(const PreparedModel& prepared, const Engine& engine, const LanesEffort& effort)
      : prepared_(prepared), engine_(engine), effort_(effort) {
    setting_.setting = default_setting(prepared, engine);
    setting_.setting.method = default_method(prepared, engine, setting_.setting.number);
    setting_.setting.tolerance = effort.tolerance;
  }

  /// How many trajectories fill the time.
  long count() {
    constexpr long k_first = 16, k_most = 65'536;
    const double seconds = run(k_first).wall_seconds;
    const double wanted = effort_.seconds / std::max(seconds / k_first, 1e-9);
    return std::clamp(static_cast<long>(wanted) / k_first * k_first, k_first, k_most);
  }

  LanesRow row(const LanesKernel* kernel, int threads, long trajectories) {
    setting_.lanes = kernel;
    setting_.threads = threads;
    LanesRow row;
    row.lanes = kernel == nullptr ? 1 : kernel->lanes();
    row.threads = threads;
    row.trajectories = trajectories;
    for (int k = 0; k < effort_.repeats && !Interruption::is_asked_for(); ++k) {
      const double seconds = run(trajectories).wall_seconds;
      row.trajectories_per_s = std::max(row.trajectories_per_s, static_cast<double>(trajectories) / seconds);
    }
    return row;
  }

 private:
  Outcomes run(long trajectories) {
    Source source;
    source.count = trajectories;
    source.part = k_part;
    return run_all(prepared_, engine_, setting_, source, {});
  }

  const PreparedModel& prepared_;
  const Engine& engine_;
  const LanesEffort& effort_;
  EnsembleSetting setting_;
};

}  // namespace

std::vector<LanesRow> measure_lanes(const PreparedModel& prepared, const LanesEffort& effort, std::string& why) {
  EngineTimes times;
  const auto engine = build_engine(prepared, EngineChoice::compiled, {"double"}, times, why);
  if (!engine) return {};
  const BuiltLanes built = build_lanes(prepared.model);
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = effort.threads > 0 ? effort.threads : processors;
  std::vector<LanesRow> rows;
  try {
    LanesMeter meter(prepared, *engine, effort);
    const long count = meter.count();
    rows.push_back(meter.row(nullptr, 1, count));
    if (built.kernel) rows.push_back(meter.row(built.kernel.get(), 1, count));
    if (threads > 1) rows.push_back(meter.row(nullptr, threads, count));
    if (threads > 1 && built.kernel) rows.push_back(meter.row(built.kernel.get(), threads, count));
  } catch (const gaussgen::cli::UsageError& error) {
    why = error.what();
    return {};
  }
  for (LanesRow& row : rows) row.ratio = row.trajectories_per_s / rows.front().trajectories_per_s;
  return rows;
}

}  // namespace gausssim
