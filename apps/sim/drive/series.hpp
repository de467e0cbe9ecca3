#pragma once
// Steps by power series, which run inside a plugin (engine/taylor_glue.hpp).

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "sim/drive/integrator.hpp"

namespace gausssim {

template <class S>
class Series final : public Integrator<S> {
 public:
  using Array = Numbers<S>;

  struct Settings {
    S tolerance;
    bool projects;
    long most_steps;
    bool (*ends)();  ///< as gauss::simulate::Settings has it
    int order;       ///< 0: by the tolerance
    S longest_step;  ///< 0: any
  };

  Series(const SeriesEntries& entries, std::shared_ptr<const Functions<S>> functions, const Array& start, const S& t,
         const Settings& settings)
      : entries_(entries), functions_(std::move(functions)), state_(start), t_(t) {
    const std::array<S, 5> numbers{settings.tolerance, S(settings.projects ? 1 : 0), S(settings.most_steps),
                                   S(settings.order), settings.longest_step};
    bool (*ends)() = settings.ends;
    void* const arguments[] = {&run_,
                               const_cast<S*>(functions_->prepared.data()),
                               const_cast<S*>(functions_->inputs.data()),
                               state_.data(),
                               const_cast<S*>(&t),
                               const_cast<S*>(numbers.data()),
                               &ends};
    entries_.begin(arguments);
  }
  Series(const Series&) = delete;
  Series& operator=(const Series&) = delete;
  ~Series() override {
    void* const arguments[] = {run_};
    entries_.end(arguments);
  }

  void expect(const Samples<S>& samples) override {
    samples_ = samples;
    if (!samples_.together) return;
    states_.resize(k_together * state_.size());
    results_.resize(k_together * samples_.results);
  }

  bool advance_to(const S& end) override {
    const bool arrives = samples_.together ? advance_to_several(end) : advance_to_one(end);
    t_ = arrives ? times_[static_cast<std::size_t>(found_ - 1)] : tell().t;
    return arrives;
  }

  S time() const override { return t_; }
  const Array& state() const override {
    if (values_ != nullptr) {
      const std::size_t before = static_cast<std::size_t>(found_ - 1) * state_.size();
      std::copy_n(values_ + before, state_.size(), state_.begin());
    }
    return state_;
  }
  /// Not copied: numbers that were written one by one are not yet where wide loads find them.
  Found<S> found() const override {
    if (found_ == 1) return {1, values_ != nullptr ? values_ : state_.data()};
    return {found_, values_, state_.size(), times_.data(), results_.data(), samples_.results};
  }
  Progress<S> progress() const override {
    const Report report = tell();
    Progress<S> progress;
    progress.outcome = static_cast<gauss::simulate::Outcome>(report.told.outcome);
    progress.status = static_cast<gauss::Status>(report.told.status);
    progress.steps = report.told.steps;
    progress.rejected = report.told.rejected;
    progress.calls = report.told.calls;
    progress.with_fewer_constraints = report.told.fewer;
    progress.start_moved = report.moved;
    progress.start_component = static_cast<std::size_t>(report.told.moved_component);
    return progress;
  }

 private:
  struct Told {
    long outcome, status, steps, rejected, calls, fewer, order, moved_component;
  };
  struct Report {
    Told told{};
    S t = 0, moved = 0;
  };

  static constexpr std::size_t k_together = 4;  ///< as engine/samples_glue.hpp has it

  bool advance_to_one(const S& end) {
    times_[0] = end;
    void* const arguments[] = {run_, const_cast<S*>(&end), &values_};
    return entries_.advance(arguments) == 1;
  }

  /// And to as many of the expected times after it as its step has.
  bool advance_to_several(const S& end) {
    const long k = samples_.next, most = std::min<long>(k_together, samples_.grid.samples - k);
    times_[0] = end;
    for (long i = 1; i < most; ++i) times_[static_cast<std::size_t>(i)] = samples_.grid.at(k + i);
    found_ = most;
    void* const arguments[] = {run_, times_.data(), &found_, &values_, states_.data(), results_.data()};
    const bool arrives = samples_.together(arguments) == 1;
    samples_.next += found_;
    return arrives;
  }

  Report tell() const {
    Report report;
    void* const arguments[] = {run_, &report.told, &report.t, &report.moved};
    entries_.tell(arguments);
    return report;
  }

  SeriesEntries entries_;
  std::shared_ptr<const Functions<S>> functions_;
  mutable Array state_;
  const S* values_ = nullptr;  ///< inside the run; null before it has advanced
  S t_;
  void* run_ = nullptr;

  Samples<S> samples_;
  std::array<S, k_together> times_{};  ///< of what was found last
  long found_ = 1;
  std::vector<S> states_, results_;
};

}  // namespace gausssim
