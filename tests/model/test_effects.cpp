// `effects:` what acts is the same as its entries written in place, and of what does not act nothing is left.
#include <map>

#include "catch_shim.hpp"
#include "dump_text.hpp"
#include "model/effect_choice.hpp"

using gaussgen::model::Choices;
using gaussgen::model::Effect;
using gaussgen::model::GivenEffects;
using gaussgen::model::Name;
using test::Built;
using test::k_header;
using test::k_particle;
using test::k_x;
using test::written_out;

namespace {

Effect effect(const std::string& name, bool by_default = false) { return {{name, {}}, "", by_default}; }

Effect needing(Effect effect, const std::string& other) {
  effect.needs.push_back({other, {}});
  return effect;
}

Effect excluding(Effect effect, const std::string& other) {
  effect.excludes.push_back({other, {}});
  return effect;
}

Effect one_of(Effect effect, const std::string& choice) {
  effect.one_of = Name{choice, {}};
  return effect;
}

const std::vector<Effect> k_effects{effect("gravity", true), effect("air", true), needing(effect("gusts"), "air"),
                                    excluding(effect("vacuum"), "air"), one_of(effect("rigid", true), "rod"),
                                    one_of(effect("elastic"), "rod")};

/// Those that act, then what is wrong with which word.
std::string chosen(const GivenEffects& words, std::vector<Effect> effects = k_effects) {
  const auto mistakes = gaussgen::model::choose_effects(effects, words);
  std::string text;
  for (const Effect& one : effects) {
    if (one.acts) text += (text.empty() ? "" : " ") + one.name.text;
  }
  for (const auto& one : mistakes)
    text += "; " + (one.word ? words[*one.word] : effects[*one.effect].name.text) + ": " + one.message;
  return text;
}

std::string of(const std::string& text, const GivenEffects& words) {
  gaussgen::support::Source source("m.yaml", text);
  gaussgen::support::Diagnostics diagnostics;
  Built built(source);
  built.diagnostics = {};
  built.model = gaussgen::model::build_model(source, built.diagnostics, {{}, words});
  return built.model ? written_out(built) : built.codes();
}

}  // namespace

TEST_CASE("words choose effects: the default, all, none, names, and names with signs beside these") {
  CHECK(chosen({}) == "gravity air rigid");
  CHECK(chosen({"default"}) == "gravity air rigid");
  CHECK(chosen({"none"}) == "rigid");
  CHECK(chosen({"air", "gusts"}) == "air gusts rigid");
  CHECK(chosen({"+gusts"}) == "gravity air gusts rigid");
  CHECK(chosen({"-air"}) == "gravity rigid");
  CHECK(chosen({"none", "+air"}) == "air rigid");
  CHECK(chosen({"all", "-vacuum"}) == "gravity air gusts rigid");
  CHECK(chosen({"all", "-air", "-gusts", "elastic"}) == "gravity vacuum elastic");
}

TEST_CASE("of effects that are one of the same, exactly one acts") {
  CHECK(chosen({"+elastic"}) == "gravity air elastic");
  CHECK(chosen({"elastic"}) == "elastic");
  CHECK(chosen({"elastic", "-rigid"}) == "elastic");
  CHECK(chosen({"elastic", "rigid"}) ==
        "rigid; rigid: 'elastic' and 'rigid' do not act together: of 'rod' one acts");
  CHECK(chosen({"-rigid"}) == "gravity air; -rigid: without 'rigid', nothing of 'rod' acts");
}

TEST_CASE("what does not go together is said at the word that is to blame") {
  CHECK(chosen({"gusts"}) == "gusts rigid; gusts: 'gusts' requires 'air', which does not act");
  CHECK(chosen({"+gusts", "-air"}) == "gravity gusts rigid; -air: 'gusts' requires 'air', which does not act");
  CHECK(chosen({"vacuum", "air"}) == "air vacuum rigid; air: 'vacuum' excludes 'air', which acts, too");
  CHECK(chosen({"all"}) == "gravity air gusts vacuum rigid; all: 'vacuum' excludes 'air', which acts, too");
  CHECK(chosen({"air", "gravity", "+air"}) == "gravity air rigid; +air: 'air' is chosen twice");
  CHECK(chosen({"gravity", "none"}) == "gravity rigid; none: 'none' stands behind other words");
  CHECK(chosen({"gravty"}) == "rigid; gravty: there is no effect 'gravty'");
  CHECK(chosen({}, {needing(effect("gusts", true), "air"), effect("air")}) ==
        "gusts; gusts: 'gusts' requires 'air', which does not act");
}

TEST_CASE("entries of an effect that acts stand behind those of the file, in the order in which effects are declared") {
  const std::string effects =
      "effects:\n"
      "  drag: {parameters: {c: 2}, forces: {drag: {generalized: {x: -c*dot(x)}}}}\n"
      "  spring: {default: on, parameters: {k: 3}, forces: {spring: {spring: x, stiffness: k}}}\n";
  const std::string base = k_header + "parameters: {m: 1}\n" + k_x + "particles: {p: {mass: m, position: [x, 0, 0]}}\n";
  CHECK(of(base + effects, {"spring", "drag"}) ==
        written_out(k_header + "parameters: {m: 1, c: 2, k: 3}\n" + k_x +
                    "particles: {p: {mass: m, position: [x, 0, 0]}}\n"
                    "forces: {drag: {generalized: {x: -c*dot(x)}}, spring: {spring: x, stiffness: k}}\n"));
  CHECK(of(base + effects, {}) == written_out(k_header + "parameters: {m: 1, k: 3}\n" + k_x +
                                              "particles: {p: {mass: m, position: [x, 0, 0]}}\n"
                                              "forces: {spring: {spring: x, stiffness: k}}\n"));
  CHECK(of(base + effects, {"none"}) == written_out(base));
}

TEST_CASE("an effect gives keys to entries that are there, and says nothing else than they do") {
  const std::string rod =
      k_header +
      "parameters: {l: 2}\n"
      "coordinates: {s: {about: length}, theta: {}}\n"
      "particles: {p: {mass: 1, position: [s*sin(theta), 0, -s*cos(theta)]}}\n"
      "effects:\n"
      "  rigid: {one_of: rod, default: on, coordinates: {s: {held_at: l}}}\n"
      "  elastic: {one_of: rod, coordinates: {s: {initial: l}}, forces: {rod: {spring: s, stiffness: 9, rest: l}}}\n"
      "  same: {parameters: {l: 2}}\n"
      "  other: {parameters: {l: 3}}\n";
  const std::string rigid = of(rod, {});
  CHECK(rigid.find("held") != std::string::npos);
  CHECK(of(rod, {"elastic"}) ==
        written_out(k_header +
                    "parameters: {l: 2}\n"
                    "coordinates: {s: {about: length, initial: l}, theta: {}}\n"
                    "particles: {p: {mass: 1, position: [s*sin(theta), 0, -s*cos(theta)]}}\n"
                    "forces: {rod: {spring: s, stiffness: 9, rest: l}}\n"));
  CHECK(of(rod, {"+same"}) == rigid);
  CHECK(of(rod, {"+other"}) == "E094");
}

TEST_CASE("entries of effects are repeated, and keys go to the copies") {
  const std::string chain = k_header +
                            "counts: {n: 2}\n"
                            "coordinates: {x_$i: {count: n}}\n"
                            "particles: {p_$i: {count: n, mass: 1, position: [x_$i, 0, 0]}}\n";
  CHECK(of(chain + "effects: {start: {default: on, coordinates: {x_$i: {count: n, initial: $i}},\n"
                   "  forces: {f_$i: {count: n, generalized: {x_$i: $i}}}}}\n",
           {}) == written_out(k_header +
                              "coordinates: {x_1: {initial: 1}, x_2: {initial: 2}}\n"
                              "particles: {p_1: {mass: 1, position: [x_1, 0, 0]}, p_2: {mass: 1, position: [x_2, 0, 0]}}\n"
                              "forces: {f_1: {generalized: {x_1: 1}}, f_2: {generalized: {x_2: 2}}}\n"));
}

TEST_CASE("a model chooses the effects of its submodels, one by one") {
  const std::string part = k_header + k_x + k_particle +
                           "effects: {pull: {default: on, forces: {pull: {generalized: {x: -x}}}},\n"
                           "  drag: {parameters: {c: 1}, forces: {drag: {generalized: {x: -c*dot(x)}}}}}\n";
  const auto built = [&](const std::string& submodels) {
    const auto read = [&](const std::string&, std::string&) { return std::optional(part); };
    const Built model(gaussgen::support::Source("m.yaml", k_header + submodels, read));
    return model.model ? written_out(model) : model.codes();
  };
  const std::string of_a =
      "coordinates: {a_x: {}, b_x: {}}\n"
      "particles: {a_p: {mass: 1, position: [a_x, 0, 0]}, b_p: {mass: 1, position: [b_x, 0, 0]}}\n";
  CHECK(built("submodels: {a: {file: p.yaml}, b: {file: p.yaml, effects: [drag]}}\n") ==
        written_out(k_header + "parameters: {b_c: 1}\n" + of_a +
                    "forces: {a_pull: {generalized: {a_x: -a_x}}, b_drag: {generalized: {b_x: -b_c*dot(b_x)}}}\n"));
  CHECK(built("submodels: {a: {file: p.yaml, effects: none}, b: {file: p.yaml, effects: [-pull]}}\n") ==
        written_out(k_header + of_a));
  CHECK(built("submodels: {a: {file: p.yaml, effects: [dreg, drag, -pull]}}\n") == "E093");
}

TEST_CASE("an effect of a model chooses effects of its submodels") {
  const std::string part =
      k_header + k_x + k_particle + "effects: {pull: {forces: {pull: {generalized: {x: -x}}}}}\n";
  const auto read = [&](const std::string&, std::string&) { return std::optional(part); };
  const Built model(gaussgen::support::Source(
      "m.yaml",
      k_header +
          "submodels: {a: {file: p.yaml}}\neffects: {pulled: {default: on, submodels: {a: {effects: [pull]}}}}\n",
      read));
  REQUIRE(model.model);
  CHECK(model.model->forces.size() == 1);
}

TEST_CASE("closed forms of a model are those of the effects that act by default") {
  const std::string text = test::with(
      "exact: {x: 0*t, x_dot: 0*t}\neffects: {pull: {forces: {f: {generalized: {x: -x}}}}}\n");
  const auto forms = [&](const GivenEffects& words) {
    gaussgen::support::Source source("m.yaml", text);
    gaussgen::support::Diagnostics diagnostics;
    return gaussgen::model::build_model(source, diagnostics, {{}, words})->exact.size();
  };
  CHECK(forms({}) == 2);
  CHECK(forms({"pull"}) == 0);
}

TEST_CASE("a name that an absent effect has is no slip of another one") {
  const Built built(test::with("quantities: {q: c*x}\neffects: {drag: {parameters: {c: 1}}}\n"));
  REQUIRE(built.codes() == "E031");
  CHECK(built.diagnostics.all()[0].hint == "'c' is of the effect 'drag', which does not act");
}

TEST_CASE("of an effect that does not act the shape is looked at") {
  CHECK(Built(test::with("effects: {a: {forces: {f: {generlized: {x: 1}}}}}\n")).codes() == "E010");
  CHECK(Built(test::with("effects: {a: {forces: {f: {force: [1, 2], on: p}}}}\n")).codes() == "E013");
  CHECK(Built(test::with("effects: {a: {joints: {f: {type: revolut, child: k}}}}\n")).codes() == "E015");
  CHECK(Built(test::with("effects: {a: {parameters: {f: [1]}}}\n")).codes() == "E012");
  CHECK(Built(test::with("effects: {a: {forces: {f: {spring: x, stiffness: 1, about: what, rest: 0}}}}\n")).codes() ==
        "");
}

TEST_CASE("what effects say of each other is checked whatever is chosen") {
  CHECK(Built(test::with("effects: {a: {requires: [b]}}\n")).codes() == "E024");
  CHECK(Built(test::with("effects: {a: {excludes: [a]}, b: {}}\n")).codes() == "E024");
  CHECK(Built(test::with("effects: {a: {one_of: w}, b: {one_of: w}}\n")).codes() == "E093");
  CHECK(Built(test::with("effects: {a: {one_of: w, default: on}, b: {}}\n")).codes() == "E093");
  CHECK(Built(test::with("effects: {a: {default: on, requires: [b]}, b: {}}\n")).codes() == "E093");
  CHECK(Built(test::with("effects: {all: {}}\n")).codes() == "E021");
  CHECK(Built(test::with("effects: {a: {default: maybe}}\n")).codes() == "E015");
}

TEST_CASE("effects that are chosen and are not there are the user's mistake, not the file's") {
  gaussgen::support::Source source("m.yaml", test::with("effects: {a: {}}\n"));
  gaussgen::support::Diagnostics diagnostics;
  CHECK_THROWS_AS(gaussgen::model::build_model(source, diagnostics, {{}, {"b"}}), gaussgen::model::WrongEffects);
  CHECK_FALSE(diagnostics.has_errors());
}
