// SPDX-License-Identifier: MIT
#pragma once

/// How glTF is to state each slot of a material: the bake rules.

#include "composite/operations.h"
#include "composite/stack_terms.h"
#include "document/material.h"

namespace patina {

/// A slot of constants is factors; one whose channels are one untouched image, as glTF can state
/// it, keeps that image; any other is baked. `program` is the one that the terms were emitted to.
std::array<SlotPlan, kSlotCount> planned_slots(const Material& material, const StackTerms& terms,
                                               const ProgramData& program);

}  // namespace patina
