#include "sim/ensemble/outcomes.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <numeric>
#include <optional>

#include "sim/drive/quad.hpp"
#include "sim/ensemble/lane_groups.hpp"
#include "sim/ensemble/ordered_blocks.hpp"
#include "sim/ensemble/table.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

/// Trajectories that a thread takes at a time, in each lane one after another, and fewer where there are few for each thread. No result depends on it.
long block_size(long count, long lanes, int threads) {
  constexpr long k_most = 64, k_blocks_of_thread = 8;
  const long wanted = std::clamp(count / (k_blocks_of_thread * threads), 1L, k_most);
  return (wanted + lanes - 1) / lanes * lanes;
}

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Shape {
  long group = 1;  ///< trajectories that are integrated together
  long block = 1;  ///< that a thread takes
  bool makes_rows = false;
};

/// One thread's part.
template <class S>
class Worker {
 public:
  Worker(const PreparedModel& prepared, const Engine& engine, const EnsembleSetting& setting, const Source& source,
         const Shape& shape, Outcomes& outcomes)
      : engine_(engine.another()),
        source_(source),
        shape_(shape),
        outcomes_(outcomes),
        starts_(make_starts<S>(source, prepared.model)),
        alone_(prepared, *engine_, setting.setting, *starts_, setting.records_samples) {
    if constexpr (std::is_same_v<S, double>) {
      if (setting.lanes != nullptr) groups_.emplace(prepared, *setting.lanes, setting.setting, alone_);
    }
  }

  /// Up to the first trajectory that an interruption has not let end.
  std::string block(long block) {
    std::string text;
    const long last = std::min((block + 1) * shape_.block, source_.size());
    for (long first = block * shape_.block; first < last && !Interruption::is_asked_for(); first += shape_.group) {
      const long end = std::min(first + shape_.group, last);
      run(first, end);
      for (long i = first; i < end; ++i) {
        const Track<S>& track = tracks_[static_cast<std::size_t>(i - first)];
        if (track.ended.how == Ended::How::not_run) return text;
        note(i, track, text);
      }
    }
    return text;
  }

 private:
  void run(long first, long last) {
    if constexpr (std::is_same_v<S, double>) {
      if (groups_) return groups_->run(first, last, tracks_);
    }
    tracks_.resize(1);
    alone_.run(first, tracks_.front());
  }

  /// Each trajectory has a place of its own, so threads do not meet.
  void note(long trajectory, const Track<S>& track, std::string& text) {
    const auto i = static_cast<std::size_t>(trajectory);
    outcomes_.ended[i] = track.ended;
    const bool has_row = !track.times.empty();
    for (std::size_t k = 0; has_row && k < outcomes_.width; ++k)
      outcomes_.finals[i * outcomes_.width + k] =
          static_cast<double>(track.rows[track.rows.size() - outcomes_.width + k]);
    if (shape_.makes_rows) append_rows(text, trajectory, source_.plan->values(trajectory), track, outcomes_.width);
  }

  std::unique_ptr<const Engine> engine_;
  const Source& source_;
  Shape shape_;
  Outcomes& outcomes_;
  std::unique_ptr<const Starts<S>> starts_;
  Trajectories<S> alone_;
  std::optional<LaneGroups> groups_;
  std::vector<Track<S>> tracks_;
};

template <class S>
BlockWork work_of(const PreparedModel& prepared, const Engine& engine, const EnsembleSetting& setting,
                  const Source& source, const Shape& shape, Outcomes& outcomes) {
  const auto worker = std::make_shared<Worker<S>>(prepared, engine, setting, source, shape, outcomes);
  return [worker](long block) { return worker->block(block); };
}

/// Threads are at several places when an interruption ends them: what is behind the first gap is left out.
class Whole {
 public:
  Whole(Outcomes& outcomes, long block) : outcomes_(outcomes), block_(block) {}

  /// Of the next block: whether there is no gap before it.
  bool reaches_next() {
    const bool is_whole = last_ == next_;
    next_ = std::min(next_ + block_, static_cast<long>(outcomes_.ended.size()));
    while (is_whole && last_ < next_ && has_ended(last_)) ++last_;
    return is_whole;
  }

  void cut() {
    for (auto i = static_cast<std::size_t>(last_); i < outcomes_.ended.size(); ++i) {
      if (!has_ended(static_cast<long>(i))) continue;
      outcomes_.ended[i] = {};
      std::fill_n(outcomes_.finals.begin() + static_cast<std::ptrdiff_t>(i * outcomes_.width), outcomes_.width,
                  std::numeric_limits<double>::quiet_NaN());
    }
  }

 private:
  bool has_ended(long i) const { return outcomes_.ended[static_cast<std::size_t>(i)].how != Ended::How::not_run; }

  Outcomes& outcomes_;
  long block_;
  long last_ = 0;  ///< those before it have ended
  long next_ = 0;
};

long sum(const std::vector<Ended>& all, long Ended::*what) {
  return std::accumulate(all.begin(), all.end(), 0L, [&](long so_far, const Ended& one) { return so_far + one.*what; });
}

}  // namespace

long Outcomes::run() const {
  return std::count_if(ended.begin(), ended.end(), [](const Ended& one) { return one.how != Ended::How::not_run; });
}

long Outcomes::left_lane() const {
  return std::count_if(ended.begin(), ended.end(), [](const Ended& one) { return one.left_lane; });
}

long Outcomes::steps() const { return sum(ended, &Ended::steps); }
long Outcomes::untrusted() const { return sum(ended, &Ended::untrusted); }

Outcomes run_all(const PreparedModel& prepared, const Engine& engine, const EnsembleSetting& setting,
                 const Source& source, const EnsembleListeners& listeners) {
  Outcomes outcomes;
  outcomes.width = prepared.columns.columns.size();
  outcomes.ended.resize(static_cast<std::size_t>(source.size()));
  outcomes.finals.assign(outcomes.ended.size() * outcomes.width, std::numeric_limits<double>::quiet_NaN());
  Shape shape;
  shape.block = block_size(source.size(), setting.lanes == nullptr ? 1 : setting.lanes->lanes(), setting.threads);
  if (setting.lanes != nullptr) shape.group = shape.block;
  shape.makes_rows = static_cast<bool>(listeners.on_rows);
  Blocks blocks;
  blocks.count = (source.size() + shape.block - 1) / shape.block;
  blocks.threads = static_cast<int>(std::min<long>(setting.threads, blocks.count));
  blocks.make_work = [&] {
    const auto make = setting.setting.number == "long-double" ? work_of<long double>
                      : setting.setting.number == "float128"  ? work_of<Quad>
                      : setting.setting.number == "float"     ? work_of<float>
                                                              : work_of<double>;
    return make(prepared, engine, setting, source, shape, outcomes);
  };
  Whole whole(outcomes, shape.block);
  blocks.on_text = [&](const std::string& text) {
    if (whole.reaches_next() && shape.makes_rows) listeners.on_rows(text);
  };
  blocks.ends = Interruption::is_asked_for;
  blocks.on_wait = [&](double share) {
    if (listeners.on_wait) listeners.on_wait(share);
  };
  const auto begin = std::chrono::steady_clock::now();
  const double cpu = processor_seconds();
  run_in_order(blocks);
  whole.cut();
  outcomes.cpu_seconds = processor_seconds() - cpu;
  outcomes.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcomes;
}

}  // namespace gausssim
