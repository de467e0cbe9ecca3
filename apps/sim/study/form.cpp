#include "sim/study/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <functional>
#include <future>
#include <map>
#include <set>
#include <thread>

#include "cli/exit_codes.hpp"
#include "sim/engine/plugin_text.hpp"
#include "sim/run/interruption.hpp"
#include "sim/scene/choices.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// What the study looks at, or methods like to have, where a model has it.
const std::vector<std::string>& welcome_outputs() {
  static const std::vector<std::string> k_outputs{"jacobian", "mass_matrix", "poses", "reaction_forces",
                                                  "joint_reactions"};
  return k_outputs;
}

/// What strategies call a sum depends on what else they have formed; code that differs in names alone is the same. (Functions have no '_'.)
std::string with_numbered_names(const std::string& text) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::map<std::string, std::size_t> numbers;
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_part(text[end])) ++end;
    const std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
    result += word.find('_') == std::string::npos || word.size() == 1
                  ? word
                  : fmt::format("_{}", numbers.emplace(word, numbers.size()).first->second);
    i += word.size();
  }
  return result;
}

class Collector {
 public:
  Collector(std::string file, std::string instance, const cli::MessageOptions& messages, int& code)
      : file_(std::move(file)), instance_(std::move(instance)), messages_(messages), code_(code) {}

  std::vector<Form> all(bool is_alone) {
    Request own = request();
    // Methods for stiff models like to have it; all else is for what is compared beside them.
    if (is_alone) own.where_possible = {"jacobian"};
    auto first = prepared(
        own, [](Scene&) {}, code_);
    if (!first) return {};
    refuse_regimes(*first, "a study");
    const Scene scene = first->scene;
    texts_.insert(text_of(*first));
    push(scene.form, std::move(*first));
    auto& scalars = forms_.front().scalars;
    scalars = {"double", "__float128"};
    if (!is_alone || !forms_.front().model.edge.empty()) scalars.emplace_back("long double");
    if (!is_alone) scalars.emplace_back("float");
    if (!is_alone && !add_others(scene)) return {};
    build_all();
    return std::move(forms_);
  }

 private:
  /// The same outputs in all forms, whose texts can be compared then.
  Request request() const {
    Request request{file_, {}, {}, messages_};
    request.where_possible = welcome_outputs();
    request.instance = instance_;
    return request;
  }

  static std::string text_of(const PreparedModel& model) {
    return with_numbered_names(plugin_text(model.model.tree, {{}, {}}));
  }

  /// False after an error.
  bool add_others(const Scene& scene) {
    for (const GivenForm& form : scene.forms) {
      Request other = request();
      other.form = form.name.text;
      if (!add(other, form.name.text)) return false;
    }
    // What a strategy does not suit is told as it would be to a user; here it is no error.
    if (!scene.strategy) {
      for (const std::string& strategy : strategy_names())
        add_quietly(form_by_strategy(scene.form, strategy), [&](Scene& same) { same.strategy = Word{strategy, {}}; });
    }
    if (!scene.code) {
      for (const std::string& code : code_names())
        add_quietly(scene.form, [&](Scene& same) { same.code = Word{code, {}}; });
    }
    return true;
  }

  using Change = std::function<void(Scene&)>;

  static std::optional<PreparedModel> prepared(const Request& request, const Change& change, int& code) {
    throw_if_ended();
    return prepare(request, change, code);
  }

  bool add(const Request& request, const std::string& formulation) {
    auto model = prepared(
        request, [](Scene&) {}, code_);
    if (!model) return false;
    push(formulation, std::move(*model));
    forms_.back().is_of_scene = true;
    return true;
  }

  void push(const std::string& formulation, PreparedModel model) {
    const std::string code = code_of(model.scene);
    forms_.push_back({formulation, code, std::move(model), {"double"}, nullptr, {}});
  }

  static std::string code_of(const Scene& scene) { return scene.code ? scene.code->text : code_names().front(); }

  /// Where it is possible, and makes other code.
  void add_quietly(const std::string& formulation, const Change& change) {
    Request other = request();
    other.messages.is_silent = true;
    int ignored = 0;
    auto model = prepared(other, change, ignored);
    if (model && texts_.insert(text_of(*model)).second) push(formulation, std::move(*model));
  }

  struct Build {
    Form* form;
    std::string scalar, why;
    std::unique_ptr<Engine> engine;
    EngineTimes times;
  };

  /// As many compilers at a time as there are processors.
  void build_all() {
    std::vector<Build> builds;
    for (Form& form : forms_)
      for (const std::string& scalar : form.scalars) builds.push_back({&form, scalar, "", nullptr, {}});
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < builds.size(); i = next++) {
        Build& one = builds[i];
        one.engine = build_engine(one.form->model, EngineChoice::compiled, {one.scalar}, one.times, one.why);
      }
    };
    std::vector<std::future<void>> workers;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k)
      workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& worker : workers) worker.get();
    for (Form& form : forms_) gather(form, builds);
    if (forms_.front().engine) return;
    code_ = cli::fail(forms_.front().why, cli::k_file_error, messages_);
    forms_.clear();
  }

  static void gather(Form& form, std::vector<Build>& builds) {
    auto engine = std::make_unique<EngineOfNumbers>();
    for (Build& one : builds) {
      if (one.form != &form) continue;
      if (!one.engine) form.why = one.why;
      form.times.compile += one.times.compile;
      form.times.was_cached = form.times.was_cached || one.times.was_cached;
      if (one.engine) engine->add(one.scalar, std::move(one.engine));
    }
    if (form.why.empty()) form.engine = std::move(engine);
  }

  std::string file_, instance_;
  const cli::MessageOptions& messages_;
  int& code_;
  std::vector<Form> forms_;
  std::set<std::string> texts_;
};

}  // namespace

std::vector<Form> forms_of(const std::string& file, const std::string& instance, bool is_alone,
                           const cli::MessageOptions& messages, int& code) {
  return Collector(file, instance, messages, code).all(is_alone);
}

}  // namespace gausssim
