#include "sim/regimes/regime_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace gausssim {

namespace model = gaussgen::model;

/// GiNaC is not thread-safe, and neither are compilers in one folder: one regime at a time is derived.
struct RegimeSource::Known {
  std::mutex mutex;
  std::map<Modes, std::shared_ptr<const RegimeModel>> models;
  std::map<Modes, std::string> refusals;
};

RegimeSource::RegimeSource(gaussgen::support::Source text, gaussgen::PipelineOptions options,
                           std::function<void(model::Model&)> adjust, Switches switches)
    : known_(std::make_unique<Known>()),
      text_(std::move(text)),
      options_(std::move(options)),
      adjust_(std::move(adjust)),
      switches_(std::move(switches)) {
  // The start is that of the ground regime: others may be far from it.
  auto& outputs = options_.outputs;
  outputs.erase(std::remove(outputs.begin(), outputs.end(), "initial_state"), outputs.end());
}

RegimeSource::~RegimeSource() = default;

void RegimeSource::prepare(std::vector<Column> columns, MakeEngine make,
                           std::function<std::shared_ptr<void>()> while_making) {
  const std::scoped_lock lock(known_->mutex);
  columns_ = std::move(columns);
  make_engine_ = std::move(make);
  while_making_ = std::move(while_making);
}

std::size_t RegimeSource::count() const {
  const std::scoped_lock lock(known_->mutex);
  return known_->models.size();
}

namespace {

struct Derived {
  Described model;
  std::vector<GuardOf> guards;
  std::vector<char> fixed_reactions;
};

std::optional<Derived> derived(const gaussgen::support::Source& text, gaussgen::PipelineOptions options,
                               const std::function<void(model::Model&)>& adjust, std::string& why) {
  Derived result;
  options.adjust = [&](model::Model& read) {
    adjust(read);
    result.guards = guards_of(read);
    result.fixed_reactions = reactions_in_forces(read);
  };
  gaussgen::support::Source own = text;
  gaussgen::support::Diagnostics found;
  auto compiled = gaussgen::compile(own, options, found, nullptr);
  if (!compiled) {
    for (const auto& one : found.all()) {
      if (one.severity == gaussgen::support::Severity::error) why = one.message;
    }
    return std::nullopt;
  }
  result.model = {std::move(compiled->tree), std::move(compiled->unit)};
  return result;
}

std::string in_words(const Modes& modes) {
  std::string text;
  for (const auto& [name, mode] : modes) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, mode);
  return text;
}

/// What a regime has of the columns of a run.
void choose(const std::vector<Column>& wanted, RegimeModel& regime) {
  const std::vector<std::string> known = output_names(regime.model);
  std::vector<Word> words;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (std::find(known.begin(), known.end(), wanted[i].name) == known.end()) continue;
    words.push_back({wanted[i].name, {}});
    regime.in_row.push_back(i);
  }
  if (words.empty()) return;  // none would mean those that everybody wants
  gaussgen::support::Diagnostics ignored;
  regime.columns = choose_columns(regime.model, words, ignored);
}

}  // namespace

std::optional<Described> RegimeSource::described(const Modes& modes) {
  gaussgen::PipelineOptions options = options_;
  options.choices.regime = modes;
  std::string ignored;
  auto found = derived(text_, options, adjust_, ignored);
  if (!found) return std::nullopt;
  return std::move(found->model);
}

/// Which is stiff while it is slow.
bool RegimeSource::slides_in_two_directions(const Modes& modes) const {
  const auto& frictions = switches_.frictions;
  return std::any_of(frictions.begin(), frictions.end(), [&](const FrictionSwitch& friction) {
    return friction.slips > 1 && modes.at(friction.name) == friction.sliding(false);
  });
}

std::shared_ptr<const RegimeModel> RegimeSource::at(const Modes& modes, std::string& why) {
  const std::scoped_lock lock(known_->mutex);
  if (const auto found = known_->models.find(modes); found != known_->models.end()) return found->second;
  if (const auto found = known_->refusals.find(modes); found != known_->refusals.end()) {
    why = found->second;
    return nullptr;
  }
  const std::shared_ptr<void> meanwhile = while_making_();
  gaussgen::PipelineOptions options = options_;
  options.choices.regime = modes;
  options.where_possible.emplace_back("load_system");
  if (slides_in_two_directions(modes)) options.where_possible.emplace_back("jacobian");
  auto model = derived(text_, options, adjust_, why);
  if (!model) {
    why = fmt::format("there is no motion with {}: {}", in_words(modes), why);
    known_->refusals[modes] = why;
    return nullptr;
  }
  auto regime = std::make_shared<RegimeModel>();
  regime->model = std::move(model->model);
  regime->guards = std::move(model->guards);
  regime->fixed_reactions = std::move(model->fixed_reactions);
  choose(columns_, *regime);
  regime->engine = make_engine_(regime->model, regime->columns);
  known_->models[modes] = regime;
  return regime;
}

}  // namespace gausssim
