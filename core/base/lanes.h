// SPDX-License-Identifier: MIT
// Numbers side by side: `width` floats or doubles on which one instruction works at once, so that a law written as a
// template on its number type serves one number and many. The only file with vector extensions and intrinsics. Every
// operation rounds each lane as IEEE 754 says (no reciprocal estimates, no fused multiply-add), so a lane's result does
// not depend on the width. The types are internal to each file that includes this: files built for different
// instruction sets share no code through the linker.
#pragma once

#include "base/portable.h"

#include <utility>

#if defined(__x86_64__) && !defined(__CUDACC__)
#define PLANULA_X86_LANES
#include <immintrin.h>
#endif

namespace planula {

namespace {

// Vectors of the compiler; of one lane plain numbers.
template <class Number, int width> struct VectorOf {
    typedef Number Type __attribute__((vector_size(sizeof(Number) * width)));
};
template <class Number> struct VectorOf<Number, 1> { using Type = Number; };

// What the compilers' vectors do not offer, or not in one instruction. Of two numbers that do not compare the second is
// greater and less: as in std::max(second, first) and std::min.
PORTABLE inline float root_of(float a) { return __builtin_sqrtf(a); }
PORTABLE inline float greater_of(float a, float b) { return a > b ? a : b; }
PORTABLE inline float lesser_of(float a, float b) { return a < b ? a : b; }
PORTABLE inline double root_of(double a) { return __builtin_sqrt(a); }
PORTABLE inline double greater_of(double a, double b) { return a > b ? a : b; }
PORTABLE inline double lesser_of(double a, double b) { return a < b ? a : b; }
#if defined(PLANULA_X86_LANES)
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

#if defined(__AVX512DQ__)
inline unsigned signs_of(__m512 a) { return _mm512_movepi32_mask((__m512i)a); }
inline unsigned signs_of(__m512d a) { return _mm512_movepi64_mask((__m512i)a); }
// With a mask of all lanes, since GCC 12 warns of what is uninitialized in its plain ones.
inline __m512 root_of(__m512 a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
inline __m512 greater_of(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
inline __m512 lesser_of(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }
inline __m512d root_of(__m512d a) { return _mm512_maskz_sqrt_pd(0xff, a); }
inline __m512d greater_of(__m512d a, __m512d b) { return _mm512_maskz_max_pd(0xff, a, b); }
inline __m512d lesser_of(__m512d a, __m512d b) { return _mm512_maskz_min_pd(0xff, a, b); }
#endif

/// `width` numbers: 1, or as many as the instruction set that this file is built for holds.
template <class Number_, int width_> struct LanesOf {
    static constexpr int width = width_;
    using Number = Number_;
    using Vector = typename VectorOf<Number, width>::Type;
    using Mask = decltype(Vector{} < Vector{}); // per lane, all bits set where true; of one lane bool

    LanesOf() = default;
    PORTABLE LanesOf(double all) : value(static_cast<Number>(all) - Vector{}) {}
    PORTABLE static LanesOf of(Vector value) {
        LanesOf result;
        result.value = value;
        return result;
    }

    PORTABLE friend LanesOf operator+(LanesOf a, LanesOf b) { return of(a.value + b.value); }
    PORTABLE friend LanesOf operator-(LanesOf a, LanesOf b) { return of(a.value - b.value); }
    PORTABLE friend LanesOf operator*(LanesOf a, LanesOf b) { return of(a.value * b.value); }
    PORTABLE friend LanesOf operator/(LanesOf a, LanesOf b) { return of(a.value / b.value); }
    PORTABLE friend LanesOf operator-(LanesOf a) { return of(-a.value); }
    PORTABLE friend Mask operator<(LanesOf a, LanesOf b) { return a.value < b.value; }
    PORTABLE friend Mask operator<=(LanesOf a, LanesOf b) { return a.value <= b.value; }

    PORTABLE friend LanesOf select(Mask mask, LanesOf yes, LanesOf no) {
        return of(mask ? yes.value : no.value);
    }
    PORTABLE friend LanesOf max(LanesOf a, LanesOf b) { return of(greater_of(b.value, a.value)); }
    PORTABLE friend LanesOf min(LanesOf a, LanesOf b) { return of(lesser_of(b.value, a.value)); }
    PORTABLE friend LanesOf sqrt(LanesOf a) { return of(root_of(a.value)); }
    PORTABLE friend LanesOf abs(LanesOf a) { return copysign(a, LanesOf(0)); }
    PORTABLE friend LanesOf copysign(LanesOf size, LanesOf sign) {
        if constexpr (width == 1) {
            return of(static_cast<Number>(__builtin_copysign(size.value, sign.value)));
        } else {
            const Mask sign_bit = (Mask)-Vector{};
            return of((Vector)(((Mask)size.value & ~sign_bit) | ((Mask)sign.value & sign_bit)));
        }
    }
    /// 2^k for whole numbers k, -1022 <= k <= 1023; doubles only.
    PORTABLE friend LanesOf power_of_two(LanesOf k) {
        static_assert(sizeof(Number) == 8);
        // Added to 1.5 · 2^52, k + 1023 is in the lowest bits; the exponent is 52 higher.
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

/// The number of doubles of a vector on every processor that this file is built for.
#if defined(__SSE2__)
constexpr int baseline_doubles = 2;
#else
constexpr int baseline_doubles = 1;
#endif

/// Four floats to a record, side by side in four numbers: a field each.
template <class T> struct Fields { T a, b, c, d; };

/// `T::width` consecutive numbers.
template <class T> PORTABLE T load(const typename T::Number *from) {
    if constexpr (T::width == 1) return T::of(*from);
    T result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
template <class T> PORTABLE void store(T value, typename T::Number *to) {
    if constexpr (T::width == 1)
        *to = value.value;
    else
        __builtin_memcpy(to, &value, sizeof value);
}

/// `T::width` numbers number_at(0), number_at(1), ….
template <class T, class NumberAt> T load_each(const NumberAt &number_at) {
    typename T::Number numbers[T::width];
    for (int lane = 0; lane < T::width; ++lane) numbers[lane] = number_at(lane);
    return load<T>(numbers);
}

/// The lanes in which a condition holds: bit i for lane i.
template <class T> PORTABLE unsigned bits_of(typename T::Mask mask) {
    if constexpr (T::width == 1)
        return mask;
    else
        return signs_of((typename T::Vector)mask);
}

/// Whether a condition holds in some lane, or in every one.
template <class T> PORTABLE bool any_of(typename T::Mask mask) { return bits_of<T>(mask) != 0; }
template <class T> PORTABLE bool all_of(typename T::Mask mask) {
    return bits_of<T>(mask) == (1u << T::width) - 1;
}

/// The least number of all lanes.
template <class T> PORTABLE typename T::Number least_of(T lanes) {
    typename T::Number numbers[T::width];
    store(lanes, numbers);
    for (const auto number : numbers)
        if (number < numbers[0]) numbers[0] = number;
    return numbers[0];
}

// Vectors as blocks of four floats.
template <class Vector> using LaneNumbers = std::make_integer_sequence<int, sizeof(Vector) / sizeof(float)>;

#if !defined(__CUDACC__) // which has single lanes only
/// In each block the i-th and j-th of `one`, then the k-th and l-th of `two`.
template <int i, int j, int k, int l, class Vector, int... lane>
Vector within_blocks(Vector one, Vector two, std::integer_sequence<int, lane...>) {
    constexpr int picked[] = {i, j, sizeof...(lane) + k, sizeof...(lane) + l};
    return __builtin_shufflevector(one, two, (lane / 4 * 4 + picked[lane % 4])...);
}
#endif
template <int i, int j, int k, int l, class Vector> Vector within_blocks(Vector one, Vector two) {
    return within_blocks<i, j, k, l>(one, two, LaneNumbers<Vector>{});
}

/// The blocks to every fourth block from there on.
#if defined(PLANULA_X86_LANES)
inline void store_blocks(__m128 blocks, float *to) { _mm_storeu_ps(to, blocks); }
#endif
#if defined(__AVX__)
inline void store_blocks(__m256 blocks, float *to) { _mm256_storeu2_m128(to + 16, to, blocks); }
#endif
#if defined(__AVX512DQ__)
inline void store_blocks(__m512 blocks, float *to) {
    store_blocks(__builtin_shufflevector(blocks, blocks, 0, 1, 2, 3, 4, 5, 6, 7), to);
    store_blocks(__builtin_shufflevector(blocks, blocks, 8, 9, 10, 11, 12, 13, 14, 15), to + 32);
}
#endif

/// Rows to columns, in each block.
template <class T, class Floats = typename T::Vector>
Fields<T> transposed(Floats r0, Floats r1, Floats r2, Floats r3) {
    const Floats ab01 = within_blocks<0, 1, 0, 1>(r0, r1), cd01 = within_blocks<2, 3, 2, 3>(r0, r1);
    const Floats ab23 = within_blocks<0, 1, 0, 1>(r2, r3), cd23 = within_blocks<2, 3, 2, 3>(r2, r3);
    return {T::of(within_blocks<0, 2, 0, 2>(ab01, ab23)), T::of(within_blocks<1, 3, 1, 3>(ab01, ab23)),
            T::of(within_blocks<0, 2, 0, 2>(cd01, cd23)), T::of(within_blocks<1, 3, 1, 3>(cd01, cd23))};
}

#if defined(__CUDA_ARCH__)
// Records lie at multiples of 16 bytes there, and move as a whole.
template <class T> __device__ Fields<T> load_record(const float *from) {
    const float4 r = *reinterpret_cast<const float4 *>(from);
    return {T::of(r.x), T::of(r.y), T::of(r.z), T::of(r.w)};
}
template <class T> __device__ void store_record(const Fields<T> &fields, float *to) {
    *reinterpret_cast<float4 *>(to) = {fields.a.value, fields.b.value, fields.c.value, fields.d.value};
}
#else
template <class T> Fields<T> load_record(const float *from) {
    return {T::of(from[0]), T::of(from[1]), T::of(from[2]), T::of(from[3])};
}
template <class T> void store_record(const Fields<T> &fields, float *to) {
    to[0] = fields.a.value, to[1] = fields.b.value, to[2] = fields.c.value, to[3] = fields.d.value;
}
#endif

/// The four fields of `T::width` records, which are at record_at(0), record_at(1), ….
template <class T, class RecordAt> PORTABLE inline Fields<T> load_fields(const RecordAt &record_at) {
    if constexpr (T::width == 1) {
        return load_record<T>(record_at(0));
    }
    if constexpr (T::width == 4) {
        const auto row = [&](int i) { return load<T>(record_at(i)).value; };
        return transposed<T>(row(0), row(1), row(2), row(3));
    }
#if defined(__AVX512DQ__)
    if constexpr (T::width == 16) {
        const auto rows = [&](int i) {
            const __m256 low = _mm256_loadu2_m128(record_at(i + 4), record_at(i));
            const __m512 three =
                _mm512_insertf32x4(_mm512_castps256_ps512(low), _mm_loadu_ps(record_at(i + 8)), 2);
            return _mm512_insertf32x4(three, _mm_loadu_ps(record_at(i + 12)), 3);
        };
        return transposed<T>(rows(0), rows(1), rows(2), rows(3));
    }
#endif
#if defined(__AVX__)
    if constexpr (T::width == 8) {
        const auto rows = [&](int i) { return _mm256_loadu2_m128(record_at(i + 4), record_at(i)); };
        return transposed<T>(rows(0), rows(1), rows(2), rows(3));
    }
#endif
}

/// The four fields of `T::width` consecutive records.
template <class T> PORTABLE inline Fields<T> load_fields(const float *from) {
#if defined(__AVX512DQ__)
    if constexpr (T::width == 16) {
        // Transposed in place, they are in turn in every fourth lane.
        const auto rows = transposed<T>(load<T>(from).value, load<T>(from + 16).value,
                                        load<T>(from + 32).value, load<T>(from + 48).value);
        const __m512i order = _mm512_setr_epi32(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
        const auto ordered = [&](T lanes) {
            return T::of(_mm512_maskz_permutexvar_ps(0xffff, order, lanes.value));
        };
        return {ordered(rows.a), ordered(rows.b), ordered(rows.c), ordered(rows.d)};
    }
#endif
    return load_fields<T>([&](int lane) { return from + 4 * lane; });
}

/// Writes the fields of `T::width` records to consecutive records.
template <class T> PORTABLE void store_fields(const Fields<T> &fields, float *to) {
    if constexpr (T::width == 1) {
        store_record(fields, to);
    } else {
        const auto [r0, r1, r2, r3] =
            transposed<T>(fields.a.value, fields.b.value, fields.c.value, fields.d.value);
        // Each holds a record in each of its blocks, four apart.
        store_blocks(r0.value, to), store_blocks(r1.value, to + 4);
        store_blocks(r2.value, to + 8), store_blocks(r3.value, to + 12);
    }
}

} // namespace

} // namespace planula
