#pragma once
// Laws of forces that have files of their own. `law` is the key that says which it is, `where` names the force in messages. Private to the
// folder.

#include <string>

#include "model/reading.hpp"

namespace gaussgen::model {

PointForce read_drag(const spec::Entry& force, const spec::Entry& law, const std::string& where, Reading& reading);
PointForce read_magnus(const spec::Entry& force, const spec::Entry& law, const std::string& where, Reading& reading);

/// As long as fields are not known, its components are the mass of what is displaced.
PointForce read_buoyancy(const spec::Entry& force, const spec::Entry& law, const std::string& where, Reading& reading);
void finish_buoyancy(PointForce& push, const std::vector<Force>& forces);

/// `friction: velocity` or `friction: [velocity, velocity]`.
Friction read_friction(const spec::Entry& force, const spec::Entry& law, const std::string& where, Reading& reading);
/// `slides: body` on another one.
Friction read_sliding(const spec::Entry& force, const spec::Entry& law, const std::string& where, Reading& reading);

/// `on` and `at` in `map`, of rolling and sliding; `law` names the body. No direction yet.
SlipLaw read_contact_of(const spec::Node& map, support::Span owner, const spec::Entry& law, const std::string& where,
                        Reading& reading);

}  // namespace gaussgen::model
