// SPDX-License-Identifier: MIT
// Elementary functions with the same bits on every compiler, CPU and C library: additions, multiplications, divisions
// and bit operations of IEEE doubles alone. libm's own differ between CPUs (they use FMA where there is one). Errors
// stay within a few units in the last place unless said otherwise; NaN in gives NaN out.
#pragma once

namespace planula::math {

inline constexpr double pi = 3.14159265358979323846;

/// |x| beyond 2^20 is first reduced by the double nearest 2π: repeatable there, but not accurate. ±inf: NaN.
double sin(double x);
double cos(double x);
double exp(double x);
/// log(0) = -inf; NaN below 0.
double log(double x);
double tanh(double x);
double atan(double x);
double atan2(double y, double x);
/// Relative error below 1e-13, for the p-values of statistics.
double erfc(double x);
/// Exact products for integer |y| <= 1024, else exp(y log x) with relative error about 1e-16 (1 + |y log x|).
double pow(double x, double y);

} // namespace planula::math
