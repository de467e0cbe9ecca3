// What a sample costs, the interpolation of the state included; see bench/accuracy_time.py.
//
//   bench_sampling MODEL OUTPUTS METHOD SETTING END SAMPLES,SAMPLES... ROUNDS    seconds for each number of samples, as JSON
//   bench_sampling MODEL OUTPUTS METHOD SETTING END SAMPLES once                 one run, for callgrind

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/run/build_engine.hpp"
#include "sim/run/simulate.hpp"

namespace {

using namespace gausssim;

std::vector<Word> words_of(const std::string& list) {
  std::vector<Word> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) words.push_back({word, {}});
  return words;
}

class Run {
 public:
  /// Compiled for `samples`, as a run with so many would be.
  Run(const std::string& file, const std::string& outputs, const std::string& method, double setting, double end,
      long samples) {
    int code = 0;
    Request request;
    request.file = file;
    const auto prepared = prepare(
        request, [&](Scene& scene) { scene.outputs = words_of(outputs); }, code);
    if (!prepared) throw std::runtime_error("the model cannot be read");
    prepared_ = *prepared;
    prepared_.span.duration = end;
    prepared_.span.samples = samples;
    EngineTimes times;
    std::string why;
    engine_ = build_engine(prepared_, EngineChoice::compiled, {"double"}, times, why);
    if (!engine_) throw std::runtime_error(why);
    setting_.method = method;
    (find_method(method)->takes_step ? setting_.step : setting_.tolerance) = setting;
  }

  std::size_t columns() const { return prepared_.columns.columns.size(); }

  __attribute__((noinline)) Simulated counted(long samples) {
    prepared_.span.samples = samples;
    Listeners none;
    none.measures_drift = false;
    const Simulated result = simulate(prepared_, *engine_, setting_, none);
    if (result.samples != samples) throw std::runtime_error("the run ends early");
    return result;
  }

 private:
  PreparedModel prepared_;
  std::unique_ptr<Engine> engine_;
  Setting setting_;
};

std::vector<long> numbers_of(const std::string& list) {
  std::vector<long> numbers;
  for (const Word& word : words_of(list)) numbers.push_back(std::stol(word.text));
  return numbers;
}

int run(const std::vector<std::string>& words) {
  const std::vector<long> samples = numbers_of(words.at(5));
  Run one(words.at(0), words.at(1), words.at(2), std::stod(words.at(3)), std::stod(words.at(4)),
          *std::max_element(samples.begin(), samples.end()));
  if (words.at(6) == "once") return static_cast<int>(one.counted(samples.front()).samples < 0);
  std::vector<double> least(samples.size(), 1e9);
  Simulated last;
  for (int round = 0; round < std::stoi(words.at(6)); ++round) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      last = one.counted(samples[i]);
      least[i] = std::min(least[i], last.cpu_seconds);
    }
  }
  fmt::print("{{\"columns\": {}, \"steps\": {}, \"calls\": {}, \"samples\": [{}], \"seconds\": [{}]}}\n", one.columns(),
             last.steps, last.calls, fmt::join(samples, ", "), fmt::join(least, ", "));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_sampling: {}\n", error.what());
    return 1;
  }
}
