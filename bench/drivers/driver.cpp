// gauss-sim's driver beside a loop by hand, in one process; see bench/driver.py.
//
//   bench_driver MODEL LIBRARY METHOD SETTING END ROUNDS     seconds of both in turns, as JSON
//   bench_driver MODEL LIBRARY METHOD SETTING END ours|hand|usual    once, for callgrind

#include <dlfcn.h>
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "driver_counts.hpp"
#include "sim/methods/methods.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/simulate.hpp"

namespace {

using namespace gausssim;

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Result {
  Counts counts;
  std::vector<double> last;
};

class Ours {
 public:
  Ours(const std::string& file, const std::string& method, double setting, double end) {
    int code = 0;
    Request request;
    request.file = file;
    const auto change = [](Scene& scene) {
      scene.outputs = {{"state", {}}};
      scene.samples = 2;
    };
    const auto prepared = prepare(request, change, code);
    if (!prepared) throw std::runtime_error("the model cannot be read");
    prepared_ = *prepared;
    prepared_.span.duration = end;
    EngineTimes times;
    std::string why;
    engine_ = build_engine(prepared_, EngineChoice::compiled, {"double"}, times, why);
    if (!engine_) throw std::runtime_error(why);
    setting_.method = method;
    (find_method(method)->takes_step ? setting_.step : setting_.tolerance) = setting;
    functions_ = bind<double>(*engine_, prepared_.model);
    initial_state(*engine_, prepared_.model, *functions_, start_);
    model_ = std::make_unique<MotionModel<double>>(functions_);
  }

  const Numbers<double>& start() const { return start_; }
  std::size_t size() const { return start_.size(); }

  /// What a run does between two samples.
  Result run() const {
    MethodSettings<double> settings;
    if (setting_.tolerance > 0) settings.tolerance = setting_.tolerance;
    if (setting_.step > 0) settings.step = setting_.step;
    std::string why;
    const auto integrator = make_integrator<double>(setting_.method, *model_, start_, 0, settings, why);
    if (!integrator || !integrator->advance_to(prepared_.span.duration)) throw std::runtime_error("no motion " + why);
    const auto progress = integrator->progress();
    const auto state = integrator->state();
    return {{progress.steps, progress.rejected, progress.calls}, {state.begin(), state.end()}};
  }

 private:
  PreparedModel prepared_;
  std::unique_ptr<Engine> engine_;
  Setting setting_;
  std::shared_ptr<Functions<double>> functions_;
  Numbers<double> start_;
  std::unique_ptr<MotionModel<double>> model_;
};

using Loop = Counts (*)(double setting, double end, double* state);

struct Problem {
  Ours ours;
  double setting, end;

  Result by_hand(Loop loop) const {
    std::vector<double> state(ours.start().begin(), ours.start().end());
    Counts counts = loop(setting, end, state.data());
    return {counts, state};
  }
};

// What callgrind counts between, by these names.
__attribute__((noinline)) Result counted_ours(const Problem& problem) { return problem.ours.run(); }
__attribute__((noinline)) Result counted_hand(const Problem& problem, Loop loop) { return problem.by_hand(loop); }

std::string text_of(const Result& result) {
  return fmt::format("{{\"steps\": {}, \"rejected\": {}, \"calls\": {}, \"last\": [{}]}}", result.counts.steps,
                     result.counts.rejected, result.counts.calls, fmt::join(result.last, ", "));
}

void take_turns(const Problem& problem, Loop hand, Loop usual, int rounds) {
  std::vector<double> ours, by_hand, as_usual;
  const auto timed = [](std::vector<double>& times, const auto& run) {
    constexpr double k_least = 2e-3;
    const double begin = now();
    int count = 0;
    do {
      run();
      ++count;
    } while (now() - begin < k_least);
    times.push_back((now() - begin) / count);
  };
  for (int round = 0; round < rounds; ++round) {
    timed(ours, [&] { problem.ours.run(); });
    timed(by_hand, [&] { problem.by_hand(hand); });
    if (usual != nullptr) timed(as_usual, [&] { problem.by_hand(usual); });
  }
  const auto printed = [](const char* name, const Result& result, const std::vector<double>& times) {
    return fmt::format("\"{}\": {{\"result\": {}, \"seconds\": [{}]}}", name, text_of(result), fmt::join(times, ", "));
  };
  fmt::print("{{{}, {}", printed("ours", problem.ours.run(), ours), printed("hand", problem.by_hand(hand), by_hand));
  if (usual != nullptr) fmt::print(", {}", printed("usual", problem.by_hand(usual), as_usual));
  fmt::print("}}\n");
}

int run(const std::vector<std::string>& words) {
  void* const library = dlopen(words.at(1).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  const std::string& method = words.at(2);
  const auto loop = [&](const char* kind) {
    return reinterpret_cast<Loop>(dlsym(library, (std::string(kind) + "_" + method).c_str()));
  };
  const double setting = std::stod(words.at(3)), end = std::stod(words.at(4));
  const Problem problem{Ours(words.at(0), method, setting, end), setting, end};
  const std::string& what = words.at(5);
  if (what == "ours") return static_cast<int>(counted_ours(problem).counts.steps == 0);
  if (what == "hand") return static_cast<int>(counted_hand(problem, loop("same")).counts.steps == 0);
  if (what == "usual") return static_cast<int>(counted_hand(problem, loop("usual")).counts.steps == 0);
  take_turns(problem, loop("same"), loop("usual"), std::stoi(what));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_driver: {}\n", error.what());
    return 1;
  }
}
