# delos_build_by_room(<target> <base> <sources>...): compile the sources of one folder as
# one unit, since reading headers is most of what a small source costs. A folder of more
# than `most` sources makes several units: two cores have something to share, and GCC slows
# down where one unit names many types of Eigen.
function(delos_build_by_room target base)
  set(most 6)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${DELOS_BY_ROOM} UNITY_BUILD_MODE GROUP)
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${base} OUTPUT_VARIABLE room)
    string(MAKE_C_IDENTIFIER "${room}" room)
    math(EXPR count_${room} "0${count_${room}} + 1")
    math(EXPR part "(${count_${room}} - 1) / ${most} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${part})
  endforeach()
endfunction()
