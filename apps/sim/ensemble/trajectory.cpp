#include "sim/ensemble/trajectory.hpp"

#include <algorithm>

#include "cli/usage_error.hpp"
#include "gauss/integrate/step_result.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

using gauss::simulate::Outcome;

std::string status_text(const Ended& ended) {
  switch (ended.how) {
    case Ended::How::not_run: return "not run";
    case Ended::How::finished: return "finished";
    case Ended::How::without_start: return "no initial state";
    default: return gauss::simulate::name(ended.outcome);
  }
}

template <class S>
Trajectories<S>::Trajectories(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                              const Starts<S>& starts, bool records_samples)
    : setting_(setting),
      starts_(starts),
      bound_(engine, prepared.model),
      model_(bound_.functions),
      samples_(grid_of<S>(prepared.span)),
      grid_{samples_.start, samples_.end, records_samples ? samples_.samples : 1, samples_.every},
      records_samples_(records_samples),
      sampler_(engine, prepared.model, prepared.columns, *bound_.functions),
      settings_(method_settings<S>(setting)) {}

template <class S>
void Trajectories<S>::add_row(const S& t, const S* state, Track<S>& track, const S* found) {
  const std::size_t begin = track.rows.size();
  track.rows.resize(begin + sampler_.size());
  track.times.push_back(t);
  if (sampler_(t, state, track.rows.data() + begin, found) != gauss::Status::ok) ++track.ended.untrusted;
}

template <class S>
void Trajectories<S>::run(long trajectory, Track<S>& track) {
  track.clear();
  Ended& ended = track.ended;
  ended.reached = static_cast<double>(grid_.start);
  Numbers<S> start;
  ended.status = begin(trajectory, start);
  if (!gauss::integrate::is_motion_known(ended.status)) {
    ended.how = Ended::How::without_start;
    return;
  }
  integrate(start, grid_, records_samples_, track);
  // Series know the time that was asked for last: with samples there are some before it stops.
  const bool is_at_start = ended.how == Ended::How::stopped && ended.reached == static_cast<double>(grid_.start);
  if (is_at_start && !records_samples_) integrate(start, samples_, false, track);
}

template <class S>
void Trajectories<S>::integrate(const Numbers<S>& start, const Grid<S>& grid, bool keeps_all, Track<S>& track) {
  track.clear();
  Ended& ended = track.ended;
  std::string why;
  const auto integrator = make_integrator(setting_.method, model_, start, grid.start, settings_, why);
  if (!integrator) throw gaussgen::cli::UsageError(why);
  const Samples<S> expected = keeps_all ? sampler_.expected(grid, 0) : Samples<S>{grid, 0, 0, {}};
  drive<S>(*integrator, expected, [&](const Sample<S>& sample) {
    if (keeps_all) add_row(sample.t, sample.state, track, sample.results);
    return true;
  });
  const Progress<S> progress = integrator->progress();
  if (progress.outcome == Outcome::interrupted) return track.clear();
  ended.how = progress.outcome == Outcome::running ? Ended::How::finished : Ended::How::stopped;
  ended.outcome = progress.outcome;
  ended.status = progress.status;
  ended.reached = static_cast<double>(integrator->time());
  ended.steps = progress.steps;
  ended.rejected = progress.rejected;
  if (!keeps_all) add_row(integrator->time(), integrator->found().states, track);
}

template class Trajectories<float>;
template class Trajectories<double>;
template class Trajectories<long double>;
template class Trajectories<Quad>;

}  // namespace gausssim
