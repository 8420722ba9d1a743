// SPDX-License-Identifier: MIT
#pragma once

/// A stack compiled: a flat array of small operation records and the list of images they read. The
/// same program is run by the CPU compositor, by `explain` and later by the GPU.

#include <array>
#include <memory>
#include <vector>

#include "composite/maps.h"
#include "document/document.h"
#include "scene/uv_surface.h"

namespace patina {

struct ProgramData;  // operation records: composite/operations.h

/// Immutable and cheap to copy. What the accessors refer to lives as long as a copy of the program:
/// they refuse to be asked of a temporary.
class Program {
  public:
    /// Compiles the visible layers of a material. Layers, channels and entries that cannot change
    /// the result (hidden, opacity 0, mask 0) leave no trace, so equal pictures have equal hashes.
    /// @param surface  what it lies on, for layers that read the model; null: no mesh is at hand
    static Program compile(const Material& material, const UvSurfacePtr& surface = nullptr);
    /// As it lies on the parts of the document that wear it.
    static Program compile(const Document& document, const Material& material);

    /// Hash of all that decides the texels of one slot (not of the resolution): equal hashes, equal
    /// texels. An edit elsewhere leaves a slot's hash alone.
    Hash128 slot_hash(Slot slot) const;
    /// How glTF is to state each slot: a constant or an untouched image wherever that says the
    /// same, else a baked map.
    const std::array<SlotPlan, kSlotCount>& slots() const&;
    const std::array<SlotPlan, kSlotCount>& slots() const&& = delete;
    /// Images that running the program reads, each once.
    const std::vector<Hash128>& images() const&;
    const std::vector<Hash128>& images() const&& = delete;
    const ProgramData& data() const& { return *data_; }
    const ProgramData& data() const&& = delete;

  private:
    std::shared_ptr<const ProgramData> data_;
};

}  // namespace patina
