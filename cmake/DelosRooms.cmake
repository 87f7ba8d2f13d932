# delos_build_by_room(<target> <base> [MOST <n>] <sources>...): compile the sources of each
# folder under <base> as one unit, since reading headers is most of what a small source
# costs. Folders of more than <n> sources (40) make several units: GCC slows down where one
# unit names many types of Eigen.
function(delos_build_by_room target base)
  cmake_parse_arguments(arg "" "MOST" "" ${ARGN})
  if(NOT arg_MOST)
    set(arg_MOST 40)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${DELOS_BY_ROOM} UNITY_BUILD_MODE GROUP)
  foreach(source ${arg_UNPARSED_ARGUMENTS})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${base} OUTPUT_VARIABLE room)
    string(MAKE_C_IDENTIFIER "${room}" room)
    math(EXPR count_${room} "0${count_${room}} + 1")
    math(EXPR part "(${count_${room}} - 1) / ${arg_MOST} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${part})
  endforeach()
endfunction()

# delos_build_as_one(<target>): compile all sources of <target> as one unit, where folders
# are small beside the headers that they share.
function(delos_build_as_one target)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${DELOS_BY_ROOM} UNITY_BUILD_MODE BATCH UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# delos_compile_lightly(<target>): for what runs once a scene and not once a sample, where
# optimising takes longer than it will ever save.
function(delos_compile_lightly target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-Og>)
endfunction()
