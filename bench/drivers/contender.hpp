#pragma once
// What is measured: an evaluation at states that differ, so that nothing can be computed in advance. Each contender keeps the
// states in its own coordinates and calls itself in a loop of its own, so that none pays for being called through a pointer.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {

inline constexpr std::size_t k_states = 64;  // a power of two

/// A state in the coordinates of the case, which are those of our model: see cases.hpp.
struct Sample {
  std::vector<double> q, v;
};
using Samples = std::array<Sample, k_states>;

/// In place of an acceleration that a contender does not compute.
inline constexpr double k_not_given = 1e300;

/// + and -, *, /, square roots, sines and cosines; a change of sign is free.
struct Operations {
  long additions = 0, multiplications = 0, divisions = 0, functions = 0;
  long all() const { return additions + multiplications + divisions + functions; }
};

class Contender {
 public:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
  virtual ~Contender() = default;

  virtual void take(const Samples& samples) = 0;
  virtual void run(long calls) = 0;
  /// In the coordinates of the case, at one of the states; false: it does not give them.
  virtual bool accelerations(std::size_t state, double* a) = 0;
  virtual bool count(Operations&) const { return false; }
};

struct Entry {
  std::string tool;      ///< gauss, by hand, mujoco, …
  std::string metric;    ///< rhs, rhs_and_reactions, joint_reactions, jacobian, batch
  int lanes = 1;         ///< states in one call
  bool is_exact = true;  ///< its accelerations have to be those of the others
  std::function<std::unique_ptr<Contender>(const std::string& kind, int size)> make;  ///< null: not of this case
};

inline std::vector<Entry>& registry() {
  static std::vector<Entry> entries;
  return entries;
}

struct Registration {
  explicit Registration(Entry entry) { registry().push_back(std::move(entry)); }
};

/// The compiler has to have it in memory.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "m"(value) : "memory");
}

/// A system has State, Result, own(sample), operator()(state, result) and common(state, result, a).
template <class System>
class Loop : public Contender {
 public:
  explicit Loop(System system = {}) : system_(std::move(system)) {}

  void take(const Samples& samples) override {
    states_.clear();
    for (const Sample& sample : samples) states_.push_back(system_.own(sample));
  }
  void run(long calls) override {
    typename System::Result result;
    for (long i = 0; i < calls; ++i) {
      system_(states_[static_cast<std::size_t>(i) % k_states], result);
      keep(result);
    }
  }
  bool accelerations(std::size_t state, double* a) override {
    typename System::Result result;
    system_(states_[state], result);
    return system_.common(states_[state], result, a);
  }
  bool count(Operations& operations) const override { return system_.count(operations); }

 private:
  System system_;
  std::vector<typename System::State> states_;
};

template <class System>
std::unique_ptr<Contender> loop(System system = {}) {
  return std::make_unique<Loop<System>>(std::move(system));
}

}  // namespace bench
