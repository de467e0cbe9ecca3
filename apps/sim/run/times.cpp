#include "sim/run/times.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "cli/usage_error.hpp"
#include "support/error_codes.hpp"

namespace gausssim {

namespace {

namespace model = gaussgen::model;

class TimesReader {
 public:
  TimesReader(const Scene& scene, const model::Values& values, gaussgen::support::Diagnostics& diagnostics)
      : scene_(scene), values_(values), diagnostics_(diagnostics) {}

  Span read() {
    Span span;
    const auto start = value(scene_.start, "start", span.start, false);
    const auto duration = value(scene_.duration, "duration", span.duration, true);
    const auto every = value(scene_.every, "every", span.duration, true);
    if (!start || !duration || !every) return span;
    span.start = *start;
    span.duration = *duration;
    if (scene_.samples) span.samples = *scene_.samples;
    if (scene_.every && !take_every(*every, span)) return span;
    if (!std::isfinite(span.start + span.duration)) {
      refuse(*(scene_.duration ? scene_.duration : scene_.start), scene_.duration ? "duration" : "start",
             "the end is beyond the largest number");
      return span;
    }
    check_samples(span);
    return span;
  }

 private:
  /// Their times are to be told from each other.
  void check_samples(const Span& span) {
    const bool is_float = scene_.number && scene_.number->text == "float";
    const double between = span.duration / static_cast<double>(span.samples - 1), end = span.start + span.duration;
    const auto is_later = [&](double t) {
      if (is_float) return static_cast<float>(t + between) > static_cast<float>(t);
      return t + between > t;
    };
    if (is_later(span.start) && is_later(end - between)) return;
    const std::string why =
        fmt::format("in {}, {:.6g} s later is the same time", is_float ? "float" : "double", between);
    if (scene_.start) return refuse(*scene_.start, "start", why);
    if (scene_.duration) return refuse(*scene_.duration, "duration", why);
    if (!is_float || is_of_option(scene_.number->span)) throw gaussgen::cli::UsageError(why);
    diagnostics_.error(gaussgen::support::code::k_out_of_range, scene_.number->span, why);
  }

  /// False where there would be too few or too many samples, which is reported.
  bool take_every(double every, Span& span) {
    const double count = std::floor(span.duration / every * (1 + 1e-12));
    constexpr double k_most = 1e8;
    if (!(count >= 1 && count < k_most)) {
      refuse(*scene_.every, "every", fmt::format("this makes {} samples; there may be from 2 to {}", count + 1, k_most),
             "it is the time from a row to the next one, and no longer than the duration");
      return false;
    }
    span.samples = static_cast<long>(count) + 1;
    span.every = every;
    // Rows are where they are asked for, and the run ends with the last one.
    const double end = count * every;
    if (end < span.duration * (1 - 1e-12)) span.duration = end;
    return true;
  }

  /// Nothing where there is no such value, which is reported.
  std::optional<double> value(const std::optional<model::Ast>& ast, const char* key, double otherwise,
                              bool is_positive) {
    if (!ast) return otherwise;
    if (model::is_broken(*ast)) return std::nullopt;
    const auto found = model::value_of(*ast, values_);
    if (found && std::isfinite(*found) && (!is_positive || *found > 0)) return found;
    refuse(*ast, key, fmt::format("'{}' must be a number{}", key, is_positive ? " above 0" : ""),
           found && is_positive ? fmt::format("such as {}: 10", key)
                                : "it may be made of numbers, pi and parameters of the model");
    return std::nullopt;
  }

  /// Options have no place in the file.
  void refuse(const model::Ast& ast, const char* key, const std::string& message, const std::string& hint = "") {
    if (!ast.text.empty())
      throw gaussgen::cli::UsageError(
          fmt::format("--{} {}: {}{}{}", key, ast.text, message, hint.empty() ? "" : "; ", hint));
    diagnostics_.error(gaussgen::support::code::k_out_of_range, ast.span, message, hint);
  }

  const Scene& scene_;
  const model::Values& values_;
  gaussgen::support::Diagnostics& diagnostics_;
};

}  // namespace

Span read_times(const Scene& scene, const model::Values& parameters, gaussgen::support::Diagnostics& diagnostics) {
  return TimesReader(scene, parameters, diagnostics).read();
}

}  // namespace gausssim
