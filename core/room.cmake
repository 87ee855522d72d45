# SPDX-License-Identifier: MIT
# Headers of the standard library, compiled once for all targets with the same flags. A source still includes all that
# it uses; `make torture` builds without precompiled headers.
set(STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numeric>
                     <optional> <ostream> <set> <span> <string> <string_view> <utility> <vector>)

# share_headers(TARGET OWNER): lets a target use the precompiled headers of the owner, which may be itself.
function(share_headers target owner)
    if(target STREQUAL owner)
        target_precompile_headers(${target} PRIVATE ${STANDARD_HEADERS})
    else()
        target_precompile_headers(${target} REUSE_FROM ${owner})
    endif()
endfunction()

# room(NAME [DEPENDS room …]): one folder of core/ or scripting/ as a static library under the compiler contract;
# main.cpp is left out, which makes an executable of it.
function(room name)
    cmake_parse_arguments(ROOM "" "" "DEPENDS" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC contract ${ROOM_DEPENDS})
    if(name IN_LIST QUICK_ROOMS)
        quick(${name})
    else()
        share_headers(${name} base)
    endif()
endfunction()

# quick(TARGET): in a release compiled with little optimisation, for what computes little.
function(quick target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    share_headers(${target} storage)
endfunction()
