// SPDX-License-Identifier: MIT
#pragma once

/// Layers as JSON: the part that records, presets and the clipboard have in common.
///
/// A constant is a number (grey, of a colour) or an array of three; an image or a procedural is an
/// object with a "kind". A channel stands in "channels" when it says anything, and is on when it
/// stands there unless it says otherwise. All that is as in a new layer is left out.

#include <set>
#include <string>

#include "document/json_reader.h"
#include "document/stack_tree.h"

namespace patina {

/// Records keep ids; presets, which get new ones wherever they are laid on, leave them out but for
/// those of layers that others refer to.
enum class JsonIds { Kept, LeftOut };

Json layers_to_json(const LayerList& layers, JsonIds ids);

/// Reads the array at `pointer`. Ids that are missing are 0 in the result, repeated ones stay: see
/// with_unique_ids. Empty when there was a fault.
LayerList layers_from_json(const Json& array, const std::string& pointer, JsonFaults& faults);

/// Ids that have been given and the next one to give.
struct IssuedIds {
    std::set<std::uint64_t> taken;
    std::uint64_t next = 1;
};
/// The largest id in the layers, their children and entries; 0 when there is none.
std::uint64_t largest_id(const LayerList& layers);
/// The layers with new ids wherever one is 0 or taken. Layers that need none keep their nodes.
LayerList with_unique_ids(const LayerList& layers, IssuedIds& issued);

}  // namespace patina
