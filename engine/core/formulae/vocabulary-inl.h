// SPDX-License-Identifier: MIT
// No include guard: real.h and real-inl.h include this inside their namespaces, after they have
// defined Real, Bool, Int, Uint, their operators, and select, min, max, abs, floor, sqrt on Real.
// What is here follows from those: GLSL's other functions on Real, and vectors of Real.

FORMULAE_INLINE Real clamp(Real x, Real lowest, Real highest) {
    return min(max(x, lowest), highest);
}
FORMULAE_INLINE Real fract(Real x) {
    return x - floor(x);
}
FORMULAE_INLINE Real mix(Real a, Real b, Real t) {
    return a * (1.0f - t) + b * t;
}
FORMULAE_INLINE Real step(Real edge, Real x) {
    return select(x < edge, Real(0.0f), Real(1.0f));
}
FORMULAE_INLINE Real smoothstep(Real edge0, Real edge1, Real x) {
    const Real t = clamp((x - edge0) / (edge1 - edge0), Real(0.0f), Real(1.0f));
    return t * t * (3.0f - 2.0f * t);
}
FORMULAE_INLINE Real inversesqrt(Real x) {
    return 1.0f / sqrt(x);
}

struct Real2 {
    Real x, y;
    Real2() = default;
    FORMULAE_INLINE explicit Real2(Real all) : x(all), y(all) {}
    FORMULAE_INLINE Real2(Real in_x, Real in_y) : x(in_x), y(in_y) {}
};

struct Real3 {
    Real x, y, z;
    Real3() = default;
    FORMULAE_INLINE explicit Real3(Real all) : x(all), y(all), z(all) {}
    FORMULAE_INLINE Real3(Real in_x, Real in_y, Real in_z) : x(in_x), y(in_y), z(in_z) {}
    FORMULAE_INLINE Real3(Real2 xy, Real in_z) : x(xy.x), y(xy.y), z(in_z) {}
};

struct Real4 {
    Real x, y, z, w;
    Real4() = default;
    FORMULAE_INLINE explicit Real4(Real all) : x(all), y(all), z(all), w(all) {}
    FORMULAE_INLINE Real4(Real in_x, Real in_y, Real in_z, Real in_w)
        : x(in_x), y(in_y), z(in_z), w(in_w) {}
    FORMULAE_INLINE Real4(Real3 xyz, Real in_w) : x(xyz.x), y(xyz.y), z(xyz.z), w(in_w) {}
};

// Operators of vectors, component by component, as in GLSL.
#define FORMULAE_VECTOR_OPERATOR(OP)                                  \
    FORMULAE_INLINE Real2 operator OP(Real2 a, Real2 b) {             \
        return Real2(a.x OP b.x, a.y OP b.y);                         \
    }                                                                 \
    FORMULAE_INLINE Real3 operator OP(Real3 a, Real3 b) {             \
        return Real3(a.x OP b.x, a.y OP b.y, a.z OP b.z);             \
    }                                                                 \
    FORMULAE_INLINE Real4 operator OP(Real4 a, Real4 b) {             \
        return Real4(a.x OP b.x, a.y OP b.y, a.z OP b.z, a.w OP b.w); \
    }                                                                 \
    FORMULAE_INLINE Real2 operator OP(Real2 a, Real b) {              \
        return a OP Real2(b);                                         \
    }                                                                 \
    FORMULAE_INLINE Real3 operator OP(Real3 a, Real b) {              \
        return a OP Real3(b);                                         \
    }                                                                 \
    FORMULAE_INLINE Real4 operator OP(Real4 a, Real b) {              \
        return a OP Real4(b);                                         \
    }                                                                 \
    FORMULAE_INLINE Real2 operator OP(Real a, Real2 b) {              \
        return Real2(a) OP b;                                         \
    }                                                                 \
    FORMULAE_INLINE Real3 operator OP(Real a, Real3 b) {              \
        return Real3(a) OP b;                                         \
    }                                                                 \
    FORMULAE_INLINE Real4 operator OP(Real a, Real4 b) {              \
        return Real4(a) OP b;                                         \
    }
FORMULAE_VECTOR_OPERATOR(+)
FORMULAE_VECTOR_OPERATOR(-)
FORMULAE_VECTOR_OPERATOR(*)
FORMULAE_VECTOR_OPERATOR(/)
#undef FORMULAE_VECTOR_OPERATOR

FORMULAE_INLINE Real2 operator-(Real2 a) {
    return Real2(-a.x, -a.y);
}
FORMULAE_INLINE Real3 operator-(Real3 a) {
    return Real3(-a.x, -a.y, -a.z);
}
FORMULAE_INLINE Real4 operator-(Real4 a) {
    return Real4(-a.x, -a.y, -a.z, -a.w);
}

// Functions of vectors, component by component, as in GLSL.
#define FORMULAE_VECTOR_FUNCTION_1(NAME)                          \
    FORMULAE_INLINE Real2 NAME(Real2 a) {                         \
        return Real2(NAME(a.x), NAME(a.y));                       \
    }                                                             \
    FORMULAE_INLINE Real3 NAME(Real3 a) {                         \
        return Real3(NAME(a.x), NAME(a.y), NAME(a.z));            \
    }                                                             \
    FORMULAE_INLINE Real4 NAME(Real4 a) {                         \
        return Real4(NAME(a.x), NAME(a.y), NAME(a.z), NAME(a.w)); \
    }
FORMULAE_VECTOR_FUNCTION_1(abs)
FORMULAE_VECTOR_FUNCTION_1(floor)
FORMULAE_VECTOR_FUNCTION_1(fract)
FORMULAE_VECTOR_FUNCTION_1(sqrt)
#undef FORMULAE_VECTOR_FUNCTION_1

#define FORMULAE_VECTOR_FUNCTION_2(NAME)                                              \
    FORMULAE_INLINE Real2 NAME(Real2 a, Real2 b) {                                    \
        return Real2(NAME(a.x, b.x), NAME(a.y, b.y));                                 \
    }                                                                                 \
    FORMULAE_INLINE Real3 NAME(Real3 a, Real3 b) {                                    \
        return Real3(NAME(a.x, b.x), NAME(a.y, b.y), NAME(a.z, b.z));                 \
    }                                                                                 \
    FORMULAE_INLINE Real4 NAME(Real4 a, Real4 b) {                                    \
        return Real4(NAME(a.x, b.x), NAME(a.y, b.y), NAME(a.z, b.z), NAME(a.w, b.w)); \
    }                                                                                 \
    FORMULAE_INLINE Real2 NAME(Real2 a, Real b) {                                     \
        return NAME(a, Real2(b));                                                     \
    }                                                                                 \
    FORMULAE_INLINE Real3 NAME(Real3 a, Real b) {                                     \
        return NAME(a, Real3(b));                                                     \
    }                                                                                 \
    FORMULAE_INLINE Real4 NAME(Real4 a, Real b) {                                     \
        return NAME(a, Real4(b));                                                     \
    }
FORMULAE_VECTOR_FUNCTION_2(min)
FORMULAE_VECTOR_FUNCTION_2(max)
#undef FORMULAE_VECTOR_FUNCTION_2

#define FORMULAE_VECTOR_FUNCTIONS(VECTOR)                               \
    FORMULAE_INLINE VECTOR clamp(VECTOR x, Real lowest, Real highest) { \
        return min(max(x, lowest), highest);                            \
    }                                                                   \
    FORMULAE_INLINE VECTOR mix(VECTOR a, VECTOR b, VECTOR t) {          \
        return a * (1.0f - t) + b * t;                                  \
    }                                                                   \
    FORMULAE_INLINE VECTOR mix(VECTOR a, VECTOR b, Real t) {            \
        return a * (1.0f - t) + b * t;                                  \
    }
FORMULAE_VECTOR_FUNCTIONS(Real2)
FORMULAE_VECTOR_FUNCTIONS(Real3)
FORMULAE_VECTOR_FUNCTIONS(Real4)
#undef FORMULAE_VECTOR_FUNCTIONS

FORMULAE_INLINE Real2 select(Bool condition, Real2 a, Real2 b) {
    return Real2(select(condition, a.x, b.x), select(condition, a.y, b.y));
}
FORMULAE_INLINE Real3 select(Bool condition, Real3 a, Real3 b) {
    return Real3(select(condition, a.x, b.x), select(condition, a.y, b.y),
                 select(condition, a.z, b.z));
}
FORMULAE_INLINE Real4 select(Bool condition, Real4 a, Real4 b) {
    return Real4(select(condition, a.x, b.x), select(condition, a.y, b.y),
                 select(condition, a.z, b.z), select(condition, a.w, b.w));
}

FORMULAE_INLINE Real dot(Real2 a, Real2 b) {
    return a.x * b.x + a.y * b.y;
}
FORMULAE_INLINE Real dot(Real3 a, Real3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
FORMULAE_INLINE Real dot(Real4 a, Real4 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
FORMULAE_INLINE Real3 cross(Real3 a, Real3 b) {
    return Real3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
FORMULAE_INLINE Real length(Real2 a) {
    return sqrt(dot(a, a));
}
FORMULAE_INLINE Real length(Real3 a) {
    return sqrt(dot(a, a));
}
FORMULAE_INLINE Real3 normalize(Real3 a) {
    return a * inversesqrt(dot(a, a));
}
FORMULAE_INLINE Real3 reflect(Real3 incident, Real3 normal) {
    return incident - 2.0f * dot(normal, incident) * normal;
}
