// SPDX-License-Identifier: MIT
// Numbers side by side: `width` floats or doubles on which one instruction works at once, so that a law written as
// a template on its number type serves one number and many. The only file with vector extensions and
// intrinsics. Every operation rounds each lane as IEEE 754 says (no reciprocal estimates, no fused
// multiply-add), so a lane's result does not depend on the width. The types are internal to each file that
// includes this: files built for different instruction sets share no code through the linker.
#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace planula {

namespace {

// Vectors of the compiler; of one lane plain numbers.
template <class Number, int width> struct VectorOf {
    typedef Number Type __attribute__((vector_size(sizeof(Number) * width)));
};
template <class Number> struct VectorOf<Number, 1> { using Type = Number; };

// What the compilers' vectors do not offer, or not in one instruction. Of two numbers that do not compare the
// second is greater and less: as in std::max(second, first) and std::min.
inline float root_of(float a) { return __builtin_sqrtf(a); }
inline float greater_of(float a, float b) { return a > b ? a : b; }
inline float lesser_of(float a, float b) { return a < b ? a : b; }
inline double root_of(double a) { return __builtin_sqrt(a); }
inline double greater_of(double a, double b) { return a > b ? a : b; }
inline double lesser_of(double a, double b) { return a < b ? a : b; }
#if defined(__x86_64__)
inline unsigned signs_of(__m128 a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }
inline unsigned signs_of(__m128d a) { return static_cast<unsigned>(_mm_movemask_pd(a)); }
inline __m128 root_of(__m128 a) { return _mm_sqrt_ps(a); }
inline __m128 greater_of(__m128 a, __m128 b) { return _mm_max_ps(a, b); }
inline __m128 lesser_of(__m128 a, __m128 b) { return _mm_min_ps(a, b); }
inline __m128d root_of(__m128d a) { return _mm_sqrt_pd(a); }
inline __m128d greater_of(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
inline __m128d lesser_of(__m128d a, __m128d b) { return _mm_min_pd(a, b); }
#endif
#if defined(__AVX__)
inline unsigned signs_of(__m256 a) { return static_cast<unsigned>(_mm256_movemask_ps(a)); }
inline unsigned signs_of(__m256d a) { return static_cast<unsigned>(_mm256_movemask_pd(a)); }
inline __m256 root_of(__m256 a) { return _mm256_sqrt_ps(a); }
inline __m256 greater_of(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
inline __m256 lesser_of(__m256 a, __m256 b) { return _mm256_min_ps(a, b); }
inline __m256d root_of(__m256d a) { return _mm256_sqrt_pd(a); }
inline __m256d greater_of(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
inline __m256d lesser_of(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
#endif

/// `width` numbers: 1, or as many as the instruction set that this file is built for holds.
template <class Number_, int width_> struct LanesOf {
    static constexpr int width = width_;
    using Number = Number_;
    using Vector = typename VectorOf<Number, width>::Type;
    using Mask = decltype(Vector{} < Vector{}); // per lane, all bits set where true; of one lane bool

    LanesOf() = default;
    LanesOf(double all) : value(static_cast<Number>(all) - Vector{}) {}
    static LanesOf of(Vector value) {
        LanesOf result;
        result.value = value;
        return result;
    }

    friend LanesOf operator+(LanesOf a, LanesOf b) { return of(a.value + b.value); }
    friend LanesOf operator-(LanesOf a, LanesOf b) { return of(a.value - b.value); }
    friend LanesOf operator*(LanesOf a, LanesOf b) { return of(a.value * b.value); }
    friend LanesOf operator/(LanesOf a, LanesOf b) { return of(a.value / b.value); }
    friend LanesOf operator-(LanesOf a) { return of(-a.value); }
    friend Mask operator<(LanesOf a, LanesOf b) { return a.value < b.value; }
    friend Mask operator<=(LanesOf a, LanesOf b) { return a.value <= b.value; }

    friend LanesOf select(Mask mask, LanesOf yes, LanesOf no) { return of(mask ? yes.value : no.value); }
    friend LanesOf max(LanesOf a, LanesOf b) { return of(greater_of(b.value, a.value)); }
    friend LanesOf min(LanesOf a, LanesOf b) { return of(lesser_of(b.value, a.value)); }
    friend LanesOf sqrt(LanesOf a) { return of(root_of(a.value)); }
    friend LanesOf abs(LanesOf a) { return copysign(a, LanesOf(0)); }
    friend LanesOf copysign(LanesOf size, LanesOf sign) {
        if constexpr (width == 1) {
            return of(static_cast<Number>(__builtin_copysign(size.value, sign.value)));
        } else {
            const Mask sign_bit = (Mask)-Vector{};
            return of((Vector)(((Mask)size.value & ~sign_bit) | ((Mask)sign.value & sign_bit)));
        }
    }
    /// 2^k for whole numbers k, -1022 <= k <= 1023; doubles only.
    friend LanesOf power_of_two(LanesOf k) {
        static_assert(sizeof(Number) == 8);
        // Added to 1.5 · 2^52, k + 1023 stands in the lowest bits; the exponent is 52 higher.
        const Vector shifted = k.value + (Number(0x1.8p52) + Number(1023) - Vector{});
        if constexpr (width == 1)
            return of(__builtin_bit_cast(Number, __builtin_bit_cast(unsigned long long, shifted) << 52));
        else
            return of((Vector)((Mask)shifted << 52));
    }

    Vector value;
};

/// Floats and doubles.
template <int width> using Lanes = LanesOf<float, width>;
template <int width> using DoubleLanes = LanesOf<double, width>;

/// How many doubles lie side by side on every processor that this file is built for.
#if defined(__SSE2__)
constexpr int baseline_doubles = 2;
#else
constexpr int baseline_doubles = 1;
#endif

/// Four floats to a record, side by side in four numbers: a field each.
template <class T> struct Fields { T a, b, c, d; };

/// `T::width` numbers that lie one after another.
template <class T> T load(const typename T::Number *from) {
    T result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
template <class T> void store(T value, typename T::Number *to) { __builtin_memcpy(to, &value, sizeof value); }

/// `T::width` numbers number_at(0), number_at(1), ….
template <class T, class NumberAt> T load_each(const NumberAt &number_at) {
    typename T::Number numbers[T::width];
    for (int lane = 0; lane < T::width; ++lane) numbers[lane] = number_at(lane);
    return load<T>(numbers);
}

/// The lanes in which a condition holds: bit i for lane i.
template <class T> unsigned bits_of(typename T::Mask mask) {
    if constexpr (T::width == 1)
        return mask;
    else
        return signs_of((typename T::Vector)mask);
}

/// Whether a condition holds in every lane.
template <class T> bool all_of(typename T::Mask mask) { return bits_of<T>(mask) == (1u << T::width) - 1; }

/// The least number of all lanes.
template <class T> typename T::Number least_of(T lanes) {
    typename T::Number numbers[T::width];
    store(lanes, numbers);
    for (const auto number : numbers)
        if (number < numbers[0]) numbers[0] = number;
    return numbers[0];
}

/// Rows to columns, in each block of four lanes.
template <class T, class Floats = typename T::Vector>
Fields<T> transposed(Floats r0, Floats r1, Floats r2, Floats r3) {
    if constexpr (T::width == 4) {
        const Floats ab01 = __builtin_shufflevector(r0, r1, 0, 4, 1, 5);
        const Floats cd01 = __builtin_shufflevector(r0, r1, 2, 6, 3, 7);
        const Floats ab23 = __builtin_shufflevector(r2, r3, 0, 4, 1, 5);
        const Floats cd23 = __builtin_shufflevector(r2, r3, 2, 6, 3, 7);
        return {T::of(__builtin_shufflevector(ab01, ab23, 0, 1, 4, 5)),
                T::of(__builtin_shufflevector(ab01, ab23, 2, 3, 6, 7)),
                T::of(__builtin_shufflevector(cd01, cd23, 0, 1, 4, 5)),
                T::of(__builtin_shufflevector(cd01, cd23, 2, 3, 6, 7))};
    } else {
        const Floats ab01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
        const Floats cd01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
        const Floats ab23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
        const Floats cd23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
        return {T::of(__builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13)),
                T::of(__builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15)),
                T::of(__builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13)),
                T::of(__builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15))};
    }
}

/// The four fields of `T::width` records, which lie at record_at(0), record_at(1), ….
template <class T, class RecordAt> inline Fields<T> load_fields(const RecordAt &record_at) {
    if constexpr (T::width == 1) {
        const float *r = record_at(0);
        return {T::of(r[0]), T::of(r[1]), T::of(r[2]), T::of(r[3])};
    }
    if constexpr (T::width == 4) {
        const auto row = [&](int i) { return load<T>(record_at(i)).value; };
        return transposed<T>(row(0), row(1), row(2), row(3));
    }
#if defined(__AVX__)
    if constexpr (T::width == 8) {
        const auto rows = [&](int i) { return _mm256_loadu2_m128(record_at(i + 4), record_at(i)); };
        return transposed<T>(rows(0), rows(1), rows(2), rows(3));
    }
#endif
}

/// The fields of `T::width` records to records that lie one after another.
template <class T> void store_fields(const Fields<T> &fields, float *to) {
    if constexpr (T::width == 1) {
        to[0] = fields.a.value, to[1] = fields.b.value, to[2] = fields.c.value, to[3] = fields.d.value;
    } else {
        const auto [r0, r1, r2, r3] =
            transposed<T>(fields.a.value, fields.b.value, fields.c.value, fields.d.value);
        if constexpr (T::width == 4) {
            store(r0, to), store(r1, to + 4), store(r2, to + 8), store(r3, to + 12);
        } else {
            // Each holds two records, four apart.
            const auto join = [](T one, T two) {
                return T::of(__builtin_shufflevector(one.value, two.value, 0, 1, 2, 3, 8, 9, 10, 11));
            };
            const auto rest = [](T one, T two) {
                return T::of(__builtin_shufflevector(one.value, two.value, 4, 5, 6, 7, 12, 13, 14, 15));
            };
            store(join(r0, r1), to), store(join(r2, r3), to + 8);
            store(rest(r0, r1), to + 16), store(rest(r2, r3), to + 24);
        }
    }
}

} // namespace

} // namespace planula
