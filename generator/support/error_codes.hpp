#pragma once
// Every finding about a model file has a code that stays the same from version to version.

#include <string>

namespace gaussgen::support {

struct ErrorCode {
  const char* id;
  const char* meaning;
  operator std::string() const { return id; }
};

namespace code {

// The file and its YAML.
inline constexpr ErrorCode k_encoding{"E001", "the file is not UTF-8 text"};
inline constexpr ErrorCode k_forbidden_character{"E002", "an invisible or control character"};
inline constexpr ErrorCode k_file_too_large{"E003", "the file is too large or too deeply nested"};
inline constexpr ErrorCode k_yaml_syntax{"E004", "the text is not valid YAML"};
inline constexpr ErrorCode k_tab_indentation{"E005", "a tab where YAML wants spaces"};
inline constexpr ErrorCode k_duplicate_key{"E006", "a key appears twice in one map, or a word twice in a list"};
inline constexpr ErrorCode k_yaml_feature{"E007", "anchors, aliases and tags are not part of the format"};
inline constexpr ErrorCode k_several_documents{"E008", "more than one document in the file"};
inline constexpr ErrorCode k_empty_file{"E009", "there is nothing in the file"};

// Keys and the kinds of their values.
inline constexpr ErrorCode k_unknown_key{"E010", "a key that the format does not know"};
inline constexpr ErrorCode k_missing_key{"E011", "a key that must be there is not"};
inline constexpr ErrorCode k_wrong_kind{"E012", "a map, a list or a single value in the wrong place"};
inline constexpr ErrorCode k_wrong_count{"E013", "a list of the wrong length"};
inline constexpr ErrorCode k_format_version{"E014", "a format version that this program does not read"};
inline constexpr ErrorCode k_unknown_word{"E015", "a word outside a fixed list of choices"};
inline constexpr ErrorCode k_conflicting_keys{"E016", "keys that exclude each other"};
inline constexpr ErrorCode k_out_of_range{"E017", "a number outside of what its place takes"};

// Names.
inline constexpr ErrorCode k_invalid_name{"E020", "not a valid name"};
inline constexpr ErrorCode k_reserved_name{"E021", "a name with a fixed meaning in expressions or in emitted code"};
inline constexpr ErrorCode k_name_clash{"E022", "one name for two things"};
inline constexpr ErrorCode k_rate_clash{"E023", "a name that equals the derived name of a rate"};
inline constexpr ErrorCode k_wrong_reference{"E024", "a name that refers to nothing, or to the wrong kind of thing"};

// Expressions.
inline constexpr ErrorCode k_unexpected_character{"E030", "a character that expressions do not know"};
inline constexpr ErrorCode k_unknown_name{"E031", "a name that is not declared"};
inline constexpr ErrorCode k_malformed_number{"E032", "a number that cannot be read"};
inline constexpr ErrorCode k_expression_syntax{"E033", "an operand or an operator is missing"};
inline constexpr ErrorCode k_unbalanced_brackets{"E034", "a bracket without its partner"};
inline constexpr ErrorCode k_implicit_product{"E035", "two operands without an operator between them"};
inline constexpr ErrorCode k_function_call{"E036", "an unknown function, or a wrong number of arguments"};
inline constexpr ErrorCode k_exponent{"E037", "an exponent that is not a small constant"};
inline constexpr ErrorCode k_expression_limit{"E038",
                                              "an expression that is too long, too deep or has too large numbers"};
inline constexpr ErrorCode k_empty_expression{"E039", "an expression is missing"};

// What is allowed where.
inline constexpr ErrorCode k_not_allowed_here{"E040", "a symbol that may not appear at this place"};
inline constexpr ErrorCode k_dot_not_allowed{"E041", "dot(...) where no velocity may appear"};
inline constexpr ErrorCode k_cyclic_parameters{"E042", "parameters that are defined by each other"};
inline constexpr ErrorCode k_cyclic_frames{"E043", "frames that are placed against each other"};
inline constexpr ErrorCode k_not_linear{"E044", "a force that is not linear in reactions"};

// Mechanics.
inline constexpr ErrorCode k_no_bodies{"E050", "a model without bodies"};
inline constexpr ErrorCode k_nothing_moves{"E051", "a model without coordinates"};
inline constexpr ErrorCode k_no_inertia{"E052", "a speed that moves no body"};
inline constexpr ErrorCode k_undefined_value{"E053", "an expression without a real value"};
inline constexpr ErrorCode k_not_finite{"E054", "a value that overflows or is not a number"};
inline constexpr ErrorCode k_negative_inertia{"E055", "a mass or an inertia that no body has"};
inline constexpr ErrorCode k_inertia_without_attitude{"E056", "inertia without orientation, or the other way round"};
inline constexpr ErrorCode k_asymmetric_inertia{"E057", "an inertia matrix that is not symmetric"};
inline constexpr ErrorCode k_no_velocity{"E058", "a velocity constraint that no free speed is in"};
inline constexpr ErrorCode k_dependent_speeds{"E059", "a choice of dependent speeds that cannot be"};

// Units and dimensions.
inline constexpr ErrorCode k_malformed_unit{"E061", "a unit that is not known or cannot be read"};
inline constexpr ErrorCode k_unlike_terms{"E062", "a sum, comparison or choice of quantities in different units"};
inline constexpr ErrorCode k_argument_dimension{"E063", "the argument of a function in a wrong unit"};
inline constexpr ErrorCode k_wrong_dimension{"E064", "an expression whose place wants another unit"};

// What this program cannot do with a correct model.
inline constexpr ErrorCode k_no_paper_route{"E060", "the paper's route does not take the model"};
inline constexpr ErrorCode k_no_tree{"E069", "a model whose Z cannot be minimised body by body"};

// Quasi-velocities.
inline constexpr ErrorCode k_speeds{"E068", "speeds from which the rates do not follow"};

// Functions and tables.
inline constexpr ErrorCode k_not_smooth{"E065", "a jump or a kink where derivatives are needed"};
inline constexpr ErrorCode k_comparison{"E066", "a comparison out of place, or a condition that is none"};
inline constexpr ErrorCode k_table_points{"E067", "points of a table that make no function"};
inline constexpr ErrorCode k_unused{"W064", "a table, parameter, input or setting that nothing uses"};

inline constexpr ErrorCode k_idle_force{"W067", "a force that nothing feels"};
inline constexpr ErrorCode k_idle_held_coordinate{"W050", "a held coordinate that moves no body"};
inline constexpr ErrorCode k_unreal_inertia{"W063", "moments of inertia that no body has"};
inline constexpr ErrorCode k_no_mass{"W056", "a body with neither mass nor inertia"};
inline constexpr ErrorCode k_forgotten_inertia{"W065", "a body that turns and states no inertia"};
inline constexpr ErrorCode k_quaternion_length{"W061", "an initial quaternion that is far from unit length"};
inline constexpr ErrorCode k_scaled_unit{"W055", "a unit that would need a conversion"};
inline constexpr ErrorCode k_missing_unit{"W062", "names without a unit beside others that have one"};

// Repetition and submodels.
inline constexpr ErrorCode k_index{"E090", "an index or a count that cannot be worked out"};
inline constexpr ErrorCode k_submodel_file{"E091", "the file of a submodel cannot be taken"};
inline constexpr ErrorCode k_submodel_fit{"E092", "a submodel that does not fit into the model"};
inline constexpr ErrorCode k_coupled_reactions{"E045", "reactions that forces leave open"};
inline constexpr ErrorCode k_impossible_restitution{"E046", "a restitution, or the size of a force, that there is none of"};

// Effects.
inline constexpr ErrorCode k_effect_choice{"E093", "a choice of effects that cannot be"};
inline constexpr ErrorCode k_effect_fit{"E094", "an effect that says something else than what is there"};

// The initial state, which is looked at when the equations are there.
inline constexpr ErrorCode k_impossible_start{"E070", "an initial state that violates a constraint, and is emitted"};
inline constexpr ErrorCode k_violating_start{"W051", "an initial state that violates a constraint, and is not emitted"};
inline constexpr ErrorCode k_contradiction{"E080", "constraints that no motion satisfies together"};
inline constexpr ErrorCode k_contradictory_start{
    "W080", "an initial state at which no motion satisfies the constraints, and that is not emitted"};
inline constexpr ErrorCode k_undefined_start{"W052", "an initial state at which something has no value"};
inline constexpr ErrorCode k_singular_start{"W053", "an initial state without accelerations"};
inline constexpr ErrorCode k_dependent_start{"W057", "an initial state at which constraints follow from each other"};
inline constexpr ErrorCode k_far_start{"W068",
                                       "guesses from which emitted code finds no start, or one that rounding decides"};
inline constexpr ErrorCode k_chosen_start{"W059", "initial rates that the constraints do not determine"};

// What the equations show about every configuration.
inline constexpr ErrorCode k_redundant_constraint{"W054", "a constraint that follows from the others"};
inline constexpr ErrorCode k_unsafe_choice{"W060", "a choice of dependent speeds that breaks down somewhere"};
inline constexpr ErrorCode k_vanishing_gradient{"W071",
                                                "a constraint that says nothing wherever it holds, as a square"};
inline constexpr ErrorCode k_carried_contact{"W072", "what rolls on a point that it takes along"};
inline constexpr ErrorCode k_singular_chart{"W070", "coordinates that do not describe every motion somewhere"};
inline constexpr ErrorCode k_idle_point{"W058", "the point of a constraint whose force is not determined"};
inline constexpr ErrorCode k_empty_output{"W066", "an output that is empty for this model"};

}  // namespace code

/// What is found in the text of a model.
inline constexpr ErrorCode k_all_codes[] = {
    code::k_encoding,
    code::k_forbidden_character,
    code::k_file_too_large,
    code::k_yaml_syntax,
    code::k_tab_indentation,
    code::k_duplicate_key,
    code::k_yaml_feature,
    code::k_several_documents,
    code::k_empty_file,
    code::k_unknown_key,
    code::k_missing_key,
    code::k_wrong_kind,
    code::k_wrong_count,
    code::k_format_version,
    code::k_unknown_word,
    code::k_conflicting_keys,
    code::k_out_of_range,
    code::k_invalid_name,
    code::k_reserved_name,
    code::k_name_clash,
    code::k_rate_clash,
    code::k_wrong_reference,
    code::k_unexpected_character,
    code::k_unknown_name,
    code::k_malformed_number,
    code::k_expression_syntax,
    code::k_unbalanced_brackets,
    code::k_implicit_product,
    code::k_function_call,
    code::k_exponent,
    code::k_expression_limit,
    code::k_empty_expression,
    code::k_not_allowed_here,
    code::k_dot_not_allowed,
    code::k_cyclic_parameters,
    code::k_cyclic_frames,
    code::k_not_linear,
    code::k_no_bodies,
    code::k_nothing_moves,
    code::k_no_inertia,
    code::k_undefined_value,
    code::k_not_finite,
    code::k_negative_inertia,
    code::k_inertia_without_attitude,
    code::k_asymmetric_inertia,
    code::k_no_velocity,
    code::k_dependent_speeds,
    code::k_malformed_unit,
    code::k_unlike_terms,
    code::k_argument_dimension,
    code::k_wrong_dimension,
    code::k_not_smooth,
    code::k_comparison,
    code::k_table_points,
    code::k_speeds,
    code::k_unused,
    code::k_index,
    code::k_submodel_file,
    code::k_submodel_fit,
    code::k_effect_choice,
    code::k_effect_fit,
    code::k_idle_force,
    code::k_idle_held_coordinate,
    code::k_scaled_unit,
    code::k_missing_unit,
    code::k_no_mass,
    code::k_forgotten_inertia,
    code::k_unreal_inertia,
    code::k_quaternion_length,
};

/// What only the stages after it can find.
inline constexpr ErrorCode k_stage_codes[] = {
    code::k_no_paper_route,       code::k_impossible_start, code::k_violating_start,   code::k_undefined_start,
    code::k_singular_start,       code::k_dependent_start,  code::k_far_start,         code::k_chosen_start,
    code::k_redundant_constraint, code::k_unsafe_choice,    code::k_idle_point,        code::k_contradiction,
    code::k_contradictory_start,  code::k_empty_output,     code::k_no_tree,           code::k_singular_chart,
    code::k_vanishing_gradient,   code::k_carried_contact,  code::k_coupled_reactions, code::k_impossible_restitution,
};

}  // namespace gaussgen::support
