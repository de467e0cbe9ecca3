// The fuzzers without libFuzzer and sanitizers, as they are built with everything else: some thousand changed seeds, the same in every run.
//
//   mutated_model INPUTS FINDING FOLDER...    ends with 1, and the input in the file FINDING, where one breaks what holds for all inputs

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "mutation.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// Of libFuzzer, which is not here and does not call what calls it.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }

namespace {

constexpr int k_seconds = 20;  ///< of a processor, that an input may take: these are the limits of run_fuzzers.py
constexpr std::size_t k_longest = 8192;

const char* finding_path = nullptr;
std::string input;  ///< that is being looked at

/// Async-signal-safe: it may come in the middle of anything.
void end_with_finding(int) {
  const int file = ::open(finding_path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const char said[] = "mutated: an input breaks it, or takes too long; see the file of findings\n";
  const bool is_written =
      file >= 0 && ::write(file, input.data(), input.size()) >= 0 && ::write(2, said, sizeof said - 1) >= 0;
  ::_exit(is_written ? 1 : 2);
}

#if defined(GAUSS_FUZZ_VALUES)
/// What stands behind colons and commas.
void add_values(const std::string& text, std::vector<std::string>& seeds) {
  std::size_t end = 0;
  for (std::size_t at = text.find_first_of(":,"); at != std::string::npos; at = text.find_first_of(":,", end)) {
    const std::size_t begin = std::min(text.find_first_not_of(": ,[{\n", at), text.size());
    end = std::min(text.find_first_of(",]}\n", begin), text.size());
    if (end - begin >= 2) seeds.push_back(text.substr(begin, end - begin));
  }
}
#endif

std::vector<std::string> seeds_in(const std::vector<std::string>& folders) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".yaml" && entry.file_size() <= k_longest) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> seeds;
  for (const auto& path : paths) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
#if defined(GAUSS_FUZZ_VALUES)
    add_values(text.str(), seeds);
#else
    seeds.push_back(text.str());
#endif
  }
  return seeds;
}

class Inputs {
 public:
  explicit Inputs(std::vector<std::string> seeds) : seeds_(std::move(seeds)) {}

  std::string next() {
    std::string text = seed();
    const int changes = 1 + static_cast<int>(random_() % 3);
    for (int k = 0; k < changes && !text.empty(); ++k)
      text = random_() % 4 == 0 ? with_other_bytes(text) : changed(text);
    return text.substr(0, k_longest);
  }

 private:
  const std::string& seed() { return seeds_[random_() % seeds_.size()]; }

  std::string changed(const std::string& text) {
    fuzz::Mutation mutation(text, static_cast<unsigned>(random_()));
    random_() % 2 == 0 ? mutation.within_itself() : mutation.with(seed());
    std::string result(k_longest, '\0');
    result.resize(mutation.copied_to(reinterpret_cast<std::uint8_t*>(result.data()), result.size()));
    return result;
  }

  std::string with_other_bytes(std::string text) {
    const std::size_t at = random_() % text.size();
    switch (random_() % 3) {
      case 0: text[at] = static_cast<char>(random_()); break;
      case 1: text.insert(at, 1, static_cast<char>(random_())); break;
      default: text.erase(at, 1 + random_() % 8);
    }
    return text;
  }

  std::vector<std::string> seeds_;
  std::mt19937 random_;  // its first state is always the same
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::cerr << "mutated_model INPUTS FINDING FOLDER...\n", 2;
  finding_path = argv[2];
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGVTALRM}) std::signal(signal, end_with_finding);
  Inputs inputs(seeds_in({argv + 3, argv + argc}));
  const long count = std::atol(argv[1]);
  for (long k = 0; k < count; ++k) {
    input = inputs.next();
    const itimerval limit{{0, 0}, {k_seconds, 0}};
    ::setitimer(ITIMER_VIRTUAL, &limit, nullptr);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  }
  std::cout << count << " inputs\n";
}
