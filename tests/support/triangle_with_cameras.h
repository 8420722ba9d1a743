// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace patina::tests {

/// A .gltf: a triangle in the plane z = 0, seen from both sides, with two cameras: "Close", 45
/// degrees, at z = 3, and "Side", orthographic, 3 m high, at x = 3. Both look at the origin.
inline constexpr std::string_view kTriangleWithCameras = R"({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
"nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3]},
          {"camera": 1, "name": "Side", "translation": [3, 0, 0],
           "rotation": [0, 0.70710678, 0, 0.70710678]}],
"cameras": [{"type": "perspective", "name": "Close",
             "perspective": {"yfov": 0.785398163, "znear": 0.1}},
            {"type": "orthographic",
             "orthographic": {"xmag": 1, "ymag": 1.5, "znear": 0.1, "zfar": 10}}],
"materials": [{"doubleSided": true}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
               "min": [-1, -1, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri":
    "data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAAAAAAAAgD8AAAAA"}]
})";

}  // namespace patina::tests
