# How the folders of generator/ become libraries, and who may link whom.

find_package(Threads REQUIRED)

# Warnings for our own targets only; a user who adds this project as a subdirectory keeps their own.
add_library(gauss_warnings INTERFACE)
target_compile_options(gauss_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor
  $<$<BOOL:${GAUSS_WARNINGS_AS_ERRORS}>:-Werror>)

# gauss_generator_library(<folder> SOURCES ... [ALONE ...] [DEPENDS <folder> ...] [LIBRARIES <target> ...])
#
# One static library per folder of generator/. DEPENDS names other folders: it is the arrow of the
# architecture table, and tools/check_layering.py holds the includes against the same table.
# ALONE: those of SOURCES with names of their own that others of the folder have, too: where files are compiled together
# (preset release), these are not.
function(gauss_generator_library folder)
  cmake_parse_arguments(ARG "" "" "SOURCES;ALONE;DEPENDS;LIBRARIES" ${ARGN})
  add_library(gaussgen_${folder} STATIC ${ARG_SOURCES})
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  add_library(gaussgen::${folder} ALIAS gaussgen_${folder})
  target_include_directories(gaussgen_${folder} PUBLIC ${PROJECT_SOURCE_DIR}/generator)
  target_link_libraries(gaussgen_${folder} PRIVATE gauss_warnings)
  foreach(dependency IN LISTS ARG_DEPENDS)
    target_link_libraries(gaussgen_${folder} PUBLIC gaussgen_${dependency})
  endforeach()
  target_link_libraries(gaussgen_${folder} PUBLIC ${ARG_LIBRARIES})
endfunction()
