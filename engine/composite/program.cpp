// SPDX-License-Identifier: MIT
#include "composite/program.h"

#include "composite/compile.h"
#include "document/worn_surface.h"

namespace patina {

Program Program::compile(const Material& material, const UvSurfacePtr& surface) {
    Program program;
    program.data_ = std::make_shared<const ProgramData>(
        compile_material(material, surface, CoveredLayers::Drop));
    return program;
}

Program Program::compile(const Document& document, const Material& material) {
    return compile(material, surface_read(document, material));
}

Hash128 Program::slot_hash(Slot slot) const {
    return data_->slot_hashes[static_cast<std::size_t>(slot)];
}

const std::array<SlotPlan, kSlotCount>& Program::slots() const& {
    return data_->slots;
}

const std::vector<Hash128>& Program::images() const& {
    return data_->images;
}

}  // namespace patina
