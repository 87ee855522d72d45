# SPDX-License-Identifier: MIT
# Graphics processors, as an option: the one source that nvcc compiles, which then belongs to the room `device`.
option(PLANULA_GPU "bodies may move on NVIDIA's graphics processors (planula run --device gpu)" OFF)
set(PLANULA_GPU_ARCH sm_90 CACHE STRING "nvcc's -arch: the oldest generation of graphics processors to build for, 80 or later")
find_program(NVCC nvcc PATHS /usr/local/cuda/bin)

# Arithmetic as everywhere: no contraction, exact divisions and roots, subnormal numbers.
set(NVCC_FLAGS -std=c++20 -O3 -fmad=false -prec-div=true -prec-sqrt=true -ftz=false --expt-relaxed-constexpr
               --Werror cross-execution-space-call -I${PROJECT_SOURCE_DIR}/core)

if(PLANULA_GPU)
    if(NOT NVCC)
        message(FATAL_ERROR "PLANULA_GPU needs CUDA's compiler nvcc, which is neither in PATH nor in /usr/local/cuda/bin")
    endif()
    cmake_path(GET NVCC PARENT_PATH nvcc_folder)
    find_library(CUDA_RUNTIME cudart_static HINTS ${nvcc_folder}/../lib64 ${nvcc_folder}/../lib REQUIRED)
    set(runner ${CMAKE_CURRENT_SOURCE_DIR}/device/cuda/cuda_runner.cu)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/cuda_runner.o)
    add_custom_command(
        OUTPUT ${object}
        COMMAND ${NVCC} ${NVCC_FLAGS} -arch=${PLANULA_GPU_ARCH} -Xcompiler=-ffp-contract=off,-fno-math-errno
                -MD -MF ${object}.d -MT ${object} -c -o ${object} ${runner}
        DEPENDS ${runner}
        DEPFILE ${object}.d
        COMMENT "Compiling for graphics processors" VERBATIM)
    target_sources(device PRIVATE ${object})
    target_link_libraries(device PRIVATE ${CUDA_RUNTIME} Threads::Threads ${CMAKE_DL_LIBS} rt)
    set_source_files_properties(device/no_gpu.cpp PROPERTIES COMPILE_DEFINITIONS PLANULA_GPU)
endif()
