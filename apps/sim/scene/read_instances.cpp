#include "sim/scene/read_instances.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/names.hpp"
#include "scene_choice.hpp"
#include "sim/scene/choices.hpp"
#include "sim/scene/read_fields.hpp"
#include "support/error_codes.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
namespace spec = gaussgen::spec;

class InstancesReader {
 public:
  InstancesReader(Scene& scene, model::Reading& reading) : scene_(scene), reading_(reading) {}

  void read(const spec::Entry& section) {
    scene_.instances_place = section.key.span;
    if (!model::expect_map(section.value, section.key.span, "'instances'", reading_)) return;
    if (section.value.entries.empty())
      reading_.diagnostics.error(code::k_wrong_count, section.value.span, "there is no instance",
                                 "name some, such as {near: {effects: [+air]}, far: {}}, or leave 'instances' out");
    for (const spec::Entry& entry : section.value.entries) read_one(entry);
  }

 private:
  void read_one(const spec::Entry& entry) {
    Instance one;
    one.name = {entry.key.text, entry.key.span};
    model::check_name(model::name_of(entry.key), reading_);
    const std::string where = fmt::format("instance '{}'", one.name.text);
    // Nothing at all is as good as an empty map: it is the scene itself.
    const bool is_plain = entry.value.kind == spec::NodeKind::empty;
    if (!is_plain && model::expect_map(entry.value, entry.key.span, where, reading_)) {
      one.extent = entry.value.span;
      model::check_keys(entry.value, where, gaussgen::keys_of_instances(), reading_);
      read_fields(entry.value, entry.key.span, one);
    }
    scene_.instances.push_back(std::move(one));
  }

  void read_fields(const spec::Node& map, gaussgen::support::Span owner, Instance& one) {
    FieldReader fields(map, owner, reading_);
    one.about = model::text_field(map, "about", reading_);
    fields.effects(one.effects);
    fields.given("parameters", one.parameters);
    fields.given("initial", one.initial);
    fields.given("inputs", one.inputs);
    fields.given("exact", one.exact);
    fields.outputs(one.outputs);
    one.method = fields.choice("method", method_names());
    one.tolerance = fields.positive("tolerance", one.places);
    one.step = fields.positive("step", one.places);
    one.longest_step = fields.positive("longest_step", one.places);
    refuse_beside_error(one);
    refuse_what_varies(one);
  }

  /// The error is that of all instances, and a search finds the rest.
  void refuse_beside_error(const Instance& one) {
    if (!scene_.error) return;
    for (const char* const key : {"tolerance", "step"}) {
      const auto place = one.places.find(key);
      if (place != one.places.end())
        reading_.diagnostics.error(code::k_conflicting_keys, place->second,
                                   fmt::format("'{}' and the 'error' of the scene exclude each other", key),
                                   "leave one of the two out");
    }
  }

  /// The ensemble of an instance draws it for each trajectory.
  void refuse_what_varies(const Instance& one) {
    if (!scene_.ensemble) return;
    for (const Varied& varied : scene_.ensemble->varied) {
      const std::vector<Given>& all = varied.section == Section::parameters ? one.parameters
                                      : varied.section == Section::initial  ? one.initial
                                                                            : one.inputs;
      const auto given = std::find_if(all.begin(), all.end(), [&](const Given& g) { return g.name == varied.name; });
      if (given != all.end())
        reading_.diagnostics.error(code::k_conflicting_keys, given->span,
                                   fmt::format("the scene's 'ensemble' varies '{}'", varied.name),
                                   "leave one of the two out");
    }
  }

  Scene& scene_;
  model::Reading& reading_;
};

}  // namespace

void read_instances(const spec::Node& root, Scene& scene, model::Reading& reading) {
  for (const spec::Entry& entry : root.entries) {
    if (entry.key.text == "instances") InstancesReader(scene, reading).read(entry);
  }
}

}  // namespace gausssim
