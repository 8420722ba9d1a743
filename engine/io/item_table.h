// SPDX-License-Identifier: MIT
#pragma once

/// One of the arrays of a glTF file that a save adds to (textures, images, samplers, bufferViews).
/// Patina's own items stand last; those that nothing needs any more give their places to new ones,
/// so that saving again and again does not make the file grow.

#include <vector>

#include "io/gltf_json.h"

namespace patina::io {

class ItemTable {
  public:
    /// @param items  the array in the file, as opened
    /// @param own    for each item whether Patina put it there; only the last ones, after which
    ///               no other item comes, count
    ItemTable(Json& items, const std::vector<bool>& own);

    int add(Json item);
    Json& operator[](int index) { return (*items_)[static_cast<std::size_t>(index)]; }
    int size() const { return static_cast<int>(items_->size()); }

    /// Whether the item was in the file as one of Patina's own, and may be dropped or moved.
    bool is_own(int index) const { return index >= first_own_ && index < first_new_; }
    bool is_new(int index) const { return index >= first_new_; }
    /// Items that are not Patina's are always kept; of the others only those named here.
    void keep(int index);
    bool is_kept(int index) const;

    /// Drops what was not kept and closes the gaps: new items go into them first, in their order,
    /// then the last ones. Returns where each item went, -1 for those that were dropped.
    std::vector<int> compact();

  private:
    Json* items_;
    int first_own_ = 0;
    int first_new_ = 0;
    std::vector<bool> kept_;
};

}  // namespace patina::io
