#include "sim/run/given_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/usage_error.hpp"
#include "model/impossible.hpp"
#include "model/quaternion_length.hpp"
#include "sim/run/scene_values.hpp"

namespace gausssim {

namespace cli = gaussgen::cli;
namespace model = gaussgen::model;
using gaussgen::support::Diagnostic;
using gaussgen::support::Diagnostics;

namespace {

std::vector<Diagnostic> impossible(const model::Model& read) {
  std::vector<Diagnostic> found;
  for (auto& one : model::impossible_bodies(read)) {
    if (one.severity == gaussgen::support::Severity::error) found.push_back(std::move(one));
  }
  return found;
}

}  // namespace

bool GivenBodies::is_own(const Given& given) const {
  return given.span.begin >= own_.begin && given.span.end <= own_.end && own_.end > 0;
}

void GivenBodies::look_at(const model::Model& as_in_file) {
  if (own_.end == 0) return;
  Scene for_all = scene_;
  auto& values = for_all.parameters;
  values.erase(std::remove_if(values.begin(), values.end(), [&](const Given& one) { return is_own(one); }),
               values.end());
  model::Model read = as_in_file;
  Diagnostics ignored;
  give_values(for_all, read, ignored);
  own_is_to_blame_ = ignored.has_errors() || impossible(read).empty();
}

void GivenBodies::note_scene(const model::Model& with_values) {
  if (!scene_.parameters.empty()) of_scene_ = impossible(with_values);
}

void GivenBodies::check(const model::Model& with_all, const std::vector<std::string>& sets,
                        Diagnostics& diagnostics) const {
  if (scene_.parameters.empty() && sets.empty()) return;
  for (const Diagnostic& found : impossible(with_all)) {
    const auto is_same = [&](const Diagnostic& one) { return one.message == found.message; };
    const bool is_of_scene = sets.empty() || std::any_of(of_scene_.begin(), of_scene_.end(), is_same);
    if (scene_.parameters.empty() || !is_of_scene) throw cli::UsageError("--set: " + found.message);
    diagnostics.error(found.code, place(), found.message, found.hint);
  }
}

gaussgen::support::Span GivenBodies::place() const {
  const auto& values = scene_.parameters;
  const auto own = std::find_if(values.begin(), values.end(), [&](const Given& one) { return is_own(one); });
  return own_is_to_blame_ && own != values.end() ? own->span : values.front().span;
}

std::vector<std::string> remarks_on_quaternions(const model::Model& read, const model::Values& values) {
  std::vector<std::string> remarks;
  for (const model::Orientation& one : read.orientations) {
    const auto is_given = [&](const model::Ast& ast) { return ast.span.begin == read.name.span.begin; };
    const auto length = model::initial_length(one, values);
    if (!length || std::none_of(one.initial.begin(), one.initial.end(), is_given)) continue;
    const std::string text = fmt::format("the initial quaternion of '{}' has length {:.4g}", one.name.text, *length);
    if (*length == 0) throw cli::UsageError(text + ": [1, 0, 0, 0] is no rotation");
    if (!model::is_length_of_rotation(*length)) remarks.push_back(text + ", and is divided by it");
  }
  return remarks;
}

}  // namespace gausssim
