# gauss_add_model(TARGET <target> MODEL <file.yaml>
#                 [COUNTS <name>=<number> ...] [OUTPUTS <function> ...] [SENSITIVITIES <parameter> ...] [FOLD] [NAMESPACE <name>]
#                 [ROUTE paper] [STRATEGY <one>] [PARTS <number>] [SPLIT [<type> ...]] [AS_WRITTEN <rule> ...]
#                 [CONTRACT off|on|fast] [ALLOW_FAST_MATH])
#
# Generates <name>.hpp from a model when <target> is built, and puts it on the include path of the target:
# #include "<name>.hpp", where <name> is the name that the model file gives. The options are those of gauss-gen, but for the last
# two: what includes the header is compiled so that a product and a sum are rounded one by one (CONTRACT off), and -ffast-math is
# refused by the header.

# A count of the model: as it is given, else the number in its text; empty where that is a formula.
function(_gauss_count key text given result)
  set(count)
  foreach(one IN LISTS given)
    if(one MATCHES "^${key}=([0-9]+)$")
      set(count ${CMAKE_MATCH_1})
    endif()
  endforeach()
  if("${count}" STREQUAL "" AND "\n${text}" MATCHES "\n[\"']?counts[\"']?[ \t]*:(.*)")
    if("${CMAKE_MATCH_1}" MATCHES "[{, \t\n]${key}[ \t]*:[ \t]*([0-9]+)[ \t\r]*[,}\n]")
      set(count ${CMAKE_MATCH_1})
    endif()
  endif()
  set(${result} "${count}" PARENT_SCOPE)
endfunction()

# `chain_$n` with its counts put in; empty where one of them cannot be told.
function(_gauss_name_with_counts name text given result)
  while("${name}" MATCHES "\\$([A-Za-z][A-Za-z0-9]*)")
    set(key ${CMAKE_MATCH_1})
    _gauss_count(${key} "${text}" "${given}" count)
    if("${count}" STREQUAL "")
      set(name)
    endif()
    string(REGEX REPLACE "\\$${key}([^A-Za-z0-9]|$)" "${count}\\1" name "${name}")
  endwhile()
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

# The `name:` at the top level of a model's text; empty where it cannot be seen.
function(_gauss_name_in_text text result)
  string(REGEX REPLACE "([\n \t])#[^\n]*" "\\1" text "\n${text}")
  string(STRIP "${text}" text)
  if(text MATCHES "^{(.*)}$")
    # One flow mapping: the maps in it go, since something in them may be called `name`, and each entry gets a line.
    set(text "${CMAKE_MATCH_1}")
    while(text MATCHES "{[^{}]*}")
      string(REGEX REPLACE "{[^{}]*}" "" text "${text}")
    endwhile()
    string(REGEX REPLACE "[,\n][ \t\r\n]*" "\n" text ",${text}")
  endif()
  set(name)
  if("\n${text}" MATCHES "\n[\"']?name[\"']?[ \t]*:[ \t\r\n]*[\"']?([A-Za-z0-9_$]+)")
    set(name ${CMAKE_MATCH_1})
  endif()
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

# What gauss-gen says; empty while it is not built, and for a model with mistakes.
function(_gauss_name_by_generator model counts result)
  set(header)
  get_target_property(is_imported gauss::gauss-gen IMPORTED)
  if(is_imported)
    get_target_property(generator gauss::gauss-gen LOCATION)
    execute_process(COMMAND "${generator}" --list-outputs ${counts} "${model}" OUTPUT_VARIABLE header ERROR_QUIET
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
  get_filename_component(name "${header}" NAME_WE)
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

# The name that a model file gives, which is that of its header; the name of the file where that cannot be told.
function(_gauss_model_name model given result)
  list(TRANSFORM given PREPEND --count= OUTPUT_VARIABLE counts)
  _gauss_name_by_generator("${model}" "${counts}" name)
  if(NOT name)
    file(READ "${model}" text)
    _gauss_name_in_text("${text}" name)
    _gauss_name_with_counts("${name}" "${text}" "${given}" name)
  endif()
  if(NOT name)
    get_filename_component(name "${model}" NAME_WE)
  endif()
  set(${result} ${name} PARENT_SCOPE)
endfunction()

# The path of the model, or an error in our words.
function(_gauss_model_path target path result)
  get_filename_component(model "${path}" ABSOLUTE)
  if(model MATCHES ";")
    message(FATAL_ERROR "gauss_add_model(${target}): CMake takes paths apart at ';': rename '${model}'")
  endif()
  if(NOT EXISTS "${model}" OR IS_DIRECTORY "${model}")
    message(FATAL_ERROR "gauss_add_model(${target}): there is no model file '${model}'")
  endif()
  set(${result} "${model}" PARENT_SCOPE)
endfunction()

# CMake lets a rule make files for targets of its own directory alone; elsewhere the build would look for them in vain.
function(_gauss_check_target target)
  if(NOT TARGET ${target})
    message(FATAL_ERROR "gauss_add_model: no target '${target}'; call it after add_executable or add_library")
  endif()
  get_target_property(is_imported ${target} IMPORTED)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(binary_folder ${target} BINARY_DIR)
  if(is_imported)
    message(FATAL_ERROR "gauss_add_model(${target}): the target is imported, and not built here; add the model to one that is")
  endif()
  if(NOT binary_folder STREQUAL CMAKE_CURRENT_BINARY_DIR)
    message(FATAL_ERROR "gauss_add_model(${target}): the target is one of another directory, '${folder}': call it there, or add "
                        "the model to a library of this one: add_library(${target}_models INTERFACE), "
                        "gauss_add_model(TARGET ${target}_models ...), target_link_libraries(${target} PRIVATE ${target}_models)")
  endif()
endfunction()

# Words of a list however they are written: a b, "a;b", "a b" or "a,b".
function(_gauss_words result)
  list(JOIN ARGN "," words)
  string(REGEX REPLACE "[ \t\r\n\\;,]+" "," words "${words}")
  string(REGEX REPLACE "^,|,$" "" words "${words}")
  set(${result} "${words}" PARENT_SCOPE)
endfunction()

# Both headers would be one file, and one #include.
function(_gauss_refuse_second_of_name target name model)
  get_property(other GLOBAL PROPERTY _gauss_model_${target}_${name})
  if("${other}" STREQUAL "${model}")
    message(FATAL_ERROR "gauss_add_model(${target}): '${model}' is added twice; for two sets of options, add it to two targets, "
                        "for two sets of COUNTS put the count into its name, as in name: chain_$n")
  endif()
  if(other)
    message(FATAL_ERROR "gauss_add_model(${target}): '${other}' and '${model}' are both called '${name}', so both would be "
                        "${name}.hpp; give one another `name:`, or a target of its own")
  endif()
  set_property(GLOBAL PROPERTY _gauss_model_${target}_${name} "${model}")
endfunction()

# A model that has got another name leaves a header of the former one, and an #include of that would go on with the old model.
function(_gauss_remove_former_headers target folder)
  get_property(names GLOBAL PROPERTY _gauss_names_${target})
  file(GLOB headers "${folder}/*.hpp")
  foreach(header IN LISTS headers)
    get_filename_component(name "${header}" NAME_WE)
    if(NOT name IN_LIST names)
      file(REMOVE "${header}" "${header}.d" "${header}.stamp" "${folder}/${name}.cpp")
    endif()
  endforeach()
endfunction()

# Once the directory is read, since others may follow.
function(_gauss_keep_header target name folder)
  get_property(names GLOBAL PROPERTY _gauss_names_${target})
  if(NOT names)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL _gauss_remove_former_headers [==[${target}]==] [==[${folder}]==])")
  endif()
  set_property(GLOBAL APPEND PROPERTY _gauss_names_${target} ${name})
endfunction()

# How the target is compiled, for whatever includes headers of its models: results shall not depend on options and compilers. MSVC contracts
# nothing unless it is asked to.
function(_gauss_set_contraction target visibility contract)
  if("${contract}" STREQUAL "")
    set(contract off)
  endif()
  if(NOT contract MATCHES "^(off|on|fast)$")
    message(FATAL_ERROR "gauss_add_model(${target}): CONTRACT is 'off', 'on' or 'fast', and not '${contract}'")
  endif()
  get_property(other GLOBAL PROPERTY _gauss_contract_${target})
  if("${other}" STREQUAL "")
    set_property(GLOBAL PROPERTY _gauss_contract_${target} ${contract})
    set(gnu_like "GNU,Clang,AppleClang,ARMClang,IntelLLVM")
    if(NOT MSVC)
      target_compile_options(${target} ${visibility} "$<$<COMPILE_LANG_AND_ID:CXX,${gnu_like}>:-ffp-contract=${contract}>"
                             "$<$<COMPILE_LANG_AND_ID:CUDA,Clang>:-ffp-contract=${contract}>")
    endif()
    # Where g++ 12 makes vectors of straight code, it contracts pairs of products and sums (vfmaddsub) whatever -ffp-contract says.
    if(contract STREQUAL "off")
      target_compile_options(${target} ${visibility} "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-slp-vectorize>")
    endif()
    # nvcc has a switch, and hands the rest to the compiler of the host.
    set(fmad true)
    if(contract STREQUAL "off")
      set(fmad false)
    endif()
    target_compile_options(${target} ${visibility} "$<$<COMPILE_LANG_AND_ID:CUDA,NVIDIA>:--fmad=${fmad}>")
    if(NOT MSVC)
      target_compile_options(${target} ${visibility} "$<$<COMPILE_LANG_AND_ID:CUDA,NVIDIA>:-Xcompiler=-ffp-contract=${contract}>")
    endif()
  elseif(NOT other STREQUAL contract)
    message(FATAL_ERROR "gauss_add_model(${target}): CONTRACT is '${contract}' here and '${other}' for another model; a target is compiled "
                        "in one way: say the same for all its models, or use two targets")
  endif()
endfunction()

function(gauss_add_model)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "FOLD;ALLOW_FAST_MATH" "TARGET;MODEL;NAMESPACE;ROUTE;STRATEGY;PARTS;CONTRACT"
                        "COUNTS;OUTPUTS;SENSITIVITIES;SPLIT;AS_WRITTEN")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gauss_add_model: not understood: '${ARG_UNPARSED_ARGUMENTS}'; it takes TARGET, MODEL, COUNTS, OUTPUTS, "
                        "SENSITIVITIES, FOLD, NAMESPACE, ROUTE, STRATEGY, PARTS, SPLIT, AS_WRITTEN, CONTRACT and ALLOW_FAST_MATH")
  endif()
  # SPLIT alone is for double.
  if("SPLIT" IN_LIST ARG_KEYWORDS_MISSING_VALUES)
    list(REMOVE_ITEM ARG_KEYWORDS_MISSING_VALUES SPLIT)
    set(ARG_SPLIT double)
  endif()
  if(ARG_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "gauss_add_model: no value after ${ARG_KEYWORDS_MISSING_VALUES}; a variable may be empty")
  endif()
  if(NOT ARG_TARGET OR NOT ARG_MODEL)
    message(FATAL_ERROR "gauss_add_model: TARGET and MODEL are needed")
  endif()
  _gauss_check_target("${ARG_TARGET}")
  _gauss_model_path("${ARG_TARGET}" "${ARG_MODEL}" model)
  # However they are written, as OUTPUTS are.
  _gauss_words(counts ${ARG_COUNTS})
  string(REPLACE "," ";" counts "${counts}")
  _gauss_model_name("${model}" "${counts}" name)
  _gauss_refuse_second_of_name("${ARG_TARGET}" "${name}" "${model}")
  # Another name in the model file is another header.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${model}")

  set(options)
  foreach(count IN LISTS counts)
    list(APPEND options --count ${count})
  endforeach()
  if(ARG_FOLD)
    list(APPEND options --fold)
  endif()
  if(ARG_NAMESPACE)
    list(APPEND options --namespace ${ARG_NAMESPACE})
  endif()
  if(ARG_ROUTE)
    list(APPEND options --route ${ARG_ROUTE})
  endif()
  if(ARG_STRATEGY)
    list(APPEND options --strategy ${ARG_STRATEGY})
  endif()
  if(ARG_OUTPUTS)
    _gauss_words(outputs ${ARG_OUTPUTS})
    list(APPEND options --outputs ${outputs})
  endif()
  if(ARG_SENSITIVITIES)
    _gauss_words(sensitivities ${ARG_SENSITIVITIES})
    list(APPEND options --sensitivities ${sensitivities})
  endif()
  if(ARG_AS_WRITTEN)
    _gauss_words(rules ${ARG_AS_WRITTEN})
    list(APPEND options --as-written ${rules})
  endif()
  if(ARG_PARTS)
    list(APPEND options --parts ${ARG_PARTS})
  endif()

  # A folder per target, so that two targets may generate the same model with different options.
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/gauss/${ARG_TARGET}")
  file(MAKE_DIRECTORY "${folder}")
  _gauss_keep_header("${ARG_TARGET}" "${name}" "${folder}")
  set(header "${folder}/${name}.hpp")
  # CMake (3.25) rewrites depfiles and loses what protects a `$` or a `#`, and ninja takes few other signs in them; a file that is
  # never found would be generated at every build.
  set(depfile DEPFILE "${header}.d")
  set(lost "[$#]")
  if(CMAKE_GENERATOR MATCHES "Ninja")
    set(lost "[$#&'*?`^]")
  endif()
  if("${header}${model}" MATCHES "${lost}")
    message(WARNING "gauss_add_model(${ARG_TARGET}): in a folder with a '${CMAKE_MATCH_0}' in its name, as of '${model}', a change in "
                    "the files of submodels is not seen; rename the folder, or change the model file, too")
    set(depfile)
  endif()
  set(files "${header}")
  if(ARG_SPLIT)
    get_target_property(type ${ARG_TARGET} TYPE)
    if(type STREQUAL "INTERFACE_LIBRARY")
      message(FATAL_ERROR "gauss_add_model(${ARG_TARGET}): with SPLIT there is a file to compile, and an INTERFACE library compiles none: "
                          "add the model to a STATIC, SHARED or OBJECT library")
    endif()
    _gauss_words(types ${ARG_SPLIT})
    list(APPEND options --split ${types})
    list(APPEND files "${folder}/${name}.cpp")
    target_sources(${ARG_TARGET} PRIVATE "${folder}/${name}.cpp")
  endif()
  # gauss-gen leaves an unchanged header alone, so that nothing is compiled again; the stamp says that it was run. The
  # depfile names the files of submodels.
  set(byproducts BYPRODUCTS ${files})
  set(missing)
  if(CMAKE_GENERATOR MATCHES "Makefiles")
    # make does not look for byproducts. A rule that makes nothing, and that runs only where there is no header, lets the rule
    # of the stamp make one; the time of the header plays no part.
    add_custom_command(OUTPUT ${files} COMMAND "${CMAKE_COMMAND}" -E true COMMENT "" VERBATIM)
    set(byproducts)
    set(missing ${files})
  endif()
  add_custom_command(
    OUTPUT "${header}.stamp"
    ${byproducts}
    COMMAND gauss::gauss-gen "${model}" -o "${folder}" --depfile "${header}.d" --depfile-target "${header}.stamp" ${options}
    COMMAND "${CMAKE_COMMAND}" -E touch "${header}.stamp"
    DEPENDS "${model}" gauss::gauss-gen ${missing}
    ${depfile}
    COMMENT "Generating ${name}.hpp"
    VERBATIM)

  set(visibility PRIVATE)
  get_target_property(type ${ARG_TARGET} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(visibility INTERFACE)
  endif()
  target_sources(${ARG_TARGET} PRIVATE "${header}.stamp")
  target_include_directories(${ARG_TARGET} ${visibility} "${folder}")
  _gauss_set_contraction("${ARG_TARGET}" ${visibility} "${ARG_CONTRACT}")
  if(ARG_ALLOW_FAST_MATH)
    target_compile_definitions(${ARG_TARGET} ${visibility} GAUSS_ALLOW_FAST_MATH)
  endif()
endfunction()
