// SPDX-License-Identifier: MIT
#pragma once

/// Small movable owners of OpenGL 4.1 objects, each made from a description and labelled at birth.
/// One idea: what a pass needs is stated whole, as values (Pass, State), so nothing is restored.
/// The OpenGL names stay in this folder. Everything here runs on the thread whose context is
/// current (HeadlessContext or a window's), and an object must be destroyed while its context is
/// current. May include core only; used by render.

#include <cstdint>
#include <string_view>
#include <utility>

namespace patina::gl {

/// What KHR_debug calls the kind of an object.
enum class ObjectKind { Buffer, Framebuffer, Program, Query, Sampler, Texture, VertexArray };

/// The name of one OpenGL object, owned: deleted with it, moved and never copied. 0 owns nothing.
class Object {
  public:
    Object() = default;
    /// Takes over a name just made by glGen... and bound once, and labels it where the context has
    /// KHR_debug.
    Object(ObjectKind kind, std::uint32_t name, std::string_view label);
    ~Object();
    Object(Object&& other) noexcept
        : kind_(other.kind_), name_(std::exchange(other.name_, std::uint32_t{0})) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(kind_, other.kind_);
        std::swap(name_, other.name_);
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    /// For engine/gl alone.
    std::uint32_t name() const { return name_; }

  private:
    ObjectKind kind_ = ObjectKind::Texture;
    std::uint32_t name_ = 0;
};

}  // namespace patina::gl
