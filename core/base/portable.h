// SPDX-License-Identifier: MIT
// PORTABLE stands before a function that also runs on graphics processors. Their compiler (nvcc) makes it for both
// kinds of processor; every other compiler reads nothing there.
#pragma once

#if defined(__CUDACC__)
#define PORTABLE __host__ __device__
#else
#define PORTABLE
#endif
