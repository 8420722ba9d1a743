// SPDX-License-Identifier: MIT
// The GLSL side of the vocabulary that lets the files of this folder be GLSL and C++ at once; the
// loader of gl::Program puts it in front of every shader. engine/core/formulae/formulae.h says what
// the vocabulary is and what the texts keep to.

#define Real float
#define Real2 vec2
#define Real3 vec3
#define Real4 vec4
#define Bool bool
#define Int int
#define Uint uint

float select(bool condition, float if_true, float if_false) {
    return condition ? if_true : if_false;
}
vec2 select(bool condition, vec2 if_true, vec2 if_false) {
    return condition ? if_true : if_false;
}
vec3 select(bool condition, vec3 if_true, vec3 if_false) {
    return condition ? if_true : if_false;
}
vec4 select(bool condition, vec4 if_true, vec4 if_false) {
    return condition ? if_true : if_false;
}
int select(bool condition, int if_true, int if_false) {
    return condition ? if_true : if_false;
}
uint select(bool condition, uint if_true, uint if_false) {
    return condition ? if_true : if_false;
}

// Whether it holds anywhere among the values that are computed together: to leave out work that
// would change nothing.
bool any_lane(bool condition) {
    return condition;
}
