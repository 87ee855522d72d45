# SPDX-License-Identifier: MIT
# room(NAME [DEPENDS room …]): one folder of core/ as a static library under the compiler contract.
function(room name)
    cmake_parse_arguments(ROOM "" "" "DEPENDS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC contract ${ROOM_DEPENDS})
endfunction()
