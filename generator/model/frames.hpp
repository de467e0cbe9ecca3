#pragma once
// What the sections that declare frames share, and their order. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

inline constexpr const char* k_child = "the child";  ///< what a frame of a joint is

/// Enters a frame; its parent is looked up when all are known. `parent`: nothing for space.
std::size_t add_frame(Frame frame, std::optional<Name> parent, const std::string& what, Reading& reading);

/// Likewise for the frame of a body, whose name is checked with the body.
std::size_t add_body_frame(Frame frame, std::optional<Name> parent, Reading& reading);

inline constexpr const char* k_hint_for_pair = "write two places, as in [space, bob]";

/// The name at `key`: nothing where it is 'space' or left out.
std::optional<Name> parent_field(const spec::Node& map, const std::string& key, Reading& reading);

/// The vector at `key`; zeros when it is absent.
std::array<Ast, 3> vector_field(const spec::Node& map, const std::string& key, Reading& reading);

/// Parents found, cycles reported, Model::frames sorted (parents first), and the places of all declared as symbols.
void order_frames(Reading& reading);

/// The frame that is called so, k_space for 'space'; nothing, and a report, if there is none.
std::optional<std::size_t> find_frame(const Name& name, Reading& reading);

/// Likewise for a value.
std::optional<std::size_t> find_frame_at(const spec::Node& node, support::Span owner, const std::string& what,
                                         Reading& reading);

/// Likewise; k_space after a report.
std::size_t frame_at(const spec::Node& node, support::Span owner, const std::string& what, Reading& reading);

}  // namespace gaussgen::model
