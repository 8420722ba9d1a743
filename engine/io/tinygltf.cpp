// SPDX-License-Identifier: MIT
// tinygltf itself, compiled once. What it may do on its own is decided in engine/CMakeLists.txt: no
// file system, no images.
#include <fstream>  // which its own file system would have brought

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
